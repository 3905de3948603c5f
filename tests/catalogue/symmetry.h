// Generators of symmetry groups, by name.
//
//   "x->-x"        reflection                     "inversion"    p -> -p
//   "x<->y"        exchange of two axes           "xyz cyclic"   x -> y -> z -> x
//   "x<->y, z->-z" both, a half turn about the diagonal
//   "C5(z)"        a fifth of a turn about an axis, likewise C2, C3, ...
//   "S4(z)"        a quarter of a turn and a reflection in the plane across
//   "revolution(z)"  any turn about an axis: three that are no fraction of a whole one
//   "C5(icosahedral b)"  a fifth of a turn about the vertex (1, 0, phi) of an icosahedron, phi
//                  being the golden ratio
#pragma once

#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace isomotion::catalogue {

// Throws std::invalid_argument for a name not listed above.
std::vector<glm::dmat3> maps_of(const std::string& generator);

} // namespace isomotion::catalogue
