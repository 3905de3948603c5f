// The real finite singular points of a polynomial surface, from its formula alone; finite is a
// radius below 1000.
//
// From many starts, evenly spread over the sphere of directions (homogeneous.h), the four first
// derivatives are brought to zero by Levenberg-Marquardt: their Jacobian is the Hessian, regular
// across an ordinary double point, where convergence is quadratic. (Newton's method on grad F = 0
// would also go to the critical points off the surface, of which there are more.) Where descent
// ends, |grad G| is either rounding, some 1e-15 of |Hess G|, or that of a local minimum.
//
// Nothing proves that a census is complete. It goes on until each node has been reached from many
// starts: if a node had been missed that attracts as much as the least one seen, with `hits` hits,
// that would be a chance of about exp(-hits).
#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "formula/field.h"

namespace isomotion {

struct SingularPoint {
    glm::dvec4 direction{0}; // unit vector along (position, 1)
    // Eigenvalues of Hess G across `direction`, ascending, as fractions of its size. Their signs
    // are those of Hess F.
    glm::dvec3 curvatures{0};
    int rank = 0; // of the Hessian: 3 at a node (A1); less at cusps, and along curves
    int hits = 1; // starts that ended here

    glm::dvec3 position() const { return glm::dvec3(direction) / direction.w; }
    double radius() const { return glm::length(position()); }
    // A definite node: the surface is this point alone, hereabouts.
    bool solitary() const { return rank == 3 && (curvatures.x > 0 || curvatures.z < 0); }
};

struct Census {
    int degree = 0;
    std::vector<SingularPoint> nodes;
    // Degenerate points are found less exactly: those nearer than 1e-2 to each other are one, so a
    // curve of them comes as a chain.
    std::vector<SingularPoint> degenerate;
    int starts = 0;
    bool settled = false; // not ended by most_starts
    // The least |grad G| / |Hess G| at which descent ended without a singular point.
    double nearest_miss = 1;
};

struct Effort {
    std::uint64_t seed = 1;
    int fewest_starts = 1 << 13;
    int most_starts = 1 << 18;
    int hits = 12; // of each node
};

// Throws std::invalid_argument if the field is no polynomial.
Census singular_points(const formula::Field& field, const formula::Bindings<double>& bindings,
                       const Effort& effort);

} // namespace isomotion
