// A polynomial field seen on the sphere of directions, where infinity is no farther than any place.
//
// For F of degree d, G(x, y, z, w) = w^d F(x/w, y/w, z/w) is homogeneous, so X and its multiples
// are one point and |X| = 1 may be assumed: the finite points are a half sphere S^3. All partial
// derivatives of G follow from those of F by Euler's identity, d G = X . grad G. A point is
// singular where the four first ones vanish, which F and its three do together; but the four have
// one degree, so that one number, |grad G| on the sphere, tells how far from singular a point is,
// however F is scaled and however far out the point lies.
#pragma once

#include "nodes/second_order.h"

namespace isomotion {

struct Homogeneous {
    glm::dvec4 gradient{0};
    glm::dmat4 hessian{0};
};

// The derivatives of G at the unit vector along (x, 1).
Homogeneous homogenise(const SecondOrder& f, const glm::dvec3& x, int degree);

// The degree of a polynomial, from its growth far away. Throws std::invalid_argument for a field
// that does not grow like one.
int degree_of(SecondOrderField& field);

// Columns: an orthonormal basis of what is orthogonal to the unit vector `p`.
glm::dmat3x4 tangent_basis(const glm::dvec4& p);

// The eigenvalues of a symmetric matrix, ascending, each to the rounding of the largest.
glm::dvec3 eigenvalues(glm::dmat3 symmetric);

} // namespace isomotion
