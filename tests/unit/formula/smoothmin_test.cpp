// smoothmin(a, b, k), its nastiest points first: a = b, |a - b| = k, and k that is 0, negative,
// tiny or huge.
#include <cmath>
#include <limits>

#include "exact.h"
#include "formula/graph/derivative.h"
#include "formula/interval/interval_operations.h"
#include "testing.h"

namespace isomotion::formula {
namespace {

// smoothmin(x, y, z), with its slope along dx, dy and dz.
struct Smoothmin {
    Graph graph;
    Program value, slope, gradient, bend;
    Program enclosure;

    Smoothmin() {
        const NodeId root = parse(graph, "smoothmin(x, y, z)");
        std::vector<NodeId> directions;
        for (int k = 3; k < 6; ++k) directions.push_back(graph.input(k));
        const NodeId along = differentiate_inputs(graph, root, directions);
        const NodeId again =
            differentiate_inputs(graph, along, directions, Slopes::pointwise_again);
        value = enclosure = schedule_lowered(graph, root);
        slope = schedule_lowered(graph, along);
        bend = schedule_lowered(graph, again);
    }
    template<class T> static T of(const Program& program, const std::array<T, 6>& inputs) {
        T result{};
        Evaluator<T>(program).point(Bindings<T>{}, inputs, {&result, 1});
        return result;
    }
    template<class T> T operator()(T a, T b, T k) const {
        return of<T>(value, {a, b, k, T(0), T(0), T(0)});
    }
    double slope_at(const Point& p, const Point& d) const {
        return of<double>(slope, {p[0], p[1], p[2], d[0], d[1], d[2]});
    }
    double bend_at(const Point& p, const Point& d) const {
        return of<double>(bend, {p[0], p[1], p[2], d[0], d[1], d[2]});
    }
};

Exact on_paper(double a, double b, double k) {
    const Exact least = std::min(a, b), apart = Exact(std::max(a, b)) - least, width = k;
    if (!(apart < width)) return least;
    const Exact short_of = width - apart;
    return least - short_of * short_of / (Exact(4) * width);
}

const double values[] = {0.0,    -0.0, 1.0,  -1.0,  1.5,   0.1,  -0.3,   1e-30, -1e-30,
                         1e-300, 1e10, 1e30, -1e30, 1e299, 3.25, 2.9999, -7e-8, 5e-324};

TEST(Smoothmin, IsTheMinimumItselfWithoutAWidth) {
    const Smoothmin f;
    for (const double a : values) {
        for (const double b : values) {
            for (const double k : {0.0, -0.0, -1e-300, -1.0, -1e30}) {
                EXPECT_EQ(f(a, b, k), std::min(a, b)) << a << " " << b << " " << k;
            }
            if (std::abs(a) > 1e30 || std::abs(b) > 1e30) continue;
            EXPECT_EQ(f(float(a), float(b), -1.0f), std::min(float(a), float(b))) << a << " " << b;
            EXPECT_EQ(f(float(a), float(b), 0.0f), std::min(float(a), float(b))) << a << " " << b;
        }
    }
}

TEST(Smoothmin, IsTheMinimumItselfWhereItsArgumentsAreFarApart) {
    const Smoothmin f;
    Random random(3);
    for (int n = 0; n < 2000; ++n) {
        const double k = std::exp(random.in(-20, 20));
        const double a = random.in(-3, 3) * k, b = a + k * random.in(1.0001, 50);
        EXPECT_EQ(f(a, b, k), a);
        EXPECT_EQ(f(b, a, k), a);
    }
}

TEST(Smoothmin, IsLessByAQuarterOfItsWidthWhereItsArgumentsAreEqual) {
    const Smoothmin f;
    for (const double a : {0.0, 1.0, -2.5, 1024.0}) {
        for (const double k : {1.0, 0.5, 4096.0}) EXPECT_EQ(f(a, a, k), a - k / 4);
    }
    EXPECT_EQ(f(1e299, 1e299, 1e-10), 1e299);
}

TEST(Smoothmin, IsWhatItIsOnPaperAndNeverMoreThanTheMinimum) {
    const Smoothmin f;
    Random random(4);
    const auto near = [&](double a, double b, double k) {
        const double is = f(a, b, k), least = std::min(a, b);
        const double size = std::abs(a) + std::abs(b) + std::max(k, 0.0);
        EXPECT_LE(is, least) << a << " " << b << " " << k;
        EXPECT_NEAR(is, on_paper(a, b, k).rounded(), 4e-16 * size + 1e-30)
            << a << " " << b << " " << k;
        EXPECT_EQ(is, f(b, a, k)) << a << " " << b << " " << k;
    };
    for (const double a : values) {
        for (const double b : values) {
            for (const double k : {0.0, 1e-320, 1e-31, 1e-20, 0.1, 1.0, 3e7, 1e30}) near(a, b, k);
            if (const double k = std::abs(a - b); std::isfinite(k)) { // the very edge
                near(a, b, k);
                near(a, b, std::nextafter(k, 0.0));
                near(a, b, std::nextafter(k, HUGE_VAL));
            }
        }
    }
    for (int n = 0; n < 20000; ++n) {
        const double k = std::exp(random.in(-10, 10)),
                     a = random.in(-2, 2) * std::exp(random.in(-3, 3));
        near(a, a + k * random.in(-1.5, 1.5), k);
    }
}

TEST(Smoothmin, HasTheMeanOfBothSlopesWhereItsArgumentsAreEqual) {
    const Smoothmin f;
    for (const double a : {0.0, 0.7, -3.0}) {
        for (const double k : {1.0, 0.01, 50.0}) {
            EXPECT_DOUBLE_EQ(f.slope_at({a, a, k}, {1, 0, 0}), 0.5);
            EXPECT_DOUBLE_EQ(f.slope_at({a, a, k}, {0, 1, 0}), 0.5);
            EXPECT_DOUBLE_EQ(f.slope_at({a, a, k}, {0, 0, 1}), -0.25);
            EXPECT_DOUBLE_EQ(f.slope_at({a, a, k}, {3, -1, 0}), 1);
            // A parabola: -(a' - b')^2 / 2k.
            EXPECT_DOUBLE_EQ(f.bend_at({a, a, k}, {1, -1, 0}), -2 / k);
            EXPECT_DOUBLE_EQ(f.bend_at({a, a, k}, {1, 1, 0}), 0);
        }
    }
}

TEST(Smoothmin, HasSlopesWithoutAJumpFromOneSideToTheOther) {
    const Smoothmin f;
    for (const double k : {1e-3, 1.0, 1e3}) {
        double before = 1;
        for (double part = -1.5; part <= 1.5; part += 1.0 / 1024) {
            const double slope = f.slope_at({part * k, 0, k}, {1, 0, 0}); // by the first argument
            EXPECT_GE(slope, 0);
            EXPECT_LE(slope, before + 1e-12);
            EXPECT_LT(before - slope, 0.001);
            EXPECT_NEAR(slope, std::clamp(0.5 - 0.5 * part, 0.0, 1.0), 1e-12);
            before = slope;
        }
        EXPECT_EQ(before, 0);
    }
}

TEST(Smoothmin, HasTheSlopesOfTheMinimumWithoutAWidth) {
    const Smoothmin f;
    Graph graph;
    const NodeId root = parse(graph, "min(x, y)");
    const NodeId one = graph.constant(1), zero = graph.constant(0);
    const Program by_x =
        schedule_lowered(graph, differentiate_inputs(graph, root, {one, zero, zero}));
    for (const double a : values) {
        for (const double b : values) {
            for (const double k : {0.0, -1.0}) {
                EXPECT_EQ(f.slope_at({a, b, k}, {1, 0, 0}), run(by_x, {a, b, k}))
                    << a << " " << b << " " << k;
            }
        }
    }
}

// Over a box around a = b its slopes are bounded by those of the blend, and bend no further.
TEST(Smoothmin, HasNoKinkForIntervalsWhereItsArgumentsAreEqual) {
    Graph graph;
    const NodeId root = parse(graph, "smoothmin(x, y, 1)");
    const std::vector<NodeId> along_x{graph.constant(1), graph.constant(0), graph.constant(0)};
    const NodeId slope = differentiate_inputs(graph, root, along_x, Slopes::generalized);
    const NodeId bend = differentiate_inputs(graph, slope, along_x, Slopes::generalized);
    const auto over = [&](NodeId node, Interval x, Interval y) {
        const Program program = schedule_lowered(graph, node);
        Interval result;
        Evaluator<Interval>(program).point({}, std::array<Interval, 3>{x, y, 0.0}, {&result, 1});
        return result;
    };
    const Interval around(-0.01, 0.01);
    const Interval is = over(slope, around, around);
    EXPECT_TRUE(contains(is, Interval(0.49, 0.51)));
    EXPECT_TRUE(contains(Interval(0.47, 0.53), is));
    EXPECT_TRUE(contains(over(bend, around, around), -0.5));
    EXPECT_TRUE(contains(Interval(-0.501, -0.499), over(bend, around, around)));
    EXPECT_EQ(over(slope, around, Interval(2, 3)), Interval(1));
    EXPECT_EQ(over(slope, Interval(2, 3), around), Interval(0));
}

// The function rises in a and b and falls in k: its range is between two corners.
struct Range {
    Exact low, high;
};
Range range(Interval a, Interval b, Interval k) {
    return {on_paper(a.lo, b.lo, k.hi), on_paper(a.hi, b.hi, k.lo)};
}

TEST(Smoothmin, OfIntervalsHoldsItsRangeAndNotMuchMore) {
    const Smoothmin f;
    Random random(5);
    int narrow = 0, wide = 0;
    for (int n = 0; n < 20000; ++n) {
        const double k = std::exp(random.in(-6, 6)), size = k * std::exp(random.in(-9, 4));
        const auto around = [&](double middle) {
            const double to = size * random.in(0, 1);
            return Interval(middle - to, middle + to);
        };
        const double at = random.in(-2, 2);
        const Interval a = around(at), b = around(at + k * random.in(-1.5, 1.5)), width(k);
        const Interval is = f(a, b, width);
        const Range least = range(a, b, width);
        EXPECT_TRUE(holds(is, least.low) && holds(is, least.high));
        EXPECT_LE(is.hi, std::min(a.hi, b.hi)); // as the minimum itself has it
        const double rounding = 1e-14 * (2 + k + size);
        EXPECT_GE(is.lo, least.low.rounded() - k / 2 - rounding);
        (size < k / 100 ? narrow : wide) += 1;
        if (size < k / 100) {
            const double both = formula::width(a) + formula::width(b);
            EXPECT_LE(formula::width(is), 1.02 * both + rounding);
        }
    }
    EXPECT_GT(narrow, 2000);
    EXPECT_GT(wide, 2000);
}

TEST(Smoothmin, OfIntervalsOfWidthsIsBounded) {
    const Smoothmin f;
    Random random(6);
    for (int n = 0; n < 5000; ++n) {
        const auto any = [&] {
            const double p = random.in(-2, 2), q = random.in(-2, 2);
            return Interval(std::min(p, q), std::max(p, q));
        };
        const Interval a = any(), b = any(), k = any();
        const Interval is = f(a, b, k);
        EXPECT_GE(is.lo, std::min(a.lo, b.lo) - std::max(k.hi, 0.0) / 2 - 1e-14);
        for (int m = 0; m < 8; ++m) {
            const auto in = [&](Interval i) {
                return std::clamp(random.in(i.lo, i.hi), i.lo, i.hi);
            };
            EXPECT_TRUE(holds(is, on_paper(in(a), in(b), in(k))));
        }
    }
    // Unbounded arguments keep what bounds there are.
    const Interval above = f(Interval(0, infinity), Interval(1, 2), Interval(1));
    EXPECT_LE(above.hi, 2);
    EXPECT_GE(above.lo, -0.5);
}

} // namespace
} // namespace isomotion::formula
