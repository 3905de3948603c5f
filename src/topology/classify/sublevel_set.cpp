#include "topology/classify/sublevel_set.h"

namespace isomotion::topology {

using formula::Interval;

std::vector<ValueAndGradient> SublevelSet::over(std::span<const SpaceBox> boxes) const {
    std::vector<ValueAndGradient> h(boxes.size());
    snapshot_.over(boxes, h);
    if (is_solid_) return h;
    for (ValueAndGradient& one : h) {
        one.value = -one.value;
        for (Interval& component : one.gradient) component = -component;
    }
    return h;
}

std::vector<Interval> SublevelSet::values(std::span<const SpaceBox> boxes) const {
    std::vector<Interval> h(boxes.size());
    snapshot_.values(boxes, h);
    if (is_solid_) return h;
    for (Interval& value : h) value = -value;
    return h;
}

SpaceHessian SublevelSet::hessian(const SpaceBox& box) const {
    SpaceHessian h = snapshot_.hessian(box);
    if (is_solid_) return h;
    for (auto& row : h) {
        for (Interval& entry : row) entry = -entry;
    }
    return h;
}

} // namespace isomotion::topology
