#include "topology/field/frame_field.h"

#include <algorithm>

#include "topology/field/space_point.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

// Elements are left out of a sum where their terms' widths are this part of the terms' size, and
// their derivatives' likewise.
constexpr double negligible = 0x1p-20;
// How much terms that Taylor's formula encloses may blur a sum in a box, as a part of what
// intervals of all its terms blur it.
constexpr double blur = 0.03;
const SpaceBox unknown_gradient{Interval::entire(), Interval::entire(), Interval::entire()};
// With fewer elements there is nothing to gain.
constexpr int few_elements = 8;

BoxField over_space(const SpaceFormula& formula) {
    formula::Graph graph = formula.graph;
    constexpr std::array<std::size_t, 3> axes{0, 1, 2};
    const std::vector<formula::NodeId> jet = jet_over_boxes(graph, formula.root, axes, axes.size());
    std::vector<SumSlopes> slopes;
    const auto has_many = [](const auto& array) { return array.count > few_elements; };
    if (std::ranges::any_of(formula.bindings.arrays, has_many))
        slopes = slopes_of_sums(graph, std::span(jet).first(1 + axes.size()), axes.size());
    return {std::move(graph), jet, {.unknowns = axes.size()}, axes.size(), slopes};
}

} // namespace

FrameField::FrameField(const SpaceFormula& formula, std::optional<BallAsCube> ball)
    : solid_(formula.solid)
    , ball_(ball)
    , field_(over_space(formula))
    , evaluator_(field_, formula.bindings) {}

// A part's place is rounded outwards, and may stick out of that of the whole by some ulps. What a
// box's elements tell has to hold where the places of its points are, and these are inside both.
Box FrameField::in_space(const SpaceBox& box) const {
    const SpaceBox place = ball_ ? ball_->place(box) : box;
    return {place[0], place[1], place[2]};
}

void FrameField::load(std::span<const SpaceBox> boxes) {
    boxes_.clear();
    for (const SpaceBox& box : boxes) boxes_.push_back(in_space(box));
}

void FrameField::turn(const SpaceBox& box, Jet<Interval>& jet, bool has_second) const {
    if (!ball_) return;
    const BallAsCube::Slopes slopes = ball_->slopes(box);
    SpaceBox gradient;
    std::copy_n(jet.gradient.begin(), 3, gradient.begin());
    std::ranges::copy(slopes.gradient(gradient), jet.gradient.begin());
    if (!has_second) return;
    SpaceHessian hessian;
    for (std::size_t i = 0; i < 3; ++i) std::copy_n(jet.hessian[i].begin(), 3, hessian[i].begin());
    hessian = slopes.hessian(gradient, hessian);
    for (std::size_t i = 0; i < 3; ++i) std::ranges::copy(hessian[i], jet.hessian[i].begin());
}

void FrameField::over(const Elements& near, std::span<const SpaceBox> boxes,
                      std::span<ValueAndGradient> out) {
    load(boxes);
    evaluator_.gradients(near, boxes_, jets_);
    for (std::size_t b = 0; b < boxes.size(); ++b) {
        if (ball_ && !contains(jets_[b].value, 0.0)) {
            out[b] = {of_solid(jets_[b].value), unknown_gradient};
            continue;
        }
        turn(boxes[b], jets_[b], false);
        out[b].value = of_solid(jets_[b].value);
        for (std::size_t i = 0; i < 3; ++i) out[b].gradient[i] = of_solid(jets_[b].gradient[i]);
    }
}

void FrameField::values(const Elements& near, std::span<const SpaceBox> boxes,
                        std::span<Interval> out) {
    load(boxes);
    evaluator_.values(near, boxes_, values_);
    for (std::size_t b = 0; b < boxes.size(); ++b) out[b] = of_solid(values_[b]);
}

void FrameField::tighten(const Elements& near, std::span<const SpaceBox> boxes,
                         std::span<ValueAndGradient> out) {
    load(boxes);
    evaluator_.jets(near, boxes_, jets_);
    middles_.clear();
    for (const SpaceBox& box : boxes) middles_.push_back(point_box(middle(box)));
    load(middles_);
    evaluator_.gradients(near, boxes_, at_middles_);
    for (std::size_t b = 0; b < boxes.size(); ++b) {
        auto &at_middle = at_middles_[b], &over = jets_[b];
        turn(boxes[b], over, true);
        turn(middles_[b], at_middle, false);
        std::array<Interval, 3> step;
        for (std::size_t i = 0; i < 3; ++i) step[i] = boxes[b][i] - middles_[b][i];
        Interval value = at_middle.value;
        for (std::size_t i = 0; i < 3; ++i) value = value + at_middle.gradient[i] * step[i];
        for (std::size_t i = 0; i < 3; ++i) {
            Interval gradient = at_middle.gradient[i];
            for (std::size_t j = 0; j < 3; ++j) {
                const Interval second = over.hessian[i][j];
                gradient = gradient + second * step[j];
                if (j == i) value = value + second * square(step[i]) * Interval(0.5);
                if (j > i) value = value + second * (step[i] * step[j]);
            }
            out[b].gradient[i] = intersect(out[b].gradient[i], of_solid(gradient));
        }
        out[b].value = intersect(out[b].value, of_solid(value));
    }
}

SpaceHessian FrameField::hessian(const Elements& near, const SpaceBox& box) {
    load({&box, 1});
    evaluator_.jets(near, boxes_, jets_);
    turn(box, jets_[0], true);
    SpaceHessian hessian;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) hessian[i][j] = of_solid(jets_[0].hessian[i][j]);
    }
    return hessian;
}

Elements FrameField::nearer(const Elements& near, const SpaceBox& box) {
    return evaluator_.changing(in_space(box), near, negligible);
}

Elements FrameField::expanded(const Elements& near, const SpaceBox& box) {
    return evaluator_.expanded(in_space(box), near, blur);
}

} // namespace isomotion::topology
