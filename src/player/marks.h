// Marks on a timeline: where keys are and where topology changes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "topology/timeline/timeline_header.h"

namespace isomotion::player {

struct Mark {
    enum class Kind { key, event, unresolved };
    Kind kind = Kind::key;
    double frame = 1;  // counts from 1, has a fraction
    std::string label; // "keys of m, camera.position", "merge at frame 12.41"
};

// Of every track, one mark for all that have a key at that time; within the scene's frames, in
// their order.
std::vector<Mark> key_marks(const scene::Scene& scene);

// Of what is known of the scene's topology: events (also those that are not proved, which say so)
// and places where something is not told apart. Events on the bounds that change nothing are left
// out. Or why nothing can be marked.
struct TopologyMarks {
    std::vector<Mark> marks;
    std::string refusal; // empty unless there is a timeline that is not this scene's, or is broken
};
// A timeline of another scene (by its fingerprint) is refused: its events are not this scene's. So
// are they not when a parameter is released.
TopologyMarks topology_marks(const scene::Scene& scene, const topology::TimelineRecord& record,
                             const std::string& file);
// Without such a file, nothing.
TopologyMarks read_topology_marks(const scene::Scene& scene, const std::filesystem::path& file);
// NAME.timeline.json beside NAME.toml.
std::filesystem::path timeline_path(const scene::Scene& scene);

} // namespace isomotion::player
