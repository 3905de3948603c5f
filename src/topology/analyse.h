// The timeline of a scene: every change of the topology of its surface within the bounds.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "scene/scene.h"
#include "topology/timeline/event.h"

namespace isomotion::topology {

enum class Certify {
    off,  // sample: signs of F on a grid, frame by frame; nothing is proved
    fast, // events from seeds, each proved, their kinds where the index tells, and signs on a grid
          // at both ends; events may be missing
    full, // prove all that can be
};

struct AnalyseOptions {
    Certify certify = Certify::full;
    int first = 1, last = 0; // frames, first < last; 0: the scene's last
    // Vertices along each side of grids; none: as sampling.h says for `off`, 128 for `fast`.
    std::optional<int> grid;
    int threads = 0; // 0: as many as the machine runs at once
    // Called from one thread at a time; `part` in [0, 1] of what `what` is, which doesn't fall.
    std::function<void(const std::string& what, double part)> progress;
    // Asked often, from one thread at a time. Once true, the timeline returned has what is known so
    // far: it is not proved and its doubts say why.
    std::function<bool()> stop;
};

// The timeline's range is from the time of the first frame to that of the last. The same for any
// number of threads. Throws SceneError where values leave their range, std::invalid_argument where
// a sample of all frames takes too much.
Timeline analyse(const scene::Scene& scene, const AnalyseOptions& how = {});

} // namespace isomotion::topology
