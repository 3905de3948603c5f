// Motions made at random: what a timeline proves is what frames drawn at any time show.
//
// Frames are certified from the values that they are drawn with, Animation::at(), which knows
// nothing of rules and their knots.
#include <gtest/gtest.h>

#include "thorough.h"
#include "topology/analyse.h"
#include "topology/betti/certified_frame.h"
#include "topology/chance.h"
#include "topology/scenes.h"
#include "topology/timeline/steps.h"

namespace isomotion::topology {
namespace {

class RandomMotion : public Chance {
public:
    using Chance::Chance;

    std::string one_of(std::initializer_list<const char*> texts) {
        return texts.begin()[below(int(texts.size()))];
    }

    // A value between about -1 and 1, as TOML.
    std::string track() {
        if (below(3) == 0) return keys();
        const bool steps = below(8) == 0;
        const std::string of_time =
            steps ? one_of({"0.4*floor({:.2f}*t)", "0.3*sign(t - {:.2f})",
                            "random(floor({:.2f}*t), 2)"})
                  : one_of({"sin({:.2f}*t)", "min(t - 1, {:.2f} - 1.5)", "max({:.2f} - t, -0.4)",
                            "abs(t - {:.2f}) - 1", "sqrt(t*{:.2f}) - 1", "atan(4*(t - {:.2f}))",
                            "min(max(t - 1, -0.5), 0.2*{:.2f})", "smoothmin(t - {:.2f}, 0.3, 0.4)",
                            "tan(0.4*t) - 0.5*{:.2f}", "0.2/(t - 3.5) + 0.3*{:.2f}"});
        return fmt::format("\"{}\"", fmt::format(fmt::runtime(of_time), number(0.5, 2)));
    }

    // Elements that come, go and change rows, with ids or without.
    std::string table() {
        const bool with_ids = below(4) > 0, stay = below(2) == 0;
        // Most change in one way at most, and how many there are seldom.
        const int changes = below(6);
        std::string rows = with_ids ? "t,px,id\n" : "t,px\n";
        std::array<double, 4> places{-1.8, -0.6, 0.6, 1.8};
        std::vector<int> now{0, 2, 3};
        for (int time = 0; time < 4; ++time) {
            if (changes < 3) std::ranges::rotate(now, now.begin() + below(int(now.size())));
            if (changes == 0 && below(3) == 0) now = {below(2), 2 + below(2)};
            for (const int id : now) {
                if (!stay) places[std::size_t(id)] += number(-0.5, 0.5);
                rows += fmt::format("{},{:.3f}", time, places[std::size_t(id)]);
                rows += with_ids ? fmt::format(",{}\n", id) : "\n";
            }
        }
        return rows;
    }

    std::string scene() {
        const bool counts_only = below(4) == 0;
        const std::string field =
            one_of({"0.9*px", "0.6*px + 0.7*i", "px + 0.4*p", "px*(0.4 + 0.25*n)", "1.1*i - 0.8",
                    "px + 0.8*random(i, 3)", "px + 0.3*sin(2*t + i)", "0.9*px + floor(i/2)"});
        const std::string weight = one_of({"1", "0.9", "\"0.8 + 0.1*i\"", "\"0.6 + 0.15*n\"",
                                           "\"0.8 + 0.3*random(i, 1)\"", "\"1 + 0.1*p\""});
        const std::string formula =
            counts_only ? "x^4 - 2*x^2 + y^2 + z^2 - 1.3 + 0.3*c + 0*p + 0.5*sum(b, w)"
                        : "0.5 + 0.1*c + 0*p - sum(b, w*exp(-3*((x - u)^2 + y^2 + z^2)))";
        return fmt::format(
            "[time]\nframes = 31\nfps = 10\n[surface]\nformula = \"{}\"\nbounds = {}\n"
            "[parameters]\np = {}\nc = {}\n[arrays.b]\nfile = \"table.csv\"\n"
            "interpolation = \"{}\"\nw = {}\n{}",
            formula, one_of({"{ sphere = 7 }", "{ box = [[-7, -3, -3], [7, 3.1, 3.2]] }"}), keys(),
            track(), one_of({"linear", "linear", "linear", "hold"}), weight,
            counts_only ? "" : fmt::format("u = \"{}\"\n", field));
    }

private:
    std::string keys() {
        std::string text;
        double time = number(-0.5, 1), value = number(-1, 1);
        for (int k = 0; k < 4; ++k, time += number(0.2, 1.2)) {
            if (below(3) > 0) value = number(-1, 1); // else it rests
            text += fmt::format("{}[{:.2f}, {:.3f}]", k > 0 ? ", " : "", time, value);
        }
        return fmt::format(
            "{{ keys = [{}], ease = \"{}\" }}", text,
            one_of({"linear", "smooth", "smooth", "cubic", "linear", "cubic", "hold"}));
    }
};

// True if anything was compared.
bool expect_frames_of(const Timeline& timeline, const scene::Scene& scene, RandomMotion& random) {
    const Side solid = solid_side(scene);
    bool compared = false;
    for (const Step& step : steps_of(timeline).steps) {
        if (!step.is_proved || !step.solid || !(step.time.lo < step.time.hi)) continue;
        for (int k = 0; k < 4; ++k) {
            const double time = random.number(step.time.lo, step.time.hi);
            const StillScene drawn(scene, time);
            const auto frame = certify_frame(drawn.formula(solid), drawn.bounds, {.depth = 8});
            if (!frame.betti) continue;
            compared = true;
            EXPECT_EQ(*frame.betti, *step.solid) << "at " << time << " s";
        }
    }
    return compared;
}

TEST(RandomMotions, AreProvedAsTheyAreDrawn) {
    const unsigned first_seed = 1, motions = unsigned(trials(24, 60));
    int compared = 0, complete = 0;
    for (unsigned seed = first_seed; seed < first_seed + motions; ++seed) {
        RandomMotion random(seed);
        const std::string table = random.table(), text = random.scene();
        SCOPED_TRACE(fmt::format("seed {}\n{}table.csv:\n{}", seed, text, table));
        const scene::Scene scene = scene_of(text, table);
        const Timeline timeline = analyse(scene);
        complete += timeline.is_complete();
        compared += expect_frames_of(timeline, scene, random);
    }
    EXPECT_GT(compared, trials(8, 30));
    EXPECT_GT(complete, trials(2, 7));
}

} // namespace
} // namespace isomotion::topology
