// Finds most critical points of a moving surface fast: by Newton's method from near the places
// where tracks predict them. Each limit is then proved (isolate); that there are no others is not
// proved.
#pragma once

#include <functional>

#include "topology/search/search.h"

namespace isomotion::topology {

struct SeedOptions {
    int seeds = 1 << 16;             // for a stratum with all coordinates free; others get fewer
    int threads = 1;                 // the result doesn't depend on it
    std::function<bool()> stopped{}; // called often, from any thread
    std::function<void(double)> progress{}; // finished part of the seeds; see SharedLoop
};

// SearchResult::unresolved holds limits without a proof, merged if close to each other.
// SearchResult::work counts evaluations.
SearchResult from_seeds(const MovingField& field, const SeedOptions& seeding);

} // namespace isomotion::topology
