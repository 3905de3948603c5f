// Formulas of well-known surfaces: what the compiler has to get right in practice.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "formula/field.h"
#include "testing.h"
#include "unit/surface_formulas.h"

namespace isomotion::formula {

// Where a surface of the catalogue has no derivative to compare with.
enum class Kink {
    none,
    axis,    // sqrt(x^2 + y^2) is a cone over the z axis
    planes,  // |x|^m with m < 1 is infinitely steep at x = 0
    centres, // 1/r^2 has a pole
};

struct CatalogueSurface : SurfaceFormula {
    Kink kink = Kink::none;
};

inline void PrintTo(const CatalogueSurface& surface, std::ostream* out) { *out << surface.name; }

const std::vector<CatalogueSurface>& catalogue();

struct CatalogueField {
    explicit CatalogueField(const CatalogueSurface& surface);
    Field field;
    Bindings<double> bindings;
};

// The origin, points on the axes and diagonals, and corners of the picture.
std::vector<Point> nasty_points(double reach);
bool at_kink(const CatalogueSurface& surface, const Point& p);

} // namespace isomotion::formula
