// Finds and proves the events of an animation: all points (x, y, z, t) where the surface is
// singular, inside the bounds and along their faces and edges.
#pragma once

#include <cstdint>
#include <functional>

#include "formula/interval/interval.h"
#include "scene/scene.h"
#include "topology/field/motion.h"
#include "topology/field/solid.h"
#include "topology/timeline/event.h"

namespace isomotion::topology {

struct EventSearchOptions {
    // Smallest box, as a fraction of the bounds and the range: see SearchOptions.
    double smallest = 1e-6;
    int threads = 1; // the result doesn't depend on it
    // If above 0, the number of seeds (from_seeds) that replace the search. Then completeness is
    // not proved, and a doubt says so.
    int seeds = 0;
    std::function<bool()> stopped{};        // called often, from any thread
    std::function<void(double)> progress{}; // finished part of the search; see SharedLoop
};

struct SearchCost {
    std::int64_t boxes = 0; // or evaluations, with seeds
};

// Sets the range, the events, unresolved places, and whether events may be missing. Kinds are set
// where index and direction leave one, and to Kind::none on the bounds where the solid doesn't
// change. Others set start, end and the Betti numbers in between.
//
// Times are those of the real functions that the scene's text states, not of the floats with which
// frames are drawn. Spherical bounds have two strata, the inside and the sphere.
Timeline find_events(const scene::OneSurface& one, Side side, formula::Interval range,
                     const EventSearchOptions& how = {}, SearchCost* cost = nullptr);
// The same for a solid whose motions go by time.
Timeline find_events(const Motions& all, formula::Interval range,
                     const EventSearchOptions& how = {}, SearchCost* cost = nullptr);

} // namespace isomotion::topology
