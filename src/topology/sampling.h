// Samples signs of F on a grid, frame by frame: fast, without proof.
#pragma once

#include <functional>
#include <optional>

#include "scene/scene.h"
#include "topology/field/solid.h"
#include "topology/timeline/event.h"

namespace isomotion::topology {

struct Sampling {
    int first = 1, last = 2; // frames
    // Vertices along each side of the grid. Unset: 64, or else the first of 32 and 16 with which
    // all frames take no more than most_operations, which is some 7 s of one core, for sines.
    std::optional<int> grid;
    double most_operations = 2.8e10;
    int threads = 0; // 0: as many as the machine runs at once
    std::function<void(double part)> progress;
    std::function<bool()> stopped;
};

// Two successive frames with different signs give an unresolved stretch of time. Throws SceneError
// if values leave their range, std::invalid_argument if even 16 vertices are too many.
Timeline sampled(const scene::OneSurface& one, Side solid, const Sampling& sampling);

} // namespace isomotion::topology
