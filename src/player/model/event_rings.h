// Where in the picture the topology changes: rings around the places of events, in the frames
// around their own.
#pragma once

#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "scene/scene_at.h"
#include "topology/timeline/event.h"

namespace isomotion::player {

struct PlacedEvent {
    double first = 1, last = 1; // frames, the same for an event; an unresolved place may last
    topology::Kind kind = topology::Kind::unknown;
    bool is_resolved = true, is_proved = true;
    glm::dvec3 where{0}; // formula coordinates of its surface
    int surface = 0;     // of the scene's surfaces
};

// The ring of an event is in the picture for so many frames before and after it.
inline constexpr double ring_frames = 4;
inline constexpr std::size_t most_rings = 60;

// Where the camera shows a point of the world, in heights of the picture from its centre, to the
// right and up. None for a point that is not before the eye, or before the plane of an orthographic
// camera's.
std::optional<glm::dvec2> projected(const scene::CameraAt& camera, const glm::dvec3& world);

struct Ring {
    std::size_t event = 0; // its position in the list
    glm::dvec2 at{0};      // as of projected()
    double nearness = 1;   // 1 in the event's own frame, falls to 0 where the ring vanishes
};

// The rings that are in a picture of this width / height, the nearest in time first. A place moves
// with its surface: `now` is the scene at the frame. At most `most_rings`.
std::vector<Ring> rings(const std::vector<PlacedEvent>& events, const scene::SceneAt& now,
                        double frame, double aspect);

} // namespace isomotion::player
