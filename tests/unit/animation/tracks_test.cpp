#include <algorithm>
#include <cmath>

#include "animation/animation.h"
#include "formula/graph/limits.h"
#include "testing.h"

namespace isomotion::animation {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Tracks, AreNumbersExpressionsAndKeys) {
    const Animation animation({{"number", 0.1},
                               track("moving", "3 + 2*sin(2*pi*t/4)"),
                               {"keyed", Keys{{{0, 1}, {2, 5}}, Ease::linear}}},
                              {});
    for (const double t : {-1.0, 0.0, 0.5, 1.0, 1.9, 3.0}) {
        EXPECT_EQ(value(animation, "number", t), 0.1);
        EXPECT_NEAR(value(animation, "moving", t), 3 + 2 * std::sin(2 * M_PI * t / 4), 1e-14);
        EXPECT_NEAR(value(animation, "keyed", t), 1 + 2 * std::clamp(t, 0.0, 2.0), 1e-15);
        EXPECT_EQ(animation.at(t).time, t);
    }
}

TEST(Tracks, AreFoundByName) {
    const Animation animation({{"a", 1.0}, {"camera.fov", 2.0}}, {});
    EXPECT_EQ(animation.find("a"), 0);
    EXPECT_EQ(animation.find("camera.fov"), 1);
    EXPECT_EQ(animation.find("camera"), std::nullopt);
    EXPECT_EQ(animation.find(""), std::nullopt);
}

TEST(Tracks, NameOthersInAnyOrder) {
    std::vector<Track> tracks{track("a", "b + c"),
                              track("b", "2*c"),
                              {"c", Keys{{{0, 1}, {1, 2}}, Ease::linear}},
                              track("d", "a*b - t")};
    std::sort(tracks.begin(), tracks.end(),
              [](const Track& l, const Track& r) { return l.name < r.name; });
    do {
        const Animation animation(tracks, {});
        for (const double t : {0.0, 0.25, 1.0}) {
            const double c = 1 + t;
            EXPECT_EQ(value(animation, "c", t), c);
            EXPECT_EQ(value(animation, "b", t), 2 * c);
            EXPECT_EQ(value(animation, "a", t), 3 * c);
            EXPECT_EQ(value(animation, "d", t), 6 * c * c - t);
        }
    } while (std::next_permutation(tracks.begin(), tracks.end(),
                                   [](const Track& l, const Track& r) { return l.name < r.name; }));
}

TEST(Tracks, AChainOfReferencesMayBeLong) {
    constexpr int length = int(formula::limits::chain) - 1; // and the one they come to
    std::vector<Track> tracks;
    for (int k = 0; k < length; ++k) {
        tracks.push_back(track("a" + std::to_string(k), "a" + std::to_string(k + 1) + " + 1"));
    }
    tracks.push_back(track("a" + std::to_string(length), "t"));
    EXPECT_EQ(value(Animation(tracks, {}), "a0", 0.5), length + 0.5);
}

TEST(Tracks, MayNotDependOnThemselves) {
    const Complaint own = complaint({{"b", 1.0}, track("a", "b + 2*a")});
    EXPECT_EQ(own.owner, "a");
    EXPECT_EQ(own.message, "the value of 'a' depends on itself");

    const Complaint ring = complaint({track("a", "b"), track("b", "c"), track("c", "a + t")});
    EXPECT_THAT(ring.owner, testing::AnyOf("a", "b", "c"));
    EXPECT_EQ(ring.message, "the value of '" + ring.owner + "' depends on itself");

    // The blame falls on the ring and not on what leads to it.
    EXPECT_THAT(complaint({track("tail", "a"), track("a", "b"), track("b", "a")}).owner,
                testing::AnyOf("a", "b"));
}

TEST(Tracks, WrongExpressionsNameTheirOwnerAndThePlace) {
    const Complaint unknown = complaint({{"speed", 1.0}, track("m", "1 + spede")});
    EXPECT_EQ(unknown.owner, "m");
    EXPECT_EQ(unknown.message, "unknown name 'spede'; did you mean 'speed'?\n"
                               "    1 + spede\n"
                               "        ^");
    EXPECT_THAT(complaint({track("m", "1/0")}).message, HasSubstr("division by zero"));
    EXPECT_THAT(complaint({track("m", "")}).message, HasSubstr("a value is expected"));
    EXPECT_THAT(complaint({track("m", "2 +")}).message, HasSubstr("a value is expected"));
    EXPECT_THAT(complaint({track("m", "sin(t")}).message, HasSubstr("expected ')'"));
}

TEST(Tracks, KnowTimeAndNoPlaceInSpaceOrArray) {
    for (const char* name : {"x", "y", "z", "i", "n"}) {
        EXPECT_THAT(complaint({track("m", name)}).message,
                    HasSubstr("unknown name '" + std::string(name) + "'"));
    }
}

// A scene has some forty tracks like "camera.up.x" that no expression can name.
TEST(Tracks, SuggestionsAreNamesThatCanBeWritten) {
    const Complaint unknown =
        complaint({{"size", 1.0}, track("m", "quantity"), {"camera.fov", 40.0}});
    EXPECT_THAT(unknown.message, HasSubstr("known: t, size, m, pi\n"));
    EXPECT_THAT(complaint({track("m", "camera_fov"), {"camera.fov", 40.0}}).message,
                Not(HasSubstr("camera.fov")));
}

TEST(Tracks, ThatCannotBeNamedMayStillNameOthers) {
    const Animation animation({track("camera.fov", "10*m"), {"m", 4.0}, {"camera.up.x", 1.0}},
                              {{"blobs", 2, {field("r", "m + i")}}});
    EXPECT_EQ(value(animation, "camera.fov", 0), 40);
    EXPECT_THAT(column(animation, 0, 0), testing::ElementsAre(4, 5));
}

TEST(Tracks, AreReferencedByTracksAndFields) {
    const Animation animation({{"a", 1.0}, {"b", 1.0}, {"c", 1.0}, track("d", "a + t"), {"i", 1.0}},
                              {{"blobs", 2, {field("r", "2*b*i"), {"c", 3.0}, field("s", "r")}}});
    const auto referenced = [&](const char* name) {
        return animation.is_referenced(animation.find(name).value());
    };
    EXPECT_TRUE(referenced("a"));
    EXPECT_TRUE(referenced("b"));
    EXPECT_FALSE(referenced("c"));
    EXPECT_FALSE(referenced("d"));
    EXPECT_FALSE(referenced("i")); // in a field, i is the element's index
}

TEST(Tracks, RandomNumbersAreTheSeedsAndTheArguments) {
    const auto draw = [](const std::string& text, std::uint64_t seed) {
        return value(Animation({track("m", text)}, {}, seed), "m", 0.75);
    };
    EXPECT_EQ(draw("random(0, 0)", 0), 0.65244848637403219);
    EXPECT_EQ(draw("random(1, 0)", 0), 0.55272679084691956);
    EXPECT_EQ(draw("random(0, 1)", 0), 0.013996059553765816);
    EXPECT_EQ(draw("random(0, 0)", 1), 0.36818951565166946);
    EXPECT_EQ(draw("random(4*t, 2)", 5), draw("random(3, 2)", 5));
}

TEST(Tracks, NoTracksHaveNoValues) {
    EXPECT_TRUE(Animation().at(3).tracks.empty());
    EXPECT_TRUE(Animation({}, {}).at(3).arrays.empty());
}

} // namespace
} // namespace isomotion::animation
