// Sums of functions of one input each: what is one, and where its terms turn.
#include "topology/field/separable.h"

#include <cmath>
#include <numbers>
#include <random>

#include "topology/field/motion.h"
#include "topology/moving.h"

namespace isomotion::topology {
namespace {

using formula::Graph;
using formula::Interval;
using formula::NodeId;

Motion motion_of(const std::string& formula, const std::string& parameters = "T = \"t\"",
                 const std::string& rest = "") {
    const Moving moving{formula, "{ box = [[-2, -2, -2], [2, 2, 2]] }", parameters, rest};
    return motions(moving.scene(), Side::negative, {0, 1}, Clock::time).pieces.front();
}

std::optional<std::vector<NodeId>> terms_of(Motion& motion) {
    return separated(motion.graph, motion.field, clock_input + 1);
}

double value(const Motion& motion, NodeId root, const std::array<double, 4>& inputs) {
    const formula::Program program = formula::schedule(motion.graph, std::array{root});
    double value = 0;
    formula::Evaluator<double>(program).point(motion.bindings, inputs, {&value, 1});
    return value;
}

// Where a function of x turns.
std::optional<std::vector<Root>> turns_of(const std::string& formula, Interval span = {-2, 2}) {
    Motion motion = motion_of(formula + " + T");
    const auto terms = terms_of(motion);
    if (!terms) return std::nullopt;
    const auto bindings = formula::convert<Interval>(motion.bindings);
    Term term(motion.graph, terms->front(), 0, bindings);
    return stationary_points(term, span);
}

TEST(Separated, TermsAddUpToTheFormula) {
    std::mt19937_64 random(20'261'127);
    std::uniform_real_distribution<double> anywhere(-2, 2);
    for (const char* formula :
         {"x^2 + y^4 - z + T", "3*(x - 2*(sin(y) - T*2)) - (T - z)*0.7", "0.5 - x*T0 + exp(y)/2",
          "sum(b, w*(x - w)^2) + y*T0*2 + T", "-(x^3 - (y - (z - T)))", "4 + T - 2*z"}) {
        Motion motion =
            motion_of(std::string(formula) + " + T + T0 + sum(b, w)/1000",
                      "T = \"sin(t)\"\nT0 = 0.3", "[arrays.b]\ncount = 3\nw = [1, 2, 3]");
        const auto terms = terms_of(motion);
        ASSERT_TRUE(terms) << formula;
        for (int sample = 0; sample < 50; ++sample) {
            std::array<double, 4> at{anywhere(random), anywhere(random), anywhere(random),
                                     anywhere(random)};
            double sum = 0;
            for (std::size_t k = 0; k < terms->size(); ++k) {
                std::array<double, 4> alone{NAN, NAN, NAN, NAN}; // of no use to this term
                alone[k] = at[k];
                sum += value(motion, (*terms)[k], alone);
            }
            EXPECT_NEAR(sum, value(motion, motion.field, at), 1e-9) << formula;
        }
    }
}

TEST(Separated, IsNothingElse) {
    for (const char* formula : {"x*y + T", "(x + y)^2 + T", "sin(x - T)", "max(x, y) + T",
                                "(x + y)/(3 + 0.1*T)", "x^2 + T*y", "exp(x + y) + T"}) {
        Motion motion = motion_of(formula);
        EXPECT_FALSE(terms_of(motion)) << formula;
    }
}

TEST(StationaryPoints, OfChebyshevPolynomialsAreWhereTheyAreExtreme) {
    for (const int degree : {2, 5, 22, 50}) {
        const auto turns = turns_of(fmt::format("chebyshev({}, x)", degree), {-1.1, 1.1});
        ASSERT_TRUE(turns);
        ASSERT_EQ(turns->size(), std::size_t(degree - 1));
        for (int k = 1; k < degree; ++k) {
            const Root& turn = (*turns)[std::size_t(degree - 1 - k)];
            const double at = std::cos(std::numbers::pi * k / degree);
            EXPECT_NEAR(mid(turn.where), at, 1e-14);
            EXPECT_LT(width(turn.where), 1e-13);
            EXPECT_TRUE(contains(turn.alone, turn.where));
        }
    }
}

TEST(StationaryPoints, OfRandomPolynomialsAreAllFound) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> anywhere(-1.9, 1.9);
        std::vector<double> roots(1 + seed % 5);
        for (double& root : roots) root = std::round(anywhere(random) * 64) / 64;
        std::ranges::sort(roots);
        if (std::ranges::adjacent_find(roots) != roots.end()) continue;
        // The coefficients of the product of x - root, and of what has it as slope: exact.
        std::vector<double> slope{1};
        for (const double root : roots) {
            slope.insert(slope.begin(), 0);
            for (std::size_t k = 0; k + 1 < slope.size(); ++k) slope[k] -= root * slope[k + 1];
        }
        std::string formula = "0";
        for (std::size_t k = 0; k < slope.size(); ++k)
            formula += fmt::format(" + ({:.17g})*x^{}/{}", slope[k], k + 1, k + 1);
        const auto turns = turns_of(formula);
        ASSERT_TRUE(turns) << formula << ", seed " << seed;
        ASSERT_EQ(turns->size(), roots.size()) << formula << ", seed " << seed;
        for (std::size_t k = 0; k < roots.size(); ++k)
            EXPECT_NEAR(mid((*turns)[k].where), roots[k], 1e-9) << "seed " << seed;
    }
}

// An inflection, a kink, a jump, a pole, a function that rests, and one that turns at an end.
TEST(StationaryPoints, AreNotToldWhereTheyAreNotSimple) {
    for (const char* formula : {"x^3", "abs(x)", "floor(x)", "1/x", "max(x, 0.5)", "x^4",
                                "sqrt(x - 1)", "log(x)", "x^3 - 0.3*x^2*0"}) {
        EXPECT_FALSE(turns_of(formula)) << formula;
    }
    // Kinks and jumps that turn nothing are none.
    for (const char* formula : {"x + abs(x)/2", "x^3 + x"}) {
        const auto turns = turns_of(formula);
        ASSERT_TRUE(turns) << formula;
        EXPECT_TRUE(turns->empty()) << formula;
    }
}

TEST(Zeros, AreThoseForEachOfTheConstants) {
    Motion motion = motion_of("T + x", "T = \"t^3 - t\"");
    const auto terms = terms_of(motion);
    ASSERT_TRUE(terms);
    const auto bindings = formula::convert<Interval>(motion.bindings);
    Term term(motion.graph, terms->at(clock_input), clock_input, bindings);
    const auto found = zeros(term, {0.24, 0.26}, {-2, 2});
    ASSERT_TRUE(found);
    ASSERT_EQ(found->size(), 3U);
    for (const Root& root : *found) {
        for (const double c : {0.24, 0.25, 0.26}) {
            double x = mid(root.where);
            for (int k = 0; k < 40; ++k) x -= (x * x * x - x + c) / (3 * x * x - 1);
            EXPECT_TRUE(contains(root.where, x));
        }
    }
    // At the turn of t^3 - t there is none, one or two of them.
    const double turn = 2 / (3 * std::sqrt(3));
    EXPECT_FALSE(zeros(term, {turn - 1e-3, turn + 1e-3}, {0, 2}));
}

} // namespace
} // namespace isomotion::topology
