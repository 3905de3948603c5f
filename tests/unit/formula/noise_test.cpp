// Gradient noise: its lattice, its slopes, and its bounds over boxes.
#include "formula/graph/noise.h"

#include "formula/interval/noise_enclosure.h"
#include "unit/formula/testing.h"

namespace isomotion::formula::noise_test {
namespace {

constexpr unsigned seed = 77;
const std::vector<NoiseOrder> orders{{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}},
                                     {{2, 0, 0}}, {{1, 1, 0}}, {{0, 1, 1}}, {{0, 0, 2}},
                                     {{3, 0, 1}}, {{0, 4, 0}}, {{5, 0, 0}}, {{6, 1, 0}}};

double at(const Point& p, const NoiseOrder& order = {}) { return noise(p[0], p[1], p[2], order); }

TEST(Noise, IsZeroAtWholeNumbersAndRisesAlongItsGradients) {
    for (const Point& p : {Point{0, 0, 0}, Point{3, -7, 12}, Point{-1e6, 5, 1e9}}) {
        EXPECT_EQ(at(p), 0);
        double sum = 0;
        for (const NoiseOrder& order : {NoiseOrder{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}})
            sum += std::abs(at(p, order));
        EXPECT_EQ(sum, 2); // two of three components are 1 or -1
    }
}

TEST(Noise, RepeatsAfterItsPeriodAndNotBefore) {
    const Point p{0.25, 0.5, 0.75};
    EXPECT_EQ(at(p), at({p[0] + lattice::period, p[1] - lattice::period, p[2]}));
    EXPECT_NE(at(p), at({p[0] + lattice::period / 2, p[1], p[2]}));
    EXPECT_NE(at(p), at({p[0] + 1, p[1], p[2]}));
}

TEST(Noise, IsTheSameInFloats) {
    Random random{seed};
    for (int k = 0; k < 1000; ++k) {
        const Point p = random.point(100);
        const std::array<float, 3> q{float(p[0]), float(p[1]), float(p[2])};
        EXPECT_NEAR(noise(q[0], q[1], q[2], {}), at({q[0], q[1], q[2]}), 1e-6) << "seed " << seed;
    }
}

TEST(Noise, HasTheSlopesOfItsDifferences) {
    Random random{seed};
    for (const NoiseOrder& order : orders) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            NoiseOrder slope = order;
            ++slope.along[axis];
            for (int k = 0; k < 50; ++k) {
                Point p = random.point(4);
                p[axis] = std::floor(p[axis]) + 0.1 + 0.8 * (p[axis] - std::floor(p[axis]));
                constexpr double step = 1e-5;
                Point less = p, more = p;
                less[axis] -= step;
                more[axis] += step;
                const double difference = (at(more, order) - at(less, order)) / (2 * step);
                EXPECT_NEAR(at(p, slope), difference, 1e-6 * noise_bound(slope) + 1e-4)
                    << "order " << order.packed() << ", axis " << axis << ", seed " << seed;
            }
        }
    }
}

TEST(Noise, HasTwoContinuousDerivatives) {
    Random random{seed};
    for (const NoiseOrder& order : orders) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (jumps_between_cells(order.along[axis])) continue;
            for (int k = 0; k < 20; ++k) {
                Point p = random.point(4);
                p[axis] = std::round(p[axis]);
                Point before = p;
                before[axis] -= 1e-9;
                EXPECT_NEAR(at(before, order), at(p, order), 1e-5) << order.packed();
            }
        }
    }
}

TEST(Noise, IsWithinItsBoundsOverBoxes) {
    Random random{seed};
    for (const NoiseOrder& order : orders) {
        for (int k = 0; k < 300; ++k) {
            const double reach = std::exp2(-random.below(14) + 1);
            const Point p = random.point(5);
            std::array<Interval, 3> box;
            Point member{};
            for (std::size_t c = 0; c < 3; ++c) {
                box[c] = {p[c] - reach, p[c] + reach};
                member[c] = p[c] + reach * random.point(1)[0];
            }
            const Interval bounds = NoiseEnclosure(order)(box[0], box[1], box[2]);
            const double value = at(member, order), margin = 1e-12 * noise_bound(order);
            EXPECT_LE(bounds.lo, value + margin) << order.packed() << ", seed " << seed;
            EXPECT_GE(bounds.hi, value - margin) << order.packed() << ", seed " << seed;
            EXPECT_LE(magnitude(bounds), noise_bound(order));
        }
    }
}

// As narrow as slopes allow, but for a factor.
TEST(Noise, HasNarrowBoundsOverSmallBoxes) {
    Random random{seed};
    for (int k = 0; k < 200; ++k) {
        const Point p = random.point(5);
        constexpr double reach = 1e-4;
        const auto around = [&](std::size_t c) { return Interval(p[c] - reach, p[c] + reach); };
        EXPECT_LT(width(NoiseEnclosure({})(around(0), around(1), around(2))), 60 * reach);
    }
}

TEST(Noise, IsBoundedWhereBoxesHaveNoEnd) {
    const Interval all = NoiseEnclosure({})(Interval::entire(), Interval(0), Interval(0));
    EXPECT_LT(all.hi, 1.6);
    EXPECT_EQ(all.lo, -all.hi);
    EXPECT_GT(all.hi, 1);
    // Between such numbers lie cells that no double names.
    const Interval far{0x1p53, 0x1p53 + 2};
    EXPECT_EQ(NoiseEnclosure({})(far, Interval(0.5), Interval(0.5)), all);
}

// Whatever the gradients of a cell are.
TEST(Noise, IsNoLargerThanDocumented) {
    double most = 0;
    for (int k = 0; k < 50 * 50 * 50; ++k) {
        const Point p{k % 50 / 49.0, k / 50 % 50 / 49.0, k / 2500 / 49.0};
        double sum = 0;
        for (int corner = 0; corner < 8; ++corner) {
            std::array<double, 3> away{};
            double weight = 1;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const bool is_far = (corner >> axis & 1) != 0;
                away[axis] = std::abs(p[axis] - (is_far ? 1 : 0));
                weight *= is_far ? lattice::fade(p[axis]) : 1 - lattice::fade(p[axis]);
            }
            std::ranges::sort(away);
            sum += weight * (away[1] + away[2]);
        }
        most = std::max(most, sum);
    }
    EXPECT_LT(most, 1.04);
    EXPECT_GT(most, 1.03);
    EXPECT_GE(noise_bound({}), most);
}

TEST(Noise, IsReadFromAPlaceAndFromItsParts) {
    expect_same("noise(p)", "noise(x, y, z)");
    expect_same("fbm(x, y, z, 1)", "noise(x, y, z)");
    expect_same("fbm(p, 2)", "fbm(x, y, z, 2)");
    EXPECT_THROW(value_of("noise(x, y)"), std::exception);
    EXPECT_THROW(value_of("fbm(x, y, z, 1.5)"), std::exception);
    EXPECT_THROW(value_of("fbm(x, y, z, 13)"), std::exception);
    EXPECT_THROW(value_of("fbm(x, y, z, a)"), std::exception);
    EXPECT_THROW(value_of("fbm(x, y, z)"), std::exception);
}

} // namespace
} // namespace isomotion::formula::noise_test
