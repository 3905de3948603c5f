// Enclosures of a field's formula and its derivatives over a box: the programs for intervals.
//
// They differ from Field's own programs, which evaluate numbers, in two ways. First, chebyshev is
// not lowered, since its own enclosure is exact where that of its products is useless. Second,
// slopes are generalized (derivative.h): over a box, `directional` and `gradient` enclose all
// difference quotients between points of the box, also across kinks and ends of roots. Over boxes
// that may hold a jump or a pole they are the entire line. So where dF/dt is bounded, F is
// continuous; and where it doesn't hold 0, a ray has at most one root, whatever the formula. Values
// are the entire line over boxes with points where F has no value.
//
//     const EnclosurePrograms& programs = enclosure_programs(field);
//     Evaluator<Interval> along(programs.directional);
//     const std::array<Interval, 6> ray{Interval(0, 0.1), y, z, dx, dy, dz};
//     std::array<Interval, 2> f; // F and dF/dt
//     along.point(convert<Interval>(bindings), ray, f);
#pragma once

#include <optional>

#include "formula/field.h"
#include "formula/sums_apart.h"

namespace isomotion::formula {

// Inputs and outputs are those of Field.
struct EnclosurePrograms {
    Program value;
    Program directional;
    Program gradient;
    // The first output is 0 where F is continuous, otherwise the entire line (graph/continuity.h);
    // where jumps count as walls, it is the entire line where F has no bounds. The second is a
    // number above 0 over boxes where F has no value anywhere, or keeps off 0 beside its poles.
    Program jumps;
    // For marching: as `jumps`, but jumps of F that count as walls included. The second output is
    // also above 0 where F may jump at every point, as a divisor is 0 everywhere.
    Program breaks;
    // The value, and 0 where F is smooth, otherwise the entire line (graph/roughness.h).
    Program rough;
    bool may_lack_values = false; // or have poles; if false, the second output of `jumps` is 0
};

// They are derived when they are first asked for, by any thread, and live as long as the field or a
// copy of it.
const EnclosurePrograms& enclosure_programs(const Field& field);
const EnclosurePrograms& enclosure_programs(const Field&&) = delete;
const Program& value_enclosure(const Field& field); // only the first of them
const Program& value_enclosure(const Field&&) = delete;

// The first four programs with the sums over an array separated.
struct EnclosuresApart {
    SumsApart value, directional, gradient, jumps;
    std::vector<NodeId> sums_of_field; // the sums that F itself has are among these
    bool may_lack_values = false;
};

// The sums over an array that F itself has, identified as in the programs of its enclosures
// (Instruction::second of begin).
std::vector<NodeId> own_sums(const Field& field, int array);

// None if a sum over the array holds another sum or lies in one.
std::optional<EnclosuresApart> enclosures_apart(const Field& field, int array);

// For polynomials: F, dF/dt and the gradient of dF/dt, with the inputs of `directional`. Expanded
// about a point of the box, dF/dt is bounded by this gradient closely, where its own terms cancel
// and would give a poor bound. None for other fields: there a second derivative may have no bound
// or, for chebyshev, only a poor one.
const std::optional<Program>& hessian_program(const Field& field);
const std::optional<Program>& hessian_program(const Field&&) = delete;

} // namespace isomotion::formula
