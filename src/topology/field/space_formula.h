// A surface at rest, as a formula of the place alone.
#pragma once

#include <utility>

#include "formula/field.h"
#include "formula/interval/interval.h"
#include "topology/field/solid.h"

namespace isomotion::topology {

// A formula of x, y, z alone, with the values of its other names: intervals that hold the exact
// values. A proof holds for each value in them, and so for all frames of a span of time.
struct SpaceFormula {
    formula::Graph graph;
    formula::NodeId root = 0; // F
    formula::Bindings<formula::Interval> bindings;
    Side solid = Side::negative;
};

inline SpaceFormula space_formula(const formula::Field& field,
                                  formula::Bindings<formula::Interval> bindings, Side solid) {
    return {field.graph, field.root, std::move(bindings), solid};
}

} // namespace isomotion::topology
