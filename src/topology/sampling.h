// Signs of F on a grid, frame by frame: fast, and no proof.
#pragma once

#include <functional>
#include <optional>

#include "scene/scene.h"
#include "topology/field/solid.h"
#include "topology/timeline/event.h"

namespace isomotion::topology {

struct Sampling {
    int first = 1, last = 2; // frames
    // Vertices along each side of the grid. Without it 64, or the first of 32 and 16 with which all
    // frames take no more than so many operations: some 7 s of one core, of sines.
    std::optional<int> grid;
    double most_operations = 2.8e10;
    int threads = 0; // 0: as many as the machine runs at once
    std::function<void(double part)> progress;
    std::function<bool()> stopped;
};

// Two frames whose signs differ are an unresolved stretch of time. Throws SceneError where values
// leave their range, std::invalid_argument where 16 vertices are too many.
Timeline sampled(const scene::Scene& scene, Side solid, const Sampling& sampling);

} // namespace isomotion::topology
