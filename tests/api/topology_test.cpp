#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

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
    EXPECT_TRUE(found.complete) << found.summary();
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
    EXPECT_NE(found.json().find("isomotion topology timeline"), std::string::npos);
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
    ASSERT_EQ(found.events.size(), 1u) << found.summary();
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
    ASSERT_EQ(found.events.size(), 1u) << found.summary();
    EXPECT_EQ(found.events[0].kind, "birth");
    EXPECT_LE(found.events[0].time.low, 0.5);
    EXPECT_GE(found.events[0].time.high, 0.5);
    settings.touching = "a";
    EXPECT_EQ(told([&] { topology_of(two, settings); }).code, Error::Code::setting);
    EXPECT_EQ(told([&] { topology_of(two); }).code, Error::Code::input);
}

TEST(TopologyOf, TwoSurfacesTellsWhereTheyTouchInTheWorld) {
    const Scene two =
        Scene::parse("[time]\nfps = 10\nframes = 21\n"
                     "[[surfaces]]\nname = 'a'\nformula = 'x^2 + y^2 + z^2 - 1'\n"
                     "bounds = { sphere = 4 }\nplacement = { translate = [0, 0, 7] }\n"
                     "[[surfaces]]\nname = 'b'\nbounds = { sphere = 4 }\n"
                     "formula = '(x - d)^2 + y^2 + z^2 - 1'\nparameters = { d = '2.5 - t' }\n"
                     "placement = { translate = [0, 0, 7] }\n");
    TopologySettings settings{.surface = "a", .touching = "b"};
    EXPECT_NE(topology_plan(two, settings).find("(a, b)"), std::string::npos);
    const Topology found = topology_of(two, settings);
    EXPECT_NE(found.contact().find("(1, 0, 7)"), std::string::npos) << found.contact();
    EXPECT_EQ(found.solids, (std::vector<Solid>{{"a", true}, {"b", true}}));
    EXPECT_TRUE(topology_of(Scene::parse(meeting)).contact().empty());

    settings.certify = TopologySettings::Certify::fast;
    EXPECT_EQ(told([&] { topology_plan(two, settings); }).code, Error::Code::setting);
}

TEST(TopologyOf, TheOtherSideIsTheSolidIfAsked) {
    TopologySettings settings;
    settings.solid = {{.is_negative = false}};
    const Topology found = topology_of(Scene::parse(meeting), settings);
    EXPECT_EQ(found.start, (Betti{1, 0, 2}));
    EXPECT_EQ(found.solids, (std::vector<Solid>{{"", false}}));
}

TEST(TopologyOf, GridsGiveEventsThatAreNotProved) {
    TopologySettings settings{.certify = TopologySettings::Certify::off};
    settings.grid = 32;
    const Topology found = topology_of(Scene::parse(meeting), settings);
    EXPECT_FALSE(found.complete);
    EXPECT_EQ(found.start, (Betti{2, 0, 0}));
    EXPECT_EQ(found.end, (Betti{1, 0, 0}));
    for (const int grid : {7, 1025}) {
        settings.grid = grid;
        EXPECT_EQ(told([&] { topology_plan(Scene::parse(meeting), settings); }).code,
                  Error::Code::setting);
    }
    settings = {.grid = 32};
    EXPECT_EQ(told([&] { topology_plan(Scene::parse(meeting), settings); }).code,
              Error::Code::setting);
}

// A ball about a line of singular points.
TEST(TopologyOf, TellsPlacesThatItCannotResolve) {
    const Topology found = topology_of(
        Scene::parse("[time]\nfps = 10\nframes = 11\n[surface]\n"
                     "formula = '(x^2 + y^2)^2 - (T - 0.5)^3'\nbounds = { sphere = 1 }\n"
                     "[parameters]\nT = 't'\n"));
    ASSERT_FALSE(found.unresolved.empty()) << found.summary();
    EXPECT_FALSE(found.complete);
    EXPECT_FALSE(found.unresolved.front().why.empty());
    EXPECT_LE(found.unresolved.front().time.low, 0.5);
    EXPECT_GE(found.unresolved.front().time.high, 0.5);
}

