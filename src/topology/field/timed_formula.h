// A motion's formula made ready once for all its times.
//
// What the clock alone decides becomes a parameter, and what the clock and one element decide
// becomes a field of the element: both are computed once a time, not at each point. So all times
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
    // For all times of the enclosure.
    formula::Bindings<formula::Interval> bindings(formula::Interval time) const;
    // The same of the bounds.
    EnclosedBounds bounds(formula::Interval time) const;
    // Rounded.
    scene::BoundsAt bounds(double time) const;

private:
    // Inputs: the clock, then of a column its fields.
    struct Part {
        formula::Program program;
        int array = -1; // of a column
        std::vector<int> fields;
    };
    static Part part(const Motion& motion, formula::NodeId root);

    formula::Interval clock_;
    scene::Bounds::Shape shape_;
    formula::Bindings<formula::Interval> resting_; // what doesn't depend on the clock
    std::vector<Part> parameters_, columns_;       // appended to these, in order
    std::vector<Part> bounds_; // low, high; of a sphere the centre and the radius besides
    SpaceFormula formula_;
};

} // namespace isomotion::topology
