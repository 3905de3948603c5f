// Strangers' formulas that move: what a timeline proves is what signs on fine grids count, which
// know nothing of intervals.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <ctime>
#include <random>

#include <gtest/gtest.h>

#include "topology/analyse.h"
#include "topology/betti/frame_signs.h"
#include "topology/scenes.h"
#include "topology/timeline/steps.h"
#include "unit/formula/stranger_formula.h"

namespace isomotion::topology {
namespace {

std::string scene_text(unsigned seed) {
    std::mt19937 random(seed);
    static constexpr const char* tracks[]{"0.4*t - 0.5",
                                          "sin(3*t)",
                                          "max(min(tan(t), 2), -2)",
                                          "abs(t - 0.9) - 0.3",
                                          "0.5*floor(2*t)",
                                          "exp(-t) - 0.4",
                                          "sqrt(t) - 0.7",
                                          "atan(9*(t - 1))",
                                          "0.3/(t + 0.2)",
                                          "smoothmin(t, 1, 0.2)",
                                          "sign(t - 1)*0.4",
                                          "cos(5*t)*0.2",
                                          "0.1/(t - 1.03)",
                                          "2^(-t)",
                                          "log(t + 0.1)",
                                          "tanh(4*t - 3)",
                                          "random(floor(t), 1)"};
    const std::string formula = formula::StrangerFormula(seed).text(int(random() % 3));
    static constexpr const char* moves[]{"{} + 0.7*c", "{} - c*x", "({})*(1 + 0.3*c)",
                                         "min({}, (x - c)^2 + y^2 + z^2 - 0.2)"};
    return fmt::format("[time]\nframes = 21\nfps = 10\n[surface]\nformula = \"{}\"\nbounds = {{ {} "
                       "}}\n[parameters]\nc = \"{}\"\n",
                       fmt::format(fmt::runtime(moves[random() % 4]), formula),
                       random() % 2 == 0 ? "sphere = 1.5"
                                         : "box = [[-1.03, -1.2, -1.1], [1.31, 1.04, 1]]",
                       tracks[random() % std::size(tracks)]);
}

Betti counted(const scene::Scene& scene, const StillScene& still, Side solid, int side) {
    return betti(frame_signs(*scene.surfaces[0].field, still.numbers, still.bounds, solid, side));
}

// The scene with another level of F.
std::string shifted(std::string text, double by) {
    constexpr std::string_view key = "formula = \"";
    const std::size_t begin = text.find(key) + key.size();
    text.insert(text.find('"', begin), fmt::format(") + {}", by));
    return text.insert(begin, "(");
}

// Whether a grid can be told to count what there is: as much of solids that are a little thicker
// and thinner. Parts and gaps thinner than its cells are lost on it.
bool is_counted_firmly(const std::string& text, double time, Side solid, int side,
                       const Betti& found) {
    return std::ranges::all_of(std::array{-0.05, 0.05}, [&](double by) {
        const scene::Scene other = scene_of(shifted(text, by));
        return counted(other, StillScene(other, time), solid, side) == found;
    });
}

// True if anything was compared. Two grids must agree before a third is asked, and that must agree
// with them firmly.
bool expect_counts_of(const Timeline& timeline, const scene::Scene& scene, const std::string& text,
                      std::mt19937& random) {
    const Side solid = solid_side(scene);
    bool compared = false;
    for (const Step& step : steps_of(timeline).steps) {
        // Right after a birth parts are smaller than any cell.
        if (!step.is_proved || !step.solid || !(step.time.hi - step.time.lo > 0.05)) continue;
        for (int k = 0; k < 2; ++k) {
            const double part = 0.3 + 0.4 * double(random() % 1000) / 1000;
            const double time = step.time.lo + part * (step.time.hi - step.time.lo);
            const StillScene still(scene, time);
            compared = true;
            const Betti coarse = counted(scene, still, solid, 41);
            if (coarse == *step.solid) continue;
            const Betti fine = counted(scene, still, solid, 90);
            if (fine != coarse) continue;
            if (counted(scene, still, solid, 163) != fine) continue;
            EXPECT_FALSE(is_counted_firmly(text, time, solid, 163, fine))
                << "grids contradict " << testing::PrintToString(*step.solid) << " at " << time
                << " s: " << testing::PrintToString(fine);
        }
    }
    return compared;
}

// A search stops after so many seconds of processor time, whatever else the machine does, and its
// result then says less.
void attack(unsigned scenes, double seconds) {
    const char* given = std::getenv("ISOMOTION_SEED");
    const unsigned first = given ? unsigned(std::strtoul(given, nullptr, 10)) : 22;
    int compared = 0, complete = 0, refused = 0;
    for (unsigned seed = first; seed < first + scenes && !testing::Test::HasFailure(); ++seed) {
        const std::string text = scene_text(seed);
        SCOPED_TRACE(fmt::format("seed {} (ISOMOTION_SEED)\n{}", seed, text));
        std::optional<scene::Scene> scene;
        try {
            scene = scene_of(text);
        } catch (const base::InputError&) {
            ++refused; // values without a number
            continue;
        }
        const std::clock_t end = std::clock() + std::clock_t(seconds * CLOCKS_PER_SEC);
        AnalyseOptions how;
        how.stop = [&] { return std::clock() > end; };
        const Timeline timeline = analyse(*scene, how);
        complete += timeline.is_complete();
        std::mt19937 random(seed);
        compared += expect_counts_of(timeline, *scene, text, random);
    }
    fmt::print("{} scenes, {} refused, {} compared, {} complete\n", scenes, refused, compared,
               complete);
    EXPECT_GT(compared, int(scenes) / 20);
}

TEST(RandomFormulas, AreProvedAsGridsCount) { attack(15, 0.5); }
TEST(RandomFormulasExhaustive, AreProvedAsGridsCount) { attack(1000, 2); }

} // namespace
} // namespace isomotion::topology
