// Critical points of a moving surface by Newton's method from near where tracks say that they are:
// most of them, soon. Each limit is then proved (isolate); that there are no others is not.
#pragma once

#include <functional>

#include "topology/search/search.h"

namespace isomotion::topology {

struct SeedOptions {
    int seeds = 1 << 16; // for a stratum with all coordinates free, and fewer for others
    int threads = 1;     // the result doesn't depend on it
    std::function<bool()> stopped{};        // asked often, from any thread
    std::function<void(double)> progress{}; // part of the seeds that is done; see SharedLoop
};

// SearchResult::unresolved holds limits without a proof, near each other put together;
// SearchResult::work counts evaluations.
SearchResult from_seeds(const MovingField& field, const SeedOptions& seeding);

} // namespace isomotion::topology
