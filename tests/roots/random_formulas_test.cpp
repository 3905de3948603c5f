// Truth of strangers' formulas against 4,000 samples of each ray in double: what it calls certain
// must be so, across poles, jumps and kinks, and where F has no value.
#include <cstdlib>
#include <random>

#include "formula/graph/continuity.h"
#include "formula/graph/lowering.h"
#include "unit/formula/stranger_formula.h"
#include "view.h"

namespace isomotion::roots::random_formulas_test {
namespace {

constexpr int side = 10, samples = 4000;

// F along the middle of a tube.
class MiddleRay {
public:
    MiddleRay(formula::Evaluator<double>& field, const formula::Bindings<double>& bindings,
              const Tube& tube)
        : field_(field)
        , bindings_(bindings)
        , tube_(tube) {}

    double at(double t) const {
        const glm::dvec3 p = tube_.anchor + t * tube_.direction;
        const std::array point{p.x, p.y, p.z};
        double f = 0;
        field_.point(bindings_, point, {&f, 1});
        return f;
    }

    // Where F changes its sign and is 0: it falls towards 0 as the two sides close in, as it does
    // neither at jumps nor at poles.
    std::optional<double> root_between(double a, double b) const {
        double f = at(a), g = at(b);
        if (!(f * g < 0)) return std::nullopt;
        const double size = std::min(std::abs(f), std::abs(g));
        for (int k = 0; k < 80; ++k) {
            const double middle = a + (b - a) / 2, h = at(middle);
            if (!(a < middle && middle < b)) break;
            if (std::isnan(h)) return std::nullopt;
            ((h < 0) == (f < 0) ? a : b) = middle;
            ((h < 0) == (f < 0) ? f : g) = h;
        }
        const bool closes = std::max(std::abs(f), std::abs(g)) <= 1e-6 * size;
        return closes ? std::optional(a) : std::nullopt;
    }

    std::vector<double> roots() const {
        std::vector<double> found;
        const double h = (tube_.far - tube_.near) / samples;
        for (int k = 0; k < samples; ++k) {
            if (const auto root = root_between(tube_.near + k * h, tube_.near + (k + 1) * h))
                found.push_back(*root);
        }
        return found;
    }

private:
    formula::Evaluator<double>& field_;
    const formula::Bindings<double>& bindings_;
    const Tube& tube_;
};

std::string scene_text(const std::string& formula, std::mt19937& random) {
    const auto number = [&] { return double(int(random() % 400) - 200) / 100; };
    return fmt::format("[surface]\nformula = \"{}\"\nbounds = {{ {} }}\n[camera]\nposition = [{}, "
                       "{}, {}]\n{}",
                       formula,
                       random() % 2 == 0 ? "sphere = 1.5" : "box = [[-1, -1.2, -1], [1.3, 1, 1]]",
                       3 + number() / 2, number(), number(),
                       random() % 4 == 0 ? "projection = \"orthographic\"\nheight = 3\n" : "");
}

std::array<int, 4> attack(unsigned seed) {
    std::mt19937 random(seed);
    const std::string formula = formula::StrangerFormula(seed).text();
    SCOPED_TRACE(testing::Message() << formula << ", seed " << seed << " (ISOMOTION_SEED)");
    const View view(scene_of(scene_text(formula, random)), side, side, {.evaluations = 2000});
    const formula::Field& field = *view.scene.surfaces[0].field;
    formula::Graph graph = field.graph;
    // Where a part of F has no value there is no surface, whatever min and max make of it.
    const formula::Program program =
        formula::schedule_lowered(graph, formula::with_gaps(graph, field.root));
    formula::Evaluator<double> evaluator(program);
    const auto bindings = formula::convert<double>(view.now.surfaces[0].bindings);
    std::array<int, 4> answers{};
    for (std::size_t k = 0; k < view.tubes.size(); ++k) {
        const Tube& tube = view.tubes[k];
        const FirstRoot& root = view.roots[k];
        ++answers[std::size_t(root.answer)];
        if (!(tube.near <= tube.far)) continue;
        const MiddleRay ray(evaluator, bindings, tube);
        std::vector<double> zeros = ray.roots();
        // Two roots may lie between samples. The certain one is looked for by itself.
        if (root.answer == Answer::hit || root.after_is_hit) {
            const auto certain = ray.root_between(double(root.low), double(root.high));
            const bool is_thin = double(root.high) - double(root.low) < 1e-5;
            EXPECT_TRUE(certain || !is_thin || std::abs(ray.at(double(root.low))) < 1e-9)
                << "no root in " << testing::PrintToString(root);
            if (certain)
                zeros.push_back(*certain);
            else
                zeros.push_back(0.5 * (double(root.low) + double(root.high)));
            std::ranges::sort(zeros);
        }
        EXPECT_TRUE(holds(root, tube, zeros, 4 * tube.radius + 1e-9));
        if (testing::Test::HasFailure()) break;
    }
    return answers;
}

void attack_all(int formulas) {
    const char* given = std::getenv("ISOMOTION_SEED");
    const unsigned first = given ? unsigned(std::strtoul(given, nullptr, 10)) : 22;
    std::array<int, 4> all{};
    int refused = 0;
    for (int k = 0; k < formulas && !testing::Test::HasFailure(); ++k) {
        try {
            const auto answers = attack(first + unsigned(k));
            for (std::size_t a = 0; a < all.size(); ++a) all[a] += answers[a];
        } catch (const base::InputError&) {
            ++refused; // constants without a value
        }
    }
    fmt::print("{} formulas, {} refused: {} miss, {} hit, {} touching, {} undecided\n", formulas,
               refused, all[0], all[1], all[2], all[3]);
    EXPECT_LT(refused, formulas / 4);
    EXPECT_GT(all[0] + all[1], (all[2] + all[3]) / 2) << "most rays are certain";
}

TEST(RandomFormulas, HaveNoRootThatTruthDenies) { attack_all(12); }
TEST(RandomFormulasExhaustive, HaveNoRootThatTruthDenies) { attack_all(3000); }

} // namespace
} // namespace isomotion::roots::random_formulas_test
