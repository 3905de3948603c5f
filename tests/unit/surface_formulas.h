// The formulas of the surfaces that the adaptive marching points paper names, and their variants.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace isomotion {

struct SurfaceFormula {
    std::string name;
    std::string text; // may sum over `blobs` with fields ux, uy, uz
    std::vector<std::pair<std::string, double>> parameters;
    double reach; // coordinates of the picture lie in [-reach, reach]
};

const std::vector<SurfaceFormula>& surface_formulas();

} // namespace isomotion
