// Finds all critical points in one stratum of a moving surface whose formula has kinks: by branch
// and prune, as search.h, over the smooth formulas that it consists of (kinks.h).
//
// A box is discarded if F rises along one direction on all sides of the kinks in the box: then 0 is
// in no hull of active slopes (Clarke 1983). A box is finished if each smooth formula of its kinks
// provably has no critical point in it, or one.
#pragma once

#include <memory>
#include <vector>

#include "topology/search/search.h"
#include "topology/search/selection.h"

namespace isomotion::topology {

struct KinkedPoint {
    std::shared_ptr<const Selection> of;
    CriticalPoint point; // of its field
    // The index of F across the kinks: the number of directions in which it falls to both sides
    // (Agrachev, Pallaschke and Scholtes 1997).
    int index_across = 0;
    std::vector<char> path; // identifies the formula
};

struct KinkedResult {
    std::vector<KinkedPoint> points; // by clock
    // There are no other points outside of these boxes. They have free coordinates and the clock of
    // `field`.
    std::vector<Box> unresolved;
    std::shared_ptr<const MovingField> field; // F itself
    Work work;
};

KinkedResult search_kinked(const Motion& motion, const Stratum& stratum,
                           const SearchOptions& searching);

} // namespace isomotion::topology
