#include "topology/classify/sublevel_set.h"

namespace isomotion::topology {

using formula::Interval;

std::vector<ValueAndGradient> SublevelSet::over(std::span<const SpaceBox> boxes) const {
    std::vector<ValueAndGradient> h(boxes.size());
    snapshot_.over(boxes, h);
    of_region(h);
    return h;
}

void SublevelSet::tighten(std::span<const SpaceBox> boxes, std::span<ValueAndGradient> h) const {
    of_region(h);
    snapshot_.tighten(boxes, h);
    of_region(h);
}

void SublevelSet::of_region(std::span<ValueAndGradient> enclosures) const {
    if (is_solid_) return;
    for (ValueAndGradient& one : enclosures) {
        one.value = -one.value;
        for (Interval& component : one.gradient) component = -component;
    }
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

namespace {

bool has_corner(const SpaceBox& box, auto&& is) {
    for (unsigned corner = 0; corner < 8; ++corner) {
        SpacePoint p;
        for (std::size_t k = 0; k < 3; ++k) p[k] = corner >> k & 1 ? box[k].hi : box[k].lo;
        if (is(p)) return true;
    }
    return false;
}

} // namespace

bool SublevelSet::is_all_inside(const SpaceBox& box) const {
    return !has_corner(box, [&](const SpacePoint& p) { return !snapshot_.is_inside(p); });
}

bool SublevelSet::has_corner_outside(const SpaceBox& box) const {
    return has_corner(box, [&](const SpacePoint& p) { return snapshot_.is_outside(point_box(p)); });
}

} // namespace isomotion::topology