TEST(TopologyOf, HasNumbersForEachFrame) {
    const std::string csv = topology_of(Scene::parse(meeting)).csv();
    EXPECT_EQ(std::ranges::count(csv, '\n'), 22);
    EXPECT_NE(csv.find("\n1,2,0,0,"), std::string::npos) << csv;
    EXPECT_NE(csv.find("\n21,1,0,0,"), std::string::npos) << csv;
}

class Checked : public testing::Test {
protected:
    Checked() { std::filesystem::create_directories(folder_); }
    ~Checked() override { std::filesystem::remove_all(folder_); }
    std::filesystem::path written(const std::string& text) const {
        const std::filesystem::path file = folder_ / "expected.json";
        std::ofstream(file) << text;
        return file;
    }
    static TopologyCheck checked(const Scene& scene, const std::filesystem::path& expected,
                                 double dt = 1e-9) {
        return Expectation(expected, scene).check(topology_of(scene), dt);
    }

    std::filesystem::path folder_ =
        std::filesystem::temp_directory_path() / "isomotion_api_topology_test";
};

TEST_F(Checked, AgainstAnEarlierRun) {
    using Outcome = TopologyCheck::Outcome;
    const Scene scene = Scene::parse(meeting);
    const auto file = written(topology_of(scene).json());
    EXPECT_EQ(checked(scene, file).outcome, Outcome::passes);
    // It merges 0.05 s later.
    const Scene later = scene.with("d", "2.05 - t");
    EXPECT_EQ(checked(later, file).outcome, Outcome::differs);
    EXPECT_EQ(checked(later, file, 0.06).outcome, Outcome::passes);
    EXPECT_EQ(told([&] { checked(scene, file, -1); }).code, Error::Code::input);
}

TEST_F(Checked, AgainstClaims) {
    using Outcome = TopologyCheck::Outcome;
    const Scene scene = Scene::parse(meeting);
    const TopologyCheck right = checked(
        scene, written(R"({"components": {"1": 2, "end": 1}, "events": ["merge", "no split"]})"));
    EXPECT_EQ(right.outcome, Outcome::passes) << right.summary;
    EXPECT_EQ(right.agreed, 4u);
    const TopologyCheck wrong = checked(scene, written(R"({"components": {"end": 2}})"));
    EXPECT_EQ(wrong.outcome, Outcome::differs);
    EXPECT_EQ(wrong.differences.size(), 1u);
    const Told mistake =
        told([&] { Expectation(written(R"({"events": ["mege"]})"), Scene::parse(meeting)); });
    EXPECT_EQ(mistake.code, Error::Code::input);
    EXPECT_NE(mistake.words.find("merge"), std::string::npos) << mistake.words;
}

TEST(PlotOf, HasPicturesIfThereIsADevice) {
    const auto pictures = [](const std::string& svg) {
        std::size_t count = 0;
        for (std::size_t at = 0; (at = svg.find("<image", at)) != svg.npos; ++at) ++count;
        return count;
    };
    const Topology found = topology_of(Scene::parse(meeting));
    const TopologyPlot plain = plot_of(found);
    EXPECT_TRUE(plain.svg.starts_with("<svg")) << plain.svg.substr(0, 100);
    EXPECT_EQ(pictures(plain.svg), 0u);
    Device device;
    const TopologyPlot drawn = plot_of(found, &device);
    EXPECT_EQ(drawn.why_incomplete, "");
    EXPECT_EQ(drawn.undrawn, 0);
    EXPECT_GE(pictures(drawn.svg), 2u);
    const TopologyPlot stopped = plot_of(found, &device, {.stop = [] { return true; }});
    EXPECT_EQ(pictures(stopped.svg), 0u);
    EXPECT_EQ(std::size_t(stopped.undrawn), pictures(drawn.svg));
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
                  Error::Code::setting);
    }
}

} // namespace
} // namespace isomotion
