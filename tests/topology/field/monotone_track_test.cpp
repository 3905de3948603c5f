// The times at which a track has a value: crossings, turns, and spans in which it rests.
#include "topology/field/monotone_track.h"

#include <cmath>

#include <gtest/gtest.h>

#include "topology/scenes.h"

namespace isomotion::topology {
namespace {

using formula::Interval;
using Times = std::vector<MonotoneTrack::Time>;

// The times at which the track c has the value, where `source` is what a scene has for c.
Times times(const std::string& source, Interval range, Interval value) {
    const scene::Scene scene =
        scene_of(fmt::format("[surface]\nformula = \"x^2 + y^2 + z^2 - c\"\nbounds = {{ sphere = 3 "
                             "}}\n[parameters]\nc = {}\n",
                             source));
    return MonotoneTrack(scene, *scene.surfaces[0].animation.find("c"), range).times(value);
}

TEST(MonotoneTrack, CrossesAndTurns) {
    const Times crossings = times("\"sin(t)\"", {-0.5, 7}, 0.0);
    ASSERT_EQ(crossings.size(), 3u);
    EXPECT_EQ(crossings[0].direction, 1);
    EXPECT_EQ(crossings[1].direction, -1);
    EXPECT_EQ(crossings[2].direction, 1);
    EXPECT_NEAR(mid(crossings[1].at), M_PI, 1e-12);
    // Just below the top it crosses twice; at the top, and as near as doubles tell, it may not.
    const Times twice = times("\"sin(t)\"", {0, 3}, 1 - 1e-6);
    ASSERT_EQ(twice.size(), 2u);
    EXPECT_EQ(twice[0].direction, 1);
    EXPECT_EQ(twice[1].direction, -1);
    for (const double value : {1.0, std::nextafter(1.0, 0.0), std::nextafter(1.0, 2.0)}) {
        for (const MonotoneTrack::Time& time : times("\"sin(t)\"", {0, 3}, value)) {
            EXPECT_EQ(time.direction, 0) << value;
            EXPECT_NEAR(mid(time.at), M_PI / 2, 1e-6);
        }
    }
}

TEST(MonotoneTrack, CrossesWhereItRestsForAMomentOnItsWay) {
    struct Case {
        const char* keys;
        int direction;
    };
    for (const Case& c :
         {Case{"[[0, -0.7], [1, 0], [3, 0.2]]", 1}, Case{"[[0, 1], [1, 0], [3, -2]]", -1},
          Case{"[[-1, -2], [1, 0], [1.5, 0.1], [4, 3]]", 1}}) {
        SCOPED_TRACE(c.keys);
        const std::string track = fmt::format("{{ keys = {}, ease = \"smooth\" }}", c.keys);
        for (const Interval value : {Interval(0.0), Interval(-1e-16, 1e-16)}) {
            const Times found = times(track, {0, 2.5}, value);
            ASSERT_EQ(found.size(), 1u);
            EXPECT_EQ(found[0].direction, c.direction);
            EXPECT_TRUE(contains(found[0].at, 1.0));
            EXPECT_LT(width(found[0].at), 1e-6);
        }
        // Where the range begins or ends with it, it may be outside.
        for (const Interval range : {Interval(0, 1), Interval(1, 2.5)}) {
            const Times at_end = times(track, range, 0.0);
            ASSERT_EQ(at_end.size(), 1u);
            EXPECT_EQ(at_end[0].direction, 0);
        }
    }
}

TEST(MonotoneTrack, ATurnWhereItRestsIsNoCrossing) {
    for (const char* keys : {"[[0, -0.7], [1, 0], [3, -0.2]]", "[[0, 1], [1, 0], [2, 0], [3, -1]]",
                             "[[0, 1], [1, 0]]", "[[1, 0], [2, -1]]"}) {
        const Times found =
            times(fmt::format("{{ keys = {}, ease = \"smooth\" }}", keys), {0, 2.5}, 0.0);
        ASSERT_EQ(found.size(), 1u) << keys;
        EXPECT_EQ(found[0].direction, 0) << keys;
        EXPECT_TRUE(contains(found[0].at, 1.0)) << keys;
    }
    // What it does later is no part of it.
    const Times later = times(
        "{ keys = [[0, -1], [1, 0], [1.5, -0.5], [2.5, 1]], ease = \"smooth\" }", {0, 2.5}, 0.0);
    ASSERT_EQ(later.size(), 2u);
    EXPECT_EQ(later[0].direction, 0);
    EXPECT_TRUE(contains(later[0].at, 1.0));
    EXPECT_EQ(later[1].direction, 1);
}

TEST(MonotoneTrack, RestsForOneSpan) {
    // Long ones were cut into a billion pieces.
    for (const char* source :
         {"\"min(max(t - 1, -0.5), 0)\"", "{ keys = [[0.5, -0.5], [1, 0], [3, 0]] }",
          "{ keys = [[0.5, -0.5], [1, 0], [3, 0]], ease = \"smooth\" }",
          "\"-0.1 + 0.1*(1 + min(t - 1, 0))\"", "\"sign(t - 1)*min(t - 1, 0)*0.3\""}) {
        SCOPED_TRACE(source);
        const Times rest = times(source, {0, 3}, Interval(-1e-16, 1e-16));
        ASSERT_EQ(rest.size(), 1u);
        EXPECT_EQ(rest[0].direction, 0);
        EXPECT_NEAR(rest[0].at.lo, 1, 1e-6);
        EXPECT_EQ(rest[0].at.hi, 3);
    }
}

TEST(MonotoneTrack, NearlyRestsForOneSpan) {
    // Slower than doubles tell, and a value that is wide itself.
    for (const char* source : {"\"1e-14*sin(30*t)*abs(sin(40*t)) + min(t - 1, 0)\"",
                               "\"1e-7*sin(30*t)*abs(sin(40*t)) + min(t - 1, 0)\""}) {
        SCOPED_TRACE(source);
        const Times rest = times(source, {0, 3}, Interval(-1e-6, 1e-6));
        ASSERT_FALSE(rest.empty());
        EXPECT_LT(rest.size(), 10u);
        EXPECT_NEAR(rest[0].at.lo, 1, 1e-5);
        EXPECT_EQ(rest.back().at.hi, 3);
    }
}

TEST(MonotoneTrack, CrossesOnBothSidesOfAPole) {
    for (const double value : {-0.5, 0.5, 3.0}) {
        SCOPED_TRACE(value);
        const double first = std::atan(value);
        Times found = times("\"tan(t)\"", {-1, 5}, value);
        // At the poles there may be any value.
        std::erase_if(found, [](const auto& time) {
            return time.direction == 0 &&
                   (contains(time.at, M_PI / 2) || contains(time.at, 1.5 * M_PI));
        });
        std::vector<double> expected;
        for (const double t : {first, first + M_PI}) {
            if (-1 < t && t < 5) expected.push_back(t);
        }
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t k = 0; k < expected.size(); ++k) {
            EXPECT_NEAR(mid(found[k].at), expected[k], 1e-12);
            EXPECT_EQ(found[k].direction, 1);
        }
    }
}

} // namespace
} // namespace isomotion::topology
