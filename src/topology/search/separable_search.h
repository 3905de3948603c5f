// Finds all critical points in one stratum of a moving surface whose formula is a sum of functions
// of x, of y, of z and of the clock (separable.h).
//
// Along each free axis all points are found at which that axis' term has slope 0. Each combination
// of these has one value, and the term of the clock tells when F is 0 there. So points are found
// along lines and never searched for in space, however many there are.
#pragma once

#include <optional>

#include "topology/search/search.h"

namespace isomotion::topology {

struct SeparableResult {
    MovingField field;
    SearchResult found; // nothing is unresolved
};

// Empty if the formula is no such sum, or if not all points are found and proved in this way.
std::optional<SeparableResult> search_separable(const Motion& motion, const Stratum& stratum,
                                                const SearchOptions& searching);

} // namespace isomotion::topology
