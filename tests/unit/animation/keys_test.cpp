#include "animation/keys.h"

#include <cmath>

#include "testing.h"

namespace isomotion::animation {
namespace {

constexpr Ease every_ease[] = {Ease::linear, Ease::smooth, Ease::hold, Ease::cubic};

// Two to nine keys at uneven times.
Keys any_keys(Random& random, Ease ease) {
    Keys keys{{}, ease};
    double time = random.in(-5, 5);
    for (int k = 2 + random.below(8); k > 0; --k) {
        keys.keys.push_back({time, random.in(-10, 10)});
        time += random.in(0.1, 3);
    }
    return keys;
}

double middle(const Key& a, const Key& b) { return 0.5 * (a.time + b.time); }

// Slopes from the side of `time` that h points to: the error is of second order in h.
double slope(const Keys& keys, double time, double h) {
    return (-3 * keys.at(time) + 4 * keys.at(time + h) - keys.at(time + 2 * h)) / (2 * h);
}

class EveryEase : public testing::TestWithParam<Ease> {};

TEST_P(EveryEase, PassesThroughItsKeysExactly) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const Keys keys = any_keys(random, GetParam());
        for (const Key& key : keys.keys) EXPECT_EQ(keys.at(key.time), key.value);
    }
}

TEST_P(EveryEase, RestsBeforeTheFirstKeyAndAfterTheLast) {
    const Keys keys{{{-1, 3}, {0.5, -2}, {4, 7}}, GetParam()};
    EXPECT_EQ(keys.at(std::nextafter(-1, -2)), 3);
    EXPECT_EQ(keys.at(-1e300), 3);
    EXPECT_EQ(keys.at(std::nextafter(4, 5)), 7);
    EXPECT_EQ(keys.at(1e300), 7);
}

TEST_P(EveryEase, OneKeyIsAConstant) {
    const Keys keys{{{2, 0.3}}, GetParam()};
    for (const double time : {-1e9, 0.0, 2.0, 2.5, 1e9}) EXPECT_EQ(keys.at(time), 0.3);
}

TEST_P(EveryEase, EqualKeysStayEqual) {
    const Keys keys{{{0, 0.1}, {1, 0.1}, {5, 0.1}}, GetParam()};
    for (double time = 0; time <= 5; time += 0.0625) {
        EXPECT_NEAR(keys.at(time), 0.1, 1e-15) << time;
    }
}

// Times are numbers like others: shifting them, and scaling values, commutes with the easing.
TEST_P(EveryEase, IsAffineInTimeAndValue) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const Keys keys = any_keys(random, GetParam());
        const double stretch = random.in(0.1, 10), shift = random.in(-5, 5);
        const double scale = random.in(-3, 3), lift = random.in(-5, 5);
        Keys mapped = keys;
        for (Key& key : mapped.keys) {
            key.time = stretch * key.time + shift;
            key.value = scale * key.value + lift;
        }
        for (std::size_t k = 1; k < keys.keys.size(); ++k) {
            const double time = middle(keys.keys[k - 1], keys.keys[k]);
            EXPECT_NEAR(mapped.at(stretch * time + shift), scale * keys.at(time) + lift, 1e-9);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Keys, EveryEase, testing::ValuesIn(every_ease), [](const auto& instance) {
    return std::string(ease_names[std::size_t(instance.param)]);
});

TEST(LinearKeys, LieOnTheLineBetweenKeys) {
    const Keys keys{{{1, 2}, {3, 10}, {4, 6}}, Ease::linear};
    for (double u = 0; u <= 1; u += 0.125) {
        EXPECT_DOUBLE_EQ(keys.at(1 + 2 * u), 2 + 8 * u);
        EXPECT_DOUBLE_EQ(keys.at(3 + u), 10 - 4 * u);
    }
}

TEST(SmoothKeys, FollowSmoothstep) {
    const Keys keys{{{0, 1}, {2, 5}}, Ease::smooth};
    for (double u = 0; u <= 1; u += 0.0625) {
        EXPECT_DOUBLE_EQ(keys.at(2 * u), 1 + 4 * u * u * (3 - 2 * u));
    }
}

TEST(SmoothKeys, AreAtRestAtEveryKeyAndNeverOvershoot) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const Keys keys = any_keys(random, Ease::smooth);
        for (std::size_t k = 1; k < keys.keys.size(); ++k) {
            const Key &a = keys.keys[k - 1], &b = keys.keys[k];
            const double length = b.time - a.time, rise = b.value - a.value;
            const double h = 1e-5 * length;
            EXPECT_NEAR(slope(keys, a.time, h) * length, 0, 1e-4 * (1 + std::abs(rise)));
            EXPECT_NEAR(slope(keys, b.time, -h) * length, 0, 1e-4 * (1 + std::abs(rise)));
            double last = a.value;
            for (double u = 0.01; u < 1; u += 0.01) {
                const double now = keys.at(a.time + u * length);
                EXPECT_GE((now - last) * rise, 0);
                last = now;
            }
            EXPECT_GE((b.value - last) * rise, 0);
        }
    }
}

TEST(HeldKeys, ChangeAtTheKeyAndNotBefore) {
    const Keys keys{{{0, 1}, {1, 2}, {2.5, 3}}, Ease::hold};
    for (const double at : {1.0, 2.5}) {
        const double before = keys.at(std::nextafter(at, 0));
        EXPECT_EQ(keys.at(at), before + 1);
        EXPECT_EQ(keys.at(std::nextafter(at, 9)), before + 1);
    }
    EXPECT_EQ(keys.at(0.999), 1);
}

TEST(CubicKeys, HaveTheSameVelocityOnBothSidesOfAKey) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const Keys keys = any_keys(random, Ease::cubic);
        for (std::size_t k = 1; k + 1 < keys.keys.size(); ++k) {
            const Key &before = keys.keys[k - 1], &here = keys.keys[k], &after = keys.keys[k + 1];
            const double h = 1e-5 * std::min(here.time - before.time, after.time - here.time);
            const double left = slope(keys, here.time, -h), right = slope(keys, here.time, h);
            const double neighbours = (after.value - before.value) / (after.time - before.time);
            EXPECT_NEAR(left, right, 1e-5);
            EXPECT_NEAR(right, neighbours, 1e-5);
        }
    }
}

TEST(CubicKeys, KeepALineALine) {
    const Keys keys{{{-1, -1}, {0, 2}, {3, 11}, {3.5, 12.5}}, Ease::cubic};
    for (double time = -1; time <= 3.5; time += 0.0625) {
        EXPECT_NEAR(keys.at(time), 2 + 3 * time, 1e-13) << time;
    }
}

// With neighbours at even distances the slopes at inner keys are exact for parabolas.
TEST(CubicKeys, KeepAParabolaBetweenInnerKeys) {
    Keys keys{{}, Ease::cubic};
    for (int k = -3; k <= 3; ++k) keys.keys.push_back({double(k), double(k * k)});
    for (double time = -2; time <= 2; time += 0.0625) {
        EXPECT_NEAR(keys.at(time), time * time, 1e-13) << time;
    }
}

} // namespace
} // namespace isomotion::animation
