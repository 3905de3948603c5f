// T_n and its derivatives: the primitive, its definition, and its lowering to products.
#include "testing.h"

#include <algorithm>
#include <cmath>

#include "formula/field.h"
#include "formula/graph/derivative.h"
#include "formula/graph/operations.h"

namespace isomotion::formula {
namespace {

using Extended = long double;

// T_n^(k) for k = 0..3 at x = cos theta, from n theta and theta.
Extended closed_form(int n, int k, Extended x) {
    const Extended theta = std::acos(x), s = std::sin(theta);
    const Extended c0 = std::cos(n * theta), s0 = std::sin(n * theta);
    const Extended first = n * s0 / s;
    if (k == 0) return c0;
    if (k == 1) return first;
    // (1 - x^2) T'' = x T' - n^2 T, and that differentiated once more.
    const Extended second = (x * first - Extended(n) * n * c0) / (s * s);
    if (k == 2) return second;
    return (3 * x * second + (1 - Extended(n) * n) * first) / (s * s);
}

NodeId chebyshev_node(Graph& g, int n, int k) { return g.chebyshev(n, g.input(0), k); }

TEST(Chebyshev, DerivativesMatchTheClosedForms) {
    constexpr std::uint64_t seed = 30;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    for (const int n : {2, 3, 4, 5, 6, 7, 14, 24, 25, 50, 101, 200}) {
        for (int k = 0; k <= 3; ++k) {
            Graph g;
            const Program program = schedule_lowered(g, chebyshev_node(g, n, k));
            for (int trial = 0; trial < 50; ++trial) {
                const double x = random.in(-0.95, 0.95);
                const auto expected = double(closed_form(n, k, x));
                // Over [-0.95, 0.95] the k-th derivative is of the size (n / sin theta)^k.
                const double size = std::pow(n / std::sqrt(1 - x * x), k);
                EXPECT_NEAR(run(program, {x, 0, 0}), expected, 1e-12 * n * size)
                    << "n " << n << " k " << k << " x " << x;
            }
        }
    }
}

TEST(Chebyshev, DifferentiatingTheNodeCountsUp) {
    Graph g;
    const std::vector<NodeId> unit{g.constant(1)};
    NodeId node = g.chebyshev(9, g.input(0));
    for (int k = 1; k <= 9; ++k) {
        node = differentiate_inputs(g, node, unit);
        EXPECT_EQ(node, g.chebyshev(9, g.input(0), k));
    }
    EXPECT_TRUE(g.is_constant(differentiate_inputs(g, node, unit), 0));
    // The ninth derivative is 2^8 9!.
    EXPECT_EQ(value_of(g, node, {0.3, 0, 0}), 256.0 * 362880);
}

// T_n(1) = 1, T'(1) = n^2, T''(1) = n^2 (n^2 - 1)/3, T'''(1) = n^2 (n^2 - 1)(n^2 - 4)/15.
TEST(Chebyshev, AtTheEnds) {
    for (const int n : {2, 3, 8, 25, 50}) {
        const double q = double(n) * n;
        const std::array<double, 4> at_one{1, q, q * (q - 1) / 3, q * (q - 1) * (q - 4) / 15};
        for (int k = 0; k <= 3; ++k) {
            Graph g;
            const NodeId node = chebyshev_node(g, n, k);
            const double one = at_one[std::size_t(k)];
            EXPECT_NEAR(value_of(g, node, {1, 0, 0}), one, 1e-12 * one) << n << ' ' << k;
            const double parity = (n + k) % 2 == 0 ? 1 : -1;
            EXPECT_NEAR(value_of(g, node, {-1, 0, 0}), parity * one, 1e-12 * one) << n << ' ' << k;
        }
    }
}

TEST(Chebyshev, EqualsItsRecurrence) {
    constexpr std::uint64_t seed = 31;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    for (int n = 2; n <= 100; ++n) {
        Graph g;
        const Program program = schedule_lowered(g, chebyshev_node(g, n, 0));
        for (int trial = 0; trial < 20; ++trial) {
            // Up to degree 24 anywhere; above, where T_n is below 1e17 and not clamped.
            const double reach = n <= 24 ? 6 : std::cosh(40.0 / n);
            const double x = random.in(-reach, reach);
            Extended before = 1, now = x;
            for (int m = 2; m <= n; ++m) {
                const Extended ahead = 2 * Extended(x) * now - before;
                before = now;
                now = ahead;
            }
            const auto expected = double(now);
            EXPECT_NEAR(run(program, {x, 0, 0}), expected,
                        1e-12 * std::max(1.0, std::abs(expected)))
                << "n " << n << " x " << x;
        }
    }
}

// Largest float error of T_n over [-1, 1].
double largest_float_error(int n) {
    Graph g;
    const Program program = schedule_lowered(g, chebyshev_node(g, n, 0));
    Evaluator<float> evaluator(program);
    constexpr int samples = 400'000;
    std::vector<float> x(samples), t(samples);
    for (int i = 0; i < samples; ++i) x[std::size_t(i)] = float(-1 + 2.0 * i / (samples - 1));
    const std::array<std::span<const float>, 1> inputs{x};
    const std::array<std::span<float>, 1> outputs{t};
    evaluator.points({}, inputs, outputs);
    double largest = 0;
    for (std::size_t i = 0; i < samples; ++i) {
        const double exact = std::cos(n * std::acos(double(x[i])));
        largest = std::max(largest, std::abs(double(t[i]) - exact));
    }
    return largest;
}

// The figures of lowering.h. Far below them they would say nothing.
TEST(Chebyshev, FloatErrorIsAsDocumented) {
    EXPECT_LE(largest_float_error(14), 2.1e-6);
    EXPECT_GE(largest_float_error(14), 1e-6);
    EXPECT_LE(largest_float_error(50), 2.5e-5);
    EXPECT_GE(largest_float_error(50), 1e-5);
}

TEST(Chebyshev, TakesFewProducts) {
    for (const int n : {6, 14, 50, 1000}) {
        Graph g;
        const Program program = schedule_lowered(g, chebyshev_node(g, n, 0));
        EXPECT_LE(cost(program, {}).operations, 12 * std::log2(n) + 6) << n;
    }
}

// The clamp may only act where the value leaves float, and there keeps everything finite.
TEST(Chebyshev, ClampsWhereFloatEnds) {
    for (const int n : {25, 50, 200, 1000}) {
        Graph g;
        const std::array nodes{chebyshev_node(g, n, 0), chebyshev_node(g, n, 1),
                               chebyshev_node(g, n, 2)};
        const Program program = schedule(g, lower(g, nodes));
        double last = 0;
        for (double x = 1; x < 8; x += 0x1p-8) {
            std::array<float, 3> f{};
            const std::array<float, 1> input{float(x)};
            Evaluator<float>(program).point({}, input, f);
            for (const float value : f) {
                ASSERT_LE(std::abs(value), Operations<float>::saturation()) << n << ' ' << x;
            }
            const double exact = std::cosh(n * std::acosh(x));
            if (exact < 1e15) {
                EXPECT_NEAR(f[0], exact, 1e-4 * n * exact) << n << ' ' << x;
            } else {
                EXPECT_GT(f[0], 1e14) << n << ' ' << x;
            }
            EXPECT_GE(f[0], last * 0.99F) << n << ' ' << x;
            last = f[0];
        }
    }
}

// Lowering replaces chebyshev nodes wherever they stand, and nothing else.
TEST(Lowering, ReachesEveryPlace) {
    for (const auto* text :
         {"sin(chebyshev(5, x*y))", "sum(blobs, chebyshev(4, x-cx)*cy)",
          "min(chebyshev(3,x), chebyshev(3,y), z)", "chebyshev(6, chebyshev(5, x))",
          "chebyshev(4,x)^3 - abs(chebyshev(7,y))^1.5", "x/(2+chebyshev(2,y))"}) {
        SCOPED_TRACE(text);
        Graph g;
        const std::array<NodeId, 1> root{parse(g, text)};
        const Program program = schedule(g, lower(g, root));
        for (const auto& now : program.instructions) EXPECT_NE(now.op, Op::chebyshev);
    }
    const double x = 0.3, y = -0.6;
    const auto t = [](int n, double v) { return std::cos(n * std::acos(v)); };
    EXPECT_NEAR(value_of("chebyshev(6, chebyshev(5, x))", {x, y, 0}), t(30, x), 1e-13);
    EXPECT_NEAR(value_of("max(chebyshev(3,x), chebyshev(3,y))", {x, y, 0}),
                std::max(t(3, x), t(3, y)), 1e-14);
    EXPECT_NEAR(value_of("sum(blobs, chebyshev(2, x-cx))", {x, y, 0}),
                t(2, x - 0.25) + t(2, x + 0.125) + t(2, x + 0.5), 1e-14);
}

// Halving amplifies doubles' errors as T_n' does, by n^2 at most.
TEST(Lowering, ToFewestProductsKeepsValues) {
    constexpr std::uint64_t seed = 32;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    for (int n = 2; n <= 100; ++n) {
        Graph g;
        const NodeId lowered = lower_to_fewest_products(g, chebyshev_node(g, n, 0));
        const Program program = schedule(g, std::array{lowered});
        for (const auto& now : program.instructions) EXPECT_NE(now.op, Op::chebyshev);
        for (int trial = 0; trial < 20; ++trial) {
            const double x = random.in(-1, 1);
            EXPECT_NEAR(run(program, {x, 0, 0}), std::cos(n * std::acos(x)), 1e-15 * n * n + 1e-13)
                << "n " << n << " x " << x;
        }
    }
    const auto products = [](int n) {
        Graph g;
        const NodeId lowered = lower_to_fewest_products(g, chebyshev_node(g, n, 0));
        const Program program = schedule(g, std::array{lowered});
        return std::ranges::count(program.instructions, Op::multiply, &Instruction::op);
    };
    EXPECT_EQ(products(8), 6); // three squares, doubled
    EXPECT_EQ(products(14), 10);
}

TEST(Lowering, LeavesTheRestAlone) {
    Graph g;
    const NodeId plain = parse(g, "sum(blobs, exp(x-cx))^2 + min(y, z)");
    const std::size_t before = g.size();
    EXPECT_EQ(lower(g, std::array{plain}), std::vector<NodeId>{plain});
    EXPECT_EQ(g.size(), before);
    // Degrees share the doublings they have in common.
    const NodeId twice = parse(g, "chebyshev(8,x)*chebyshev(16,x)");
    const double both = cost(schedule_lowered(g, twice), {}).operations;
    Graph other;
    const double one = cost(schedule_lowered(other, chebyshev_node(other, 16, 0)), {}).operations;
    EXPECT_EQ(both, one + 1);
}

} // namespace
} // namespace isomotion::formula
