// The events of an animation, found and proved: all points (x, y, z, t) where the surface is
// singular, inside the bounds and along their faces and edges.
#pragma once

#include <cstdint>
#include <functional>

#include "formula/interval/interval.h"
#include "scene/scene.h"
#include "topology/field/solid.h"
#include "topology/timeline/event.h"

namespace isomotion::topology {

struct EventSearchOptions {
    double smallest = 1e-6; // box, as a part of the bounds and the range: see SearchOptions
    int threads = 1;        // the result doesn't depend on it
    // Above 0: so many seeds (from_seeds) in place of the search. That none is missing is then not
    // proved, and a doubt says so.
    int seeds = 0;
    std::function<bool()> stopped{};        // asked often, from any thread
    std::function<void(double)> progress{}; // part of the search that is done; see SharedLoop
};

struct SearchCost {
    std::int64_t boxes = 0; // or evaluations, from seeds
};

// Fills in the range, the events (their kinds where index and direction leave one, and Kind::none
// on the bounds where the solid doesn't change), what is unresolved, and whether anything may be
// missing. Start, end and the Betti numbers between are left to others.
//
// Times are those of the real functions that the scene's text says, not of the floats in which
// frames are drawn. A sphere for bounds has two strata, its inside and itself.
Timeline find_events(const scene::Scene& scene, Side side, formula::Interval range,
                     const EventSearchOptions& how = {}, SearchCost* cost = nullptr);

} // namespace isomotion::topology
