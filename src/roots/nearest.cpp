#include "roots/nearest.h"

#include <algorithm>
#include <limits>

#include "roots/outward.h"

namespace isomotion::roots {
namespace {

constexpr float nowhere = std::numeric_limits<float>::infinity();

bool has_certain_root(const FirstRoot& root) {
    return root.answer == Answer::hit || (root.answer == Answer::touching && root.after_is_hit);
}

// Before it there is certainly nothing.
float earliest(const FirstRoot& root) {
    switch (root.answer) {
    case Answer::miss:
        return nowhere;
    case Answer::touching:
        return root.touch_low;
    case Answer::hit:
    case Answer::undecided:
        return root.low;
    }
    return -nowhere;
}

} // namespace

FirstRoot nearest(std::span<const FirstRoot> roots, double apart) {
    // By then the ray has certainly ended.
    float end = nowhere;
    const FirstRoot* ending = nullptr;
    for (const FirstRoot& root : roots) {
        if (!has_certain_root(root) || root.high >= end) continue;
        end = root.high;
        ending = &root;
    }
    FirstRoot first;
    float low = nowhere, touch_low = nowhere, touch_high = -nowhere;
    bool is_open = false;
    for (const FirstRoot& root : roots) {
        if (earliest(root) > end || root.answer == Answer::miss) continue;
        is_open |= root.answer == Answer::undecided;
        if (root.answer == Answer::touching) {
            touch_low = std::min(touch_low, root.touch_low);
            touch_high = std::max(touch_high, std::min(root.touch_high, end));
        }
        if (has_certain_root(root)) low = std::min(low, root.low);
    }
    // Between touches that are apart there is nothing, and one interval cannot say so.
    const auto is_touch = [&](const FirstRoot& root) {
        return root.answer == Answer::touching && earliest(root) <= end;
    };
    float first_touch_high = nowhere;
    for (const FirstRoot& root : roots) {
        if (is_touch(root) && root.touch_low == touch_low)
            first_touch_high = std::min(first_touch_high, root.touch_high);
    }
    is_open |= std::ranges::any_of(roots, [&](const FirstRoot& root) {
        return is_touch(root) && double(root.touch_low) > double(first_touch_high) + apart;
    });
    first.surface = -1;
    if (is_open) {
        first.answer = Answer::undecided;
        for (const FirstRoot& root : roots) low = std::min(low, earliest(root));
        first.low = low;
        return first;
    }
    if (ending) {
        first.low = low;
        first.high = end;
    }
    if (touch_low <= touch_high) {
        first.answer = Answer::touching;
        first.touch_low = touch_low;
        first.touch_high = touch_high;
        first.after_is_hit = ending != nullptr;
        return first;
    }
    if (!ending) return first;
    first.answer = Answer::hit;
    const bool is_alone = std::ranges::all_of(roots, [&](const FirstRoot& root) {
        return &root == ending || double(earliest(root)) > double(end) + apart;
    });
    if (!is_alone) return first;
    first.surface = ending->surface;
    first.gradient = ending->gradient;
    first.cap = ending->cap;
    return first;
}

RaysOfSurfaces::RaysOfSurfaces(const scene::SceneAt& now, int width, int height,
                               const scene::Aim& aim) {
    for (std::size_t k = 0; k < now.surfaces.size(); ++k) {
        places_.push_back(now.surfaces[k].placement);
        tubes_.emplace_back(scene::OneSurfaceAt(now, k), width, height, aim);
    }
}

FirstRoot RaysOfSurfaces::nearest(int column, int row,
                                  std::span<const FirstRoot> of_surfaces) const {
    if (of_surfaces.size() == 1) return of_surfaces[0];
    const Tube first = tubes_[0].at(column, row);
    std::vector<FirstRoot> roots(of_surfaces.begin(), of_surfaces.end());
    for (std::size_t k = 0; k < roots.size(); ++k) {
        FirstRoot& root = roots[k];
        root.surface = std::int32_t(k);
        if (k == 0) continue;
        const Tube own = tubes_[k].at(column, row);
        const double unit = places_[k].scale / places_[0].scale;
        const glm::dvec3 anchor = places_[0].to_local(places_[k].to_world(own.anchor));
        const double begin = glm::dot(anchor - first.anchor, first.direction);
        root.low = below(begin + unit * double(root.low));
        root.high = above(begin + unit * double(root.high));
        root.touch_low = below(begin + unit * double(root.touch_low));
        root.touch_high = above(begin + unit * double(root.touch_high));
        const glm::dvec3 gradient(root.gradient[0], root.gradient[1], root.gradient[2]);
        const glm::dvec3 there = glm::transpose(places_[0].rotate) * (places_[k].rotate * gradient);
        root.gradient = {float(there.x), float(there.y), float(there.z)};
    }
    return roots::nearest(roots, 0.5 * first.footprint);
}

} // namespace isomotion::roots
