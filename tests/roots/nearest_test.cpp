// The first root on a ray of several surfaces: what is said of all is so whatever each of them has.
#include <limits>
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include "roots/nearest.h"

namespace isomotion::roots::nearest_test {
namespace {

// What a surface really has on a ray, and what is known of it.
struct Drawn {
    std::vector<double> roots; // ascending, simple ones
    std::vector<double> touches;
    FirstRoot known;
};

using Random = std::mt19937_64;

double between(Random& random, double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
}

Drawn draw(Random& random) {
    Drawn drawn;
    const auto kind = random() % 5;
    const double at = between(random, 0, 10), wide = between(random, 0, 0.5);
    const auto enclose = [&](double root) {
        drawn.known.low = float(root - wide * between(random, 0.1, 1) - 1e-3);
        drawn.known.high = float(root + wide * between(random, 0.1, 1) + 1e-3);
    };
    if (kind == 1 || kind == 2) {
        drawn.known.answer = Answer::hit;
        drawn.roots = {at};
        enclose(at);
    }
    if (kind == 3) {
        drawn.known.answer = Answer::touching;
        drawn.known.touch_low = float(at);
        drawn.known.touch_high = float(at + wide);
        if (random() % 2) drawn.touches.push_back(at + 0.5 * wide);
        drawn.known.after_is_hit = random() % 2;
        if (drawn.known.after_is_hit) {
            const double root = at + 2 + between(random, 0, 2);
            drawn.roots = {root};
            enclose(root);
        }
    }
    if (kind == 4) {
        drawn.known.answer = Answer::undecided;
        drawn.known.low = float(at);
        if (random() % 2) drawn.roots = {at + between(random, 0.1, 3)};
    }
    return drawn;
}

TEST(Nearest, WhatIsSaidOfAllIsSo) {
    constexpr std::uint64_t seed = 4711;
    SCOPED_TRACE(seed);
    Random random(seed);
    int answers[4] = {};
    for (int turn = 0; turn < 20'000; ++turn) {
        std::vector<FirstRoot> known;
        double first = std::numeric_limits<double>::infinity(), first_touch = first;
        int first_surface = -1;
        const int count = 1 + int(random() % 4);
        for (int k = 0; k < count; ++k) {
            const Drawn drawn = draw(random);
            known.push_back(drawn.known);
            known.back().surface = k;
            for (const double root : drawn.roots) {
                if (root < first) {
                    first = root;
                    first_surface = k;
                }
            }
            for (const double touch : drawn.touches) first_touch = std::min(first_touch, touch);
        }
        const FirstRoot all = nearest(known, 0.01);
        ++answers[std::size_t(all.answer)];
        switch (all.answer) {
        case Answer::miss:
            ASSERT_EQ(first, HUGE_VAL);
            ASSERT_EQ(first_touch, HUGE_VAL);
            break;
        case Answer::hit:
            ASSERT_LE(double(all.low), first);
            ASSERT_GE(double(all.high), first);
            ASSERT_GE(first_touch, first - 1e-6);
            if (all.surface >= 0) {
                ASSERT_EQ(all.surface, first_surface);
            }
            break;
        case Answer::touching:
            ASSERT_EQ(all.after_is_hit, first < HUGE_VAL);
            if (all.after_is_hit) {
                ASSERT_LE(double(all.low), first);
                ASSERT_GE(double(all.high), first);
            }
            if (first_touch < first) {
                ASSERT_LE(double(all.touch_low), first_touch + 1e-6);
                ASSERT_GE(double(all.touch_high), first_touch - 1e-6);
            }
            break;
        case Answer::undecided:
            ASSERT_LE(double(all.low), std::min(first, first_touch) + 1e-6);
            break;
        }
    }
    for (const int many : answers) EXPECT_GT(many, 500);
}

TEST(Nearest, OneAloneIsItself) {
    FirstRoot root;
    root.answer = Answer::hit;
    root.low = 1;
    root.high = 1.5f;
    root.gradient = {1, 2, 3};
    const FirstRoot all = nearest(std::vector{root}, 0.1);
    EXPECT_EQ(all.answer, Answer::hit);
    EXPECT_EQ(all.low, 1);
    EXPECT_EQ(all.high, 1.5f);
    EXPECT_EQ(all.gradient, root.gradient);
    EXPECT_EQ(all.surface, 0);
}

TEST(Nearest, OfNeighboursTheSurfaceIsNotTold) {
    FirstRoot near, far;
    near.answer = far.answer = Answer::hit;
    near.low = 1;
    near.high = 1.1f;
    far.low = 1.15f;
    far.high = 1.2f;
    far.surface = 1;
    EXPECT_EQ(nearest(std::vector{near, far}, 0.1).surface, -1);
    EXPECT_EQ(nearest(std::vector{near, far}, 0.01).surface, 0);
    EXPECT_EQ(nearest(std::vector{far, near}, 0.01).surface, 0);
}

// Both touches in one interval would call a hit between them, where nothing is, right.
TEST(Nearest, TouchesThatAreApartAreUndecided) {
    FirstRoot near, far;
    near.answer = far.answer = Answer::touching;
    near.touch_low = 1;
    near.touch_high = 1.1f;
    far.touch_low = 9;
    far.touch_high = 9.1f;
    const FirstRoot apart = nearest(std::vector{far, near}, 0.01);
    EXPECT_EQ(apart.answer, Answer::undecided);
    EXPECT_EQ(apart.low, 1.0f);
    far.touch_low = 1.05f;
    far.touch_high = 1.2f;
    const FirstRoot together = nearest(std::vector{far, near}, 0.01);
    EXPECT_EQ(together.answer, Answer::touching);
    EXPECT_EQ(together.touch_low, 1.0f);
    EXPECT_EQ(together.touch_high, 1.2f);
}

} // namespace
} // namespace isomotion::roots::nearest_test
