// Smooth solids that a ball about 0 of radius 1.2, or one near it, cuts, with their Betti numbers.
#pragma once

#include "topology/timeline/betti.h"

namespace isomotion::topology {

struct CutSolid {
    const char* formula;
    Betti betti;
};

inline const CutSolid cut_solids[] = {
    {"(x-0.5)^2 + y^2 + z^2 - 1", {1, 0, 0}},
    {"x - 0.3*y + 0.2*z - 0.1", {1, 0, 0}},
    {"0.16 - (x-0.2)^2 - y^2", {1, 1, 0}},
    {"0.04 - (x-0.2)^2 - y^2 - (z-0.1)^2", {1, 0, 1}},
    {"0.16 - (x-1.1)^2 - y^2 - z^2", {1, 0, 0}},
    {"0.01 - ((x-0.5)^2 + y^2 - 0.01)*((x+0.5)^2 + y^2 - 0.01)", {1, 2, 0}},
};

} // namespace isomotion::topology
