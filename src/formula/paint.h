// A number at every place of a surface, by an expression of what a picture knows there.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formula/field.h"

namespace isomotion::formula {

// What a paint expression may name beside the surface's parameters and arrays; these go first.
// Positions and curvatures are in formula coordinates, the normal in world coordinates and towards
// F > 0; `evaluations` counts the field samples of the pixel's ray, `t` is in seconds.
//
// With n the unit normal towards F > 0, curvatures are those of div n: the sphere x^2+y^2+z^2-r^2
// has mean curvature +1/r, seen from either side.
inline const std::vector<std::string> paint_names{
    "x", "y", "z", "nx", "ny", "nz", "mean_curvature", "gaussian_curvature", "evaluations", "t"};

struct Paint {
    std::string text; // as the user wrote it
    Graph graph;
    Program value;                  // inputs: paint_names
    std::optional<Program> hessian; // of the field, if the expression names a curvature

    bool uses(std::string_view name) const; // one of paint_names
};

// `surface` is the vocabulary that `field` was made with. Throws ParseError, also for fields of
// arrays that the surface's own formula leaves out: a shader holds those it reads.
Paint make_paint(std::string_view text, Vocabulary surface, const Field& field);

// float paint_value(vec3 p, vec3 n, vec2 curvature, float evaluations); reads `paint_time`.
std::string glsl_paint_value(const Paint& paint, const ArrayPacking& packing);

} // namespace isomotion::formula
