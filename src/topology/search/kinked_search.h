// All critical points of a moving surface whose formula has kinks, in one stratum: by branch and
// prune, as search.h, over the smooth formulas that it is made of (kinks.h).
//
// A box is left where there is a direction along which F rises everywhere, on all sides of the
// kinks in the box: 0 is then in no hull of active slopes (Clarke 1983). It is done where each
// smooth formula of its kinks provably has no critical point in it, or one.
#pragma once

#include <memory>
#include <vector>

#include "topology/search/search.h"
#include "topology/search/selection.h"

namespace isomotion::topology {

struct KinkedPoint {
    std::shared_ptr<const Selection> of;
    CriticalPoint point; // of its field
    // The index of F across the kinks: how many directions it falls in, to both sides (Agrachev,
    // Pallaschke and Scholtes 1997).
    int index_across = 0;
    std::vector<char> path; // tells formulas apart
};

struct KinkedResult {
    std::vector<KinkedPoint> points; // by clock
    // Outside of these, no other points. Free coordinates and the clock, as boxes of `field`.
    std::vector<Box> unresolved;
    std::shared_ptr<const MovingField> field; // F itself
    Work work;
};

KinkedResult search_kinked(const Motion& motion, const Stratum& stratum,
                           const SearchOptions& searching);

} // namespace isomotion::topology
