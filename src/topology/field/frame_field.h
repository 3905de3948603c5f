// A frame's field over boxes of space, with its gradient. In sums it evaluates only the elements
// that matter.
//
// G is F if the solid is {F < 0}, otherwise -F. Slopes are generalized (formula/enclosure.h): a
// gradient encloses all difference quotients between points of the box, also across kinks. In a
// small box most elements of a sum are far away and hardly change; these are left out.
//
// Boxes are of space, or of the cube that a ball of bounds is the image of (ball_as_cube.h). Then
// all derivatives are by the cube's coordinates.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "topology/field/ball_as_cube.h"
#include "topology/field/box_field.h"
#include "topology/field/space_box.h"
#include "topology/field/space_formula.h"

namespace isomotion::topology {

// Use one per thread.
class FrameField {
public:
    explicit FrameField(const SpaceFormula& formula, std::optional<BallAsCube> ball = {});
    FrameField(const FrameField&) = delete; // since the evaluator refers to the programs
    FrameField& operator=(const FrameField&) = delete;

    // Binds other values to the same names.
    void bind(formula::Bindings<formula::Interval> bindings) {
        evaluator_.bind(std::move(bindings));
    }

    const Elements& everything() const { return evaluator_.all(); }

    // Evaluates over boxes inside the box of `near`. In a ball nothing is told of gradients where
    // G has one sign: these cost as much as all else.
    void over(const Elements& near, std::span<const SpaceBox> boxes,
              std::span<ValueAndGradient> out);
    // Narrows the results by Taylor's formula about the middle, to second order, which is tighter
    // in small boxes. Leaves `out` unchanged where second derivatives are unbounded: at kinks and
    // jumps.
    void tighten(const Elements& near, std::span<const SpaceBox> boxes,
                 std::span<ValueAndGradient> out);
    void values(const Elements& near, std::span<const SpaceBox> boxes,
                std::span<formula::Interval> out);

    // Second derivatives; unbounded where the box has a kink or a jump.
    SpaceHessian hessian(const Elements& near, const SpaceBox& box);

    // Drops the elements that hardly change in the box.
    Elements nearer(const Elements& near, const SpaceBox& box);
    // Encloses the elements that are far from the box by Taylor's formula (box_field.h). `near`
    // must not be expanded. Boxes much smaller than this one are enclosed better without.
    Elements expanded(const Elements& near, const SpaceBox& box);

private:
    using Jets = std::vector<Jet<formula::Interval>>;

    Box in_space(const SpaceBox& box) const;
    void load(std::span<const SpaceBox> boxes);
    // From derivatives by places in space to those by the box's coordinates.
    void turn(const SpaceBox& box, Jet<formula::Interval>& jet, bool has_second) const;
    formula::Interval of_solid(formula::Interval f) const {
        return solid_ == Side::negative ? f : -f;
    }

    Side solid_;
    std::optional<BallAsCube> ball_;
    BoxField field_;
    BoxEvaluator evaluator_;
    std::vector<Box> boxes_;
    std::vector<SpaceBox> middles_;
    Jets jets_, at_middles_;
    std::vector<formula::Interval> values_;
};

} // namespace isomotion::topology
