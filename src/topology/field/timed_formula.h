// A motion's formula prepared once for all its times.
//
// Expressions of the clock alone become parameters; expressions of the clock and one element become
// fields of the element. Both are computed once per time instead of at each point. So all times
// share a graph and its derivatives, and differ in bindings.
#pragma once

#include "scene/scene_at.h"
#include "topology/field/enclosed_bounds.h"
#include "topology/field/motion.h"
#include "topology/field/space_formula.h"

namespace isomotion::topology {

class TimedFormula {
public:
    explicit TimedFormula(const Motion& motion);

    formula::Interval clock() const { return clock_; }
    // A formula of x, y, z for any time. Its bindings are those of the clock's middle.
    const SpaceFormula& formula() const { return formula_; }
    // Enclosures for all times of `time`.
    formula::Bindings<formula::Interval> bindings(formula::Interval time) const;
    // The same for the bounds.
    EnclosedBounds bounds(formula::Interval time) const;
    // Rounded.
    scene::BoundsAt bounds(double time) const;

private:
    // Inputs: the clock, then, for a column, its fields.
    struct Part {
        formula::Program program;
        int array = -1; // of a column; -1 for others
        std::vector<int> fields;
    };
    static Part part(const Motion& motion, formula::NodeId root);

    formula::Interval clock_;
    scene::Bounds::Shape shape_;
    formula::Bindings<formula::Interval> resting_; // values that don't depend on the clock
    std::vector<Part> parameters_, columns_;       // appended to these, in order
    std::vector<Part> bounds_; // low, high; for a sphere also the centre and the radius
    SpaceFormula formula_;
};

} // namespace isomotion::topology
