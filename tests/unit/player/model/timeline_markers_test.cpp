#include "player/model/timeline_markers.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "scene/surfaces.h"
#include "topology/timeline/timeline_file.h"
#include "topology/timelines.h"
#include "unit/scene/testing.h"

namespace isomotion::player {
namespace {

using Kind = TimelineMarker::Kind;
using testing::HasSubstr;

// At ten frames a second, 101 of them, as the timelines made by hand have it.
const std::string ball = "[time]\nfps = 10\nframes = 101\n[surface]\n"
                         "formula = \"x^2 + y^2 + z^2 - radius^2\"\nbounds = { sphere = 1.5 }\n";

class Marks : public scene::Scenes {
protected:
    static topology::TimelineRecord of(const scene::Scene& scene, topology::TimelineRecord record) {
        record.header.fingerprint = topology::fingerprint(scene);
        return record;
    }
};

void expect_markers(const std::vector<TimelineMarker>& markers,
                    const std::vector<TimelineMarker>& expected) {
    ASSERT_EQ(markers.size(), expected.size());
    for (std::size_t k = 0; k < markers.size(); ++k) {
        EXPECT_EQ(markers[k].kind, expected[k].kind) << k;
        EXPECT_NEAR(markers[k].frame, expected[k].frame, 1e-9) << k;
        EXPECT_EQ(markers[k].label, expected[k].label) << k;
    }
}

TEST_F(Marks, KeysOfAllTracksAreMarkedOnceATime) {
    const scene::Scene scene = loaded(ball + R"toml([parameters]
radius = { keys = [[-1, 1], [0, 1], [2, 0.5], [3.05, 1], [10, 1], [10.1, 2]] }
[camera]
position = { keys = [[2, [4, 0, 0]], [5, [0, 4, 0]]] }
target = [0, { keys = [[5, 0], [6, 0.1]] }, 0]
fov = { keys = [[2, 30], [4, 40]] }
)toml");
    expect_markers(key_markers(scene),
                   {{Kind::key, 1, "key of radius"},
                    {Kind::key, 21, "keys of radius, camera.position, camera.fov"},
                    {Kind::key, 31.5, "key of radius"},
                    {Kind::key, 41, "key of camera.fov"},
                    {Kind::key, 51, "keys of camera.position, camera.target.y"},
                    {Kind::key, 61, "key of camera.target.y"},
                    {Kind::key, 101, "key of radius"}});
    expect_markers(key_markers(loaded(ball + "[parameters]\nradius = \"1 + t\"\n")), {});
}

TEST_F(Marks, EventsAreMarkedWithTheirKindAndFrame) {
    const scene::Scene scene = loaded(ball + "[parameters]\nradius = 1\n");
    const TopologyMarkers found = topology_markers(scene, of(scene, topology::story()), "a.json");
    EXPECT_EQ(found.refusal, "");
    expect_markers(found.markers, {{Kind::event, 10.5, "merge at frame 10.5"},
                                   {Kind::event, 20.25, "merge at frame 20.25"},
                                   {Kind::event, 40.2, "tunnel forms at frame 40.2"},
                                   {Kind::event, 90.7, "tunnel closes at frame 90.7"}});
    ASSERT_EQ(found.events.size(), 4u);
    for (std::size_t k = 0; k < 4; ++k)
        EXPECT_NEAR(found.events[k].first, found.markers[k].frame, 1e-9);
    EXPECT_EQ(found.events[3].kind, topology::Kind::tunnel_closes);
    EXPECT_NEAR(glm::distance(found.events[3].where, {0, 0.5, 0.1}), 0, 1e-12);
}

TEST_F(Marks, WhatIsNotKnownSaysSo) {
    const scene::Scene scene = loaded(ball + "[parameters]\nradius = 1\n");
    topology::TimelineRecord record = of(scene, topology::story());
    topology::Timeline& timeline = record.timeline;
    timeline.events[0].is_proved = false;
    timeline.events[1].kind = topology::Kind::unknown;
    timeline.events[2].kind = topology::Kind::none;
    timeline.events[3].time = {10.05, 10.15}; // past the last frame
    timeline.unresolved.push_back({{1.4, 1.6}, {}, "a singular curve", {}, {}});
    timeline.unresolved.push_back({{8, INFINITY}, {}, "no end is known", {}, {}});
    expect_markers(topology_markers(scene, record, "a.json").markers,
                   {{Kind::event, 10.5, "merge (not proved) at frame 10.5"},
                    {Kind::unresolved, 16, "unresolved (a singular curve) at frame 16"},
                    {Kind::event, 20.25, "event of unknown kind at frame 20.25"},
                    {Kind::unresolved, 91, "unresolved (no end is known) at frame 91"}});
    const auto& events = topology_markers(scene, record, "a.json").events;
    ASSERT_EQ(events.size(), 4u) << "two events and two places that are not resolved";
    EXPECT_FALSE(events[0].is_proved);
    EXPECT_TRUE(events[1].is_resolved);
    EXPECT_FALSE(events[2].is_resolved);
    EXPECT_NEAR(events[2].first, 15, 1e-9);
    EXPECT_NEAR(events[2].last, 17, 1e-9);
    // What may be anywhere has no place.
    record.timeline.unresolved[0].where[1] = formula::Interval::entire();
    EXPECT_EQ(topology_markers(scene, record, "a.json").events.size(), 3u);
}

// Each of several surfaces has a file of its own.
TEST_F(Marks, SeveralSurfacesHaveTheirEvents) {
    const scene::Scene scene = loaded(R"([time]
fps = 10
frames = 101
[[surfaces]]
name = "ball"
formula = "x^2 + y^2 + z^2 - 1"
bounds = { sphere = 1.5 }
[[surfaces]]
name = "pea"
formula = "x^2 + y^2 + z^2 - 0.1"
bounds = { sphere = 1 }
)");
    EXPECT_TRUE(read_topology_markers_of_each(scene).markers.empty());
    const auto write = [&](std::size_t surface, const std::string& name) {
        std::ofstream(timeline_path(scene, name))
            << topology::to_json(of(scene::alone({scene, surface}), topology::story()));
    };
    write(1, "pea");
    TopologyMarkers found = read_topology_markers_of_each(scene);
    ASSERT_EQ(found.markers.size(), 4u);
    EXPECT_EQ(found.markers[0].label, "pea: merge at frame 10.5");
    EXPECT_EQ(found.events.at(0).surface, 1);
    EXPECT_EQ(found.refusal, "");
    write(0, "ball");
    found = read_topology_markers_of_each(scene);
    EXPECT_EQ(found.events.size(), 8u);
    EXPECT_TRUE(std::ranges::is_sorted(found.markers, {}, &TimelineMarker::frame));
    // The files in each other's place.
    write(0, "pea");
    found = read_topology_markers_of_each(scene);
    EXPECT_EQ(found.events.size(), 4u);
    EXPECT_THAT(found.refusal, HasSubstr("--surface pea -o "));
}

// Events are moments: another frame rate shows the same ones at other frames.
TEST_F(Marks, TimesBecomeTheScenesFrames) {
    const scene::Scene scene =
        loaded("[time]\nfps = 20\nframes = 201\n" + ball.substr(ball.find("[surface]")) +
               "[parameters]\nradius = 1\n");
    const auto found = topology_markers(scene, of(scene, topology::story()), "a.json");
    ASSERT_EQ(found.markers.size(), 4u);
    EXPECT_EQ(found.markers[0].label, "merge at frame 20");
}

TEST_F(Marks, ATimelineOfAnotherSceneIsRefused) {
    const scene::Scene scene = loaded(ball + "[parameters]\nradius = 1\n");
    const topology::TimelineRecord record = of(scene, topology::story());
    const auto is_refused = [&](const std::string& text) {
        const TopologyMarkers found = topology_markers(loaded(text), record, "a.json");
        EXPECT_EQ(found.refusal.empty(), !found.markers.empty());
        return !found.refusal.empty();
    };
    EXPECT_FALSE(is_refused(ball + "[parameters]\nradius = 1\n[camera]\nfov = 20\n"));
    EXPECT_TRUE(is_refused(ball + "[parameters]\nradius = 1.01\n"));
    EXPECT_TRUE(is_refused(ball + "[parameters]\nradius = \"1 + t\"\n"));
    EXPECT_THAT(
        topology_markers(loaded(ball + "[parameters]\nradius = 2\n"), record, "a.json").refusal,
        HasSubstr("a.json: is of another scene than is shown"));
}

TEST_F(Marks, AreReadFromTheFileBesideTheScene) {
    const scene::Scene scene = loaded(ball + "[parameters]\nradius = 1\n");
    EXPECT_EQ(timeline_path(scene), folder() / "scene.timeline.json");
    EXPECT_TRUE(read_topology_markers(scene, timeline_path(scene)).markers.empty());
    EXPECT_EQ(read_topology_markers(scene, timeline_path(scene)).refusal, "")
        << "there is none, and that is all right";

    write("scene.timeline.json", topology::to_json(of(scene, topology::story())));
    EXPECT_EQ(read_topology_markers(scene, timeline_path(scene)).markers.size(), 4u);
    EXPECT_EQ(read_topology_markers(scene, timeline_path(scene)).refusal, "");

    write("scene.timeline.json", topology::to_json(topology::story()));
    EXPECT_THAT(read_topology_markers(scene, timeline_path(scene)).refusal,
                HasSubstr("another scene"));

    for (const std::string broken : {"", "{", "[1, 2]", "{\"format\": \"something else\"}"}) {
        write("scene.timeline.json", broken);
        const TopologyMarkers found = read_topology_markers(scene, timeline_path(scene));
        EXPECT_THAT(found.refusal, HasSubstr("scene.timeline.json")) << broken;
        EXPECT_TRUE(found.markers.empty());
    }
    std::filesystem::remove(folder() / "scene.timeline.json");
    std::filesystem::create_directory(folder() / "scene.timeline.json");
    EXPECT_NE(read_topology_markers(scene, timeline_path(scene)).refusal, "");
}

// A timeline that the program itself made of a scene of the gallery.
TEST_F(Marks, GoldenTimelinesBelongToTheirScenes) {
    ::setenv("ISOMOTION_DATA", ISOMOTION_SOURCE_DIR, 1);
    for (const std::string name : {"torus", "tangle", "ding_dong"}) {
        SCOPED_TRACE(name);
        const scene::Scene scene = scene::load(name);
        const auto record =
            topology::read_timeline(std::string(ISOMOTION_SOURCE_DIR) + "/tests/topology/golden/" +
                                    name + ".timeline.json");
        const TopologyMarkers found = topology_markers(scene, record, name);
        EXPECT_EQ(found.refusal, "");
        EXPECT_FALSE(found.markers.empty());
        EXPECT_TRUE(std::ranges::is_sorted(found.markers, {}, &TimelineMarker::frame));
        EXPECT_LE(found.markers.size(),
                  record.timeline.events.size() + record.timeline.unresolved.size());
    }
}

} // namespace
} // namespace isomotion::player
