#include "formula/graph/power_sums.h"

#include <algorithm>

#include "formula/enclosure.h"
#include "formula/field.h"
#include "formula/graph/operations.h"
#include "formula/hessian.h"
#include "in_range.h"

namespace isomotion::formula {
namespace {

// m as numbers divide by it, if m^degree is multiplied.
std::string cut_off(const std::string& most, double degree) {
    const double end = std::pow(double(Operations<float>::saturation()), 1 / degree);
    return fmt::format("min({}, max(1e-18, {}))", end, most);
}

TEST(PowerSums, AreTakenFromTheLargestBase) {
    const auto expect = [&](const std::string& text, const std::string& m, const char* wanted) {
        expect_in_range(text, fmt::format(fmt::runtime(wanted), m));
    };
    const std::string of_two = "max(abs(x), abs(y))";
    expect("(x^20 + y^20)^(1/20)", cut_off(of_two, 1), "{0}*((x/{0})^20 + (y/{0})^20)^(1/20)");
    expect("(3*x^24 + y^24/2)^(1/12)", cut_off(of_two, 2),
           "{0}^2*(3*(x/{0})^24 + 0.5*(y/{0})^24)^(1/12)");
    expect("(1 + x^20)^0.1", cut_off("max(abs(x), 1)", 2), "{0}^2*((x/{0})^20 + (1/{0})^20)^0.1");
}

// Exponents that are no inverse of each other would cost one more power, terms below 0 may cancel,
// and what is not steep stays in range as it is.
TEST(PowerSums, KeepWhatNeedsNoScale) {
    for (const char* text :
         {"(x^4 + y^4)^(1/4)", "(x^60 - y^60)^(1/60)", "(x^60 + y^58)^(1/60)", "x^60 + y^60 - 1",
          "(x^60 + y^60)^0.6", "(x^60 + y^60)^0.2", "(abs(x)^a + abs(y)^a)^b",
          "(abs(x)^a + abs(y)^b)^(1/a)", "(x^a + y^a)^(1/a)", "(x^60 + y^60 - 1)^(1/60)",
          "(x^17 + y^17)^(1/17)", "sum(blobs, (x^60 + cx^60)^(1/60))",
          "sum(blobs, (x - cx)^60)^(1/60)", "(x^60 + 0*y + a)^(1/60)",
          "(((((((x^24)^24)^24)^24)^24)^24)^24)^0.1"})
        expect_in_range(text, text);
}

TEST(PowerSums, AreEqualOnPaper) {
    for (const char* text :
         {"(x^20 + y^20 + z^20)^(1/20) - 1", "(2*x^16 + 3*abs(y)^16 + 0.5)^(1/16)*z",
          "(abs(x)^(2/c) + abs(y)^(2/c))^(c/2)", "(abs(x)^17 + abs(x - y)^17)^(1/34)",
          "(abs(x)^16.5 + ((abs(y)^20 + abs(z)^20)^(1/20))^16.5)^(1/16.5)",
          "log(exp((x^20 + y^20)^(1/20)) + exp(z))", "(abs(x)^m + 1)^(1/m)",
          "(3*(0.1*x^30 + y^30/7))^(1/30)"})
        expect_equal_on_paper(text);
}

// 0.1^60 is 0 in float32, and 5^60 is no number.
TEST(PowerSums, HoldInFloats) {
    for (const char* text :
         {"(x^60 + y^60)^(1/60)", "(abs(x)^200 + abs(y)^200)^(1/200)",
          "(abs(x)^1e10 + abs(y)^1e10)^1e-10", "(abs(x)^a + abs(y)^a)^(1/a)",
          "(abs(x)^60.5 + abs(y)^60.5)^(1/60.5)", "(x^80 + y^80 + 0.01^80)^(1/80)"}) {
        SCOPED_TRACE(text);
        Vocabulary vocabulary;
        vocabulary.parameters = {"a"};
        const Field norm = make_field(text, vocabulary);
        Bindings<float> bindings;
        bindings.parameters = {150};
        FieldEvaluator<float> evaluator(norm);
        for (const float x : {-1.4f, -0.1f, 1e-6f, 0.02f, 1.0f}) {
            for (const float y : {-1.2f, -0.11f, 3e-2f, 0.9f, 5.0f, -3e4f}) {
                SCOPED_TRACE(fmt::format("({}, {})", x, y));
                const float larger = std::max(std::abs(x), std::abs(y));
                EXPECT_NEAR(evaluator.value(bindings, {x, y, 0}), larger, 0.012f * larger);
                // Euler's identity of functions of degree 1.
                const auto slope = evaluator.gradient(bindings, {x, y, 0});
                EXPECT_NEAR(x * slope[0] + y * slope[1], larger, 0.012f * larger);
            }
        }
        EXPECT_NEAR(evaluator.value(bindings, {0, 0, 0}), 0, 0.011f);
    }
}

// The smaller base counts where the exponent is below 0.
TEST(PowerSums, HoldForExponentsBelow0) {
    Vocabulary vocabulary;
    vocabulary.parameters = {"a"};
    const Field field = make_field("(abs(x)^a + abs(y)^a)^(1/a)", vocabulary);
    Bindings<float> bindings;
    bindings.parameters = {-60};
    for (const float y : {1.0f, 4.0f, 1e6f})
        EXPECT_NEAR(FieldEvaluator<float>(field).value(bindings, {1, y, 0}), 1, 0.012f) << y;
}

TEST(PowerSums, HaveSecondSlopesWhereAllBasesAre0) {
    const Field field = make_field("(x^40 + y^40)^0.05 + z^2 - 0.5", {});
    std::array<float, 6> second{};
    Evaluator<float>(hessian(field)).point(Bindings<float>{}, std::array{0.0f, 0.0f, 0.5f}, second);
    for (const float one : second) EXPECT_TRUE(std::isfinite(one)) << one;
}

// Inputs that stand for m are no places (graph/walls.h).
TEST(PowerSums, StandBesideWalls) {
    const char* text = "floor(2*x) + (x^60 + y^60)^(1/60) + log(exp(y) + exp(z)) - 1";
    const Field field = with_walls(make_field(text, {}), 1e-4);
    for (const double slope : FieldEvaluator<double>(field).gradient({}, {0.3, 0.2, 0.1}))
        EXPECT_TRUE(std::isfinite(slope));
}

// Over boxes of every size the bounds hold values and slopes, and small boxes have narrow ones.
TEST(PowerSums, AreBoundedOverBoxes) {
    constexpr int seed = 5;
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Vocabulary vocabulary;
    vocabulary.parameters = {"a"};
    struct Norm {
        const char* text;
        double p, constant;
    };
    for (const Norm& norm : {Norm{"(x^60 + y^60)^(1/60)", 60, 0},
                             {"(abs(x)^17 + abs(y)^17)^(1/17)", 17, 0},
                             {"(abs(x)^a + abs(y)^a)^(1/a)", 33, 0},
                             {"(abs(x)^20.5 + abs(y)^20.5 + 0.25)^(1/20.5)", 20.5, 0.25}}) {
        SCOPED_TRACE(norm.text);
        const Field field = make_field(norm.text, vocabulary);
        const EnclosurePrograms programs = enclosure_programs(field);
        Evaluator<Interval> along(programs.directional);
        Bindings<Interval> bindings;
        bindings.parameters = {33};
        const auto value = [&](double x, double y) {
            const double m = std::max({std::abs(x), std::abs(y), 1e-3});
            const double sum = std::pow(std::abs(x) / m, norm.p) +
                               std::pow(std::abs(y) / m, norm.p) +
                               norm.constant * std::pow(1 / m, norm.p);
            return m * std::pow(sum, 1 / norm.p);
        };
        for (int k = 0; k < 300; ++k) {
            const double size = std::pow(10, random.in(-9, 0));
            const Point p = random.point(k % 2 == 0 ? 1.5 : 40), d = random.point(1);
            const auto side = [&](std::size_t axis) {
                return Interval(p[axis]) + Interval(0, size) * Interval(d[axis]);
            };
            const std::array<Interval, 6> ray{side(0), side(1), side(2), d[0], d[1], d[2]};
            std::array<Interval, 2> f;
            along.point(bindings, ray, f);
            SCOPED_TRACE(fmt::format("({}, {}) + {}", p[0], p[1], size));
            const auto at = [&](double t) { return value(p[0] + t * d[0], p[1] + t * d[1]); };
            const Interval slack(-1e-13, 1e-13);
            for (const double t : {0.0, random.in(0, size), size})
                EXPECT_TRUE(contains(f[0] + slack, at(t))) << at(t);
            const double slope = (at(size) - at(0)) / size;
            EXPECT_TRUE(contains(f[1] + Interval(-1e-3, 1e-3), slope)) << slope;
            const bool is_small = size < 1e-4 * std::max(std::abs(p[0]), std::abs(p[1]));
            EXPECT_LE(width(f[0]), 4 * size + (is_small ? 1e-12 : 0.1));
            if (is_small) {
                EXPECT_LE(width(f[1]), 10);
            }
        }
    }
}

// Bounds of what lists leave out of a sum know it by its node.
TEST(PowerSums, StayInSumsForBounds) {
    Graph graph;
    const NodeId sum = parse(graph, "sum(blobs, exp(-((x^60 + y^60)^(1/60) - cx)^2)) - 1");
    EXPECT_EQ(bounds_in_range(graph, sum), sum);
    EXPECT_EQ(InRange(graph, sum, Purpose::slopes).root(), sum);
    EXPECT_EQ(norms_without_cut_offs(graph, sum), sum);

    const NodeId norm = parse(graph, "(x^20 + y^20)^(1/20)");
    const NodeId beside = bounds_in_range(graph, graph.binary(Op::min, sum, norm));
    EXPECT_EQ(beside, graph.binary(Op::min, sum, bounds_in_range(graph, norm)));
    EXPECT_NE(bounds_in_range(graph, norm), norm);
}

// Alone, whole powers above 24 are (Graph::reach()).
TEST(PowerSums, AreNotCutOff) {
    const auto has_cut_off = [](const char* text) {
        Graph graph;
        const NodeId root = norms_without_cut_offs(graph, parse(graph, text));
        return std::ranges::any_of(nodes_below(graph, std::array{root}), [&](NodeId id) {
            return graph[id].op == Op::min || graph[id].op == Op::max;
        });
    };
    for (const char* text :
         {"(x^60 + y^60 + z^60)^(1/60) - 5", "(3*x^30 + abs(y)^30/7 + 1)^(1/30)*z",
          "(abs(x)^61 + abs(y)^61)^(1/61)", "((x^40 + y^40)^(1/40) - 3)^2 + z^2 - 1",
          "((x^30 + y^30)^(1/30)*(x + 1))^24 - (z^200 + y^200)^(1/100)"})
        EXPECT_FALSE(has_cut_off(text)) << text;
    for (const char* text : {"x^60 + y^60 + z^60 - 1", "(x^60 - y^60)^(1/60)", "(x^60 + y^60)^0.6",
                             "x^60 + (x^60 + y^60)^(1/60)", "sum(blobs, (x^60 + cx^60)^(1/60))"})
        EXPECT_TRUE(has_cut_off(text)) << text;
}

TEST(PowerSums, TakeSharedNodesInShortTime) {
    Graph graph;
    NodeId sum = parse(graph, "x^20"), product = parse(graph, "y"), square = product;
    const NodeId one = parse(graph, "y^20");
    for (int k = 0; k < 40; ++k) {
        sum = graph.add(sum, graph.multiply(graph.constant(k + 0.5), graph.add(sum, one)));
        product = graph.multiply(product, graph.multiply(product, product));
        square = graph.multiply(square, square);
    }
    NodeId quotient = graph.constant(1);
    for (int k = 0; k < 1000; ++k) quotient = graph.divide(quotient, graph.add(one, square));
    for (const NodeId base : {sum, product, square}) {
        for (const NodeId exponent : {graph.constant(0.05), quotient})
            expect_few_new_nodes(graph, graph.binary(Op::power, base, exponent));
    }
}

} // namespace
} // namespace isomotion::formula
