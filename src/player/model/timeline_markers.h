// Markers on a timeline: its keys, and the changes of topology.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "player/model/event_rings.h"
#include "scene/scene.h"
#include "topology/timeline/timeline_header.h"

namespace isomotion::player {

struct TimelineMarker {
    enum class Kind { key, event, unresolved };
    Kind kind = Kind::key;
    double frame = 1;  // counts from 1, has a fraction
    std::string label; // "keys of m, camera.position", "merge at frame 12.41"
};

// One marker for all tracks that have a key at the same time, in order, within the scene's frames.
std::vector<TimelineMarker> key_markers(const scene::Scene& scene);

// Markers of a scene's topology: events, with a note if they are not proved, and unresolved places.
// Leaves out events on the bounds that change nothing.
struct TopologyMarkers {
    std::vector<TimelineMarker> markers;
    std::vector<PlacedEvent> events; // the same, with their places
    std::string refusal; // why a timeline was refused: of another scene, or broken; otherwise empty
};
// Refuses the timeline of another surface, by its fingerprint.
TopologyMarkers topology_markers(const scene::OneSurface& one,
                                 const topology::TimelineRecord& record, const std::string& file);
// No markers and no refusal if there is no such file.
TopologyMarkers read_topology_markers(const scene::OneSurface& one,
                                      const std::filesystem::path& file);
// NAME.timeline.json beside NAME.toml.
std::filesystem::path timeline_path(const scene::Scene& scene);
// The same for one of several surfaces, by its name: NAME.SURFACE.timeline.json.
std::filesystem::path timeline_path(const scene::Scene& scene, const std::string& surface);
// What such files of each surface hold, together; labels begin with the surface's name.
TopologyMarkers read_topology_markers_of_each(const scene::Scene& scene);

} // namespace isomotion::player
