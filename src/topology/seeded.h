// Critical points of a moving surface by Newton's method from near where tracks say that they are:
// most of them, soon. Each limit is then proved (isolate); that there are no others is not.
#pragma once

#include <functional>

#include "topology/search.h"

namespace isomotion::topology {

struct Seeding {
    int seeds = 1 << 16; // of a stratum with all coordinates free; fewer where there are fewer
    int threads = 1;     // the result doesn't depend on it
    std::function<bool()> stopped{};        // asked often, from any thread
    std::function<void(double)> progress{}; // part of the seeds that is done; see SharedLoop
};

// Found::unresolved holds limits without a proof, near each other put together; Found::work counts
// evaluations.
Found from_seeds(const MovingField& field, const Seeding& seeding);

} // namespace isomotion::topology
