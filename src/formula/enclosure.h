// What a field's formula and its derivatives can be over a box: the programs for intervals.
//
// They differ from Field's own programs, which numbers run, in two ways. chebyshev stays whole, for
// its enclosure is exact where that of its products is useless. And slopes are generalized
// (derivative.h): over a box, `along` and `gradient` enclose not only the derivatives but all
// difference quotients between points of the box, also across kinks and ends of roots. Over boxes
// that may hold a jump or a pole they are the entire line. So where dF/dt has a bound F is
// continuous, and where it doesn't hold 0, a ray has at most one root, whatever the formula. Values
// are the entire line over boxes with points where F has none.
//
//     const EnclosurePrograms programs = enclosure_programs(field);
//     Evaluator<Interval> along(programs.directional);
//     const std::array<Interval, 6> ray{Interval(0, 0.1), y, z, dx, dy, dz};
//     std::array<Interval, 2> f; // F and dF/dt
//     along.point(convert<Interval>(bindings), ray, f);
#pragma once

#include <optional>

#include "formula/field.h"
#include "formula/sums_apart.h"

namespace isomotion::formula {

// Inputs and outputs as in Field.
struct EnclosurePrograms {
    Program value;
    Program directional;
    Program gradient;
    // 0 where F is continuous, else the entire line (graph/continuity.h), of walls where F has no
    // bounds; and a number above 0 over boxes where F has no value anywhere.
    Program jumps;
    Program breaks; // both, also of walls where F jumps
    // The value, and 0 where F is smooth, else the entire line (graph/roughness.h).
    Program rough;
    bool may_lack_values = false; // else the second output of `jumps` is always 0
};

EnclosurePrograms enclosure_programs(const Field& field);
Program value_enclosure(const Field& field); // the first of them alone

// The first four with the sums over an array apart.
struct EnclosuresApart {
    SumsApart value, directional, gradient, jumps;
    std::vector<NodeId> sums_of_field; // those of each program that F itself has are among these
    bool may_lack_values = false;
};

// The sums over an array that F itself has, as programs of its enclosures name them
// (Instruction::second of begin).
std::vector<NodeId> own_sums(const Field& field, int array);

// None if a sum over the array holds another sum or lies in one.
std::optional<EnclosuresApart> enclosures_apart(const Field& field, int array);

// For polynomials: F, dF/dt and the gradient of dF/dt, inputs as of `directional`. Centred about a
// point of the box, dF/dt is bounded by the latter as closely as its terms, which cancel, are not.
// None of other fields, where a second derivative may have no bound, or, of chebyshev, only a poor
// one.
std::optional<Program> hessian_program(const Field& field);

} // namespace isomotion::formula
