#include <cmath>

#include "api/error_code.h"

namespace isomotion {
namespace {

// Two balls of radius 1 move together: they merge when their centres are 2 apart.
constexpr const char* meeting = R"([time]
fps = 10
frames = 21
[surface]
formula = "min((x - d)^2 + y^2 + z^2, (x + d)^2 + y^2 + z^2) - 1"
bounds = { box = [[-4, -2, -2], [4, 2, 2]] }
[parameters]
d = "2 - t"
)";

TEST(TopologyOf, TwoBallsIsProved) {
    const Topology found = topology_of(Scene::parse(meeting));
    EXPECT_TRUE(found.complete) << found.summary;
    EXPECT_TRUE(found.doubts.empty());
    EXPECT_EQ(found.start, (Betti{2, 0, 0}));
    EXPECT_EQ(found.end, (Betti{1, 0, 0}));
    ASSERT_EQ(found.events.size(), 1u);
    const TopologyEvent& merge = found.events.front();
    EXPECT_EQ(merge.kind, "merge");
    EXPECT_TRUE(merge.proved);
    EXPECT_LE(merge.time.low, 1);
    EXPECT_GE(merge.time.high, 1);
    EXPECT_EQ(merge.before, (Betti{2, 0, 0}));
    EXPECT_EQ(merge.after, (Betti{1, 0, 0}));
    for (const Interval& side : merge.where) {
        EXPECT_LE(side.low, 0);
        EXPECT_GE(side.high, 0);
    }
    EXPECT_NE(found.json.find("isomotion topology timeline"), std::string::npos);
}

TEST(TopologyOf, APartOfTheFrames) {
    TopologySettings before;
    before.last = 9;
    EXPECT_TRUE(topology_of(Scene::parse(meeting), before).events.empty());
}

// Bounds that are found hold all frames that are searched: this one's balls leave those of its own
// five frames.
TEST(TopologyOf, FramesBeyondTheLastHasBoundsOfThem) {
    const Scene parting =
        Scene::parse("[time]\nfps = 30\nframes = 5\n[parameters]\nd = '0.2 + t'\n[surface]\n"
                     "formula = 'min((x - d)^2 + y^2 + z^2, (x + d)^2 + y^2 + z^2) - 0.25'\n");
    TopologySettings settings;
    settings.last = 41;
    const Topology found = topology_of(parting, settings);
    ASSERT_EQ(found.events.size(), 1u) << found.summary;
    EXPECT_EQ(found.events[0].kind, "split");
    EXPECT_EQ(found.end, (Betti{2, 0, 0}));
}

TEST(TopologyOf, WarnsOfADivisorThatIs0) {
    std::string warning;
    const Watcher watcher{.warn = [&](const std::string& words) { warning = words; }};
    topology_of(Scene::parse("[time]\nframes = 2\n[surface]\nbounds = { sphere = 1 }\n"
                             "formula = 'x^2/m + y^2 - 1'\n[parameters]\nm = 't'\n"),
                {}, watcher);
    EXPECT_NE(warning.find("parameters.m is 0"), std::string::npos) << warning;
}

TEST(TopologyOf, TwoSurfacesIsWhereTheyTouch) {
    const Scene two = Scene::parse("[time]\nfps = 10\nframes = 21\n"
                                   "[[surfaces]]\nname = 'a'\nformula = 'x^2 + y^2 + z^2 - 1'\n"
                                   "bounds = { sphere = 4 }\n"
                                   "[[surfaces]]\nname = 'b'\nbounds = { sphere = 4 }\n"
                                   "formula = '(x - d)^2 + y^2 + z^2 - 1'\n"
                                   "parameters = { d = '2.5 - t' }\n");
    TopologySettings settings;
    settings.surface = "a";
    EXPECT_TRUE(topology_of(two, settings).events.empty());
    settings.touching = "b";
    const Topology found = topology_of(two, settings);
    ASSERT_EQ(found.events.size(), 1u) << found.summary;
    EXPECT_EQ(found.events[0].kind, "birth");
    EXPECT_LE(found.events[0].time.low, 0.5);
    EXPECT_GE(found.events[0].time.high, 0.5);
    settings.touching = "a";
    EXPECT_EQ(told([&] { topology_of(two, settings); }).code, Error::Code::input);
    EXPECT_EQ(told([&] { topology_of(two); }).code, Error::Code::input);
}

TEST(TopologyOf, AStoppedSearchIsIncomplete) {
    const Topology found = topology_of(Scene::parse(meeting), {}, {.stop = [] { return true; }});
    EXPECT_FALSE(found.complete);
    EXPECT_FALSE(found.doubts.empty());
}

TEST(TopologyOf, FramesThatAreNoneAreMistakes) {
    for (const auto& [first, last] : {std::pair(0, 3), {4, 4}, {5, 2}}) {
        TopologySettings settings;
        settings.first = first;
        settings.last = last;
        EXPECT_EQ(told([&] { topology_of(Scene::parse(meeting), settings); }).code,
                  Error::Code::input);
    }
}

} // namespace
} // namespace isomotion
