// Computes the timeline of a scene: every change of the topology of its surface within the bounds.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>

#include "scene/scene.h"
#include "topology/field/solid.h"
#include "topology/timeline/event.h"

namespace isomotion::topology {

enum class Certify {
    off,  // sample: signs of F on a grid, frame by frame; nothing is proved
    fast, // proved events from seeds, with kinds where the index determines them, and signs on a
          // grid at both ends; events may be missing
    full, // prove as much as possible
};

struct AnalyseOptions {
    Certify certify = Certify::full;
    int first = 1, last = 0; // frames, first < last; 0 stands for the scene's last
    // Vertices along each side of grids. Unset: as sampling.h says for `off`, 128 for `fast`.
    std::optional<int> grid;
    int threads = 0; // 0: as many as the machine runs at once
    // The solids of the surface, or of both surfaces of a contact. Unset: as solid_side() says.
    std::array<std::optional<Side>, 2> solids{};
    // Called from one thread at a time. `part` in [0, 1] is the finished part of the step `what`;
    // it never decreases.
    std::function<void(const std::string& what, double part)> progress;
    // Called often, from one thread at a time. Once it returns true, the timeline holds what is
    // known so far: it is not proved, and its doubts say why.
    std::function<bool()> stop;
};

// The timeline's range is from the time of the first frame to that of the last. The result is the
// same for any number of threads. Throws SceneError if values leave their range, and
// std::invalid_argument if sampling all frames takes too many operations.
Timeline analyse(const scene::OneSurface& one, const AnalyseOptions& how = {});

// The timeline of what two surfaces of one scene have in common. A birth is a place where they
// touch, a death one where they part. Coordinates are the first one's. Only with Certify::full,
// otherwise throws std::invalid_argument.
Timeline analyse_contact(const scene::OneSurface& first, const scene::OneSurface& second,
                         const AnalyseOptions& how = {});

} // namespace isomotion::topology
