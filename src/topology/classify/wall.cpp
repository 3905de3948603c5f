#include "topology/classify/wall.h"

#include <algorithm>
#include <cmath>

namespace isomotion::topology {
namespace {

using formula::Interval;

Interval product(const SpaceBox& a, const SpaceBox& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

} // namespace

std::optional<Wall> Wall::at(const SublevelSet& region, const Event& event) {
    Wall wall;
    if (event.stratum == 3) return wall;
    const SpaceBox& where = event.where;
    if (region.bounds().shape == scene::Bounds::Shape::sphere) {
        wall.is_sphere_ = true;
        wall.outwards_ = wall.from_centre(region, where);
        for (Interval& part : wall.outwards_) part = part / region.bounds().radius;
        return wall;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        wall.free_[i] = !region.may_be_on_wall(i, where[i]);
        if (wall.free_[i]) continue;
        wall.inwards_[i] = mid(where[i]) < mid(region.box()[i]) ? 1 : -1;
        wall.outwards_[i] = -wall.inwards_[i];
    }
    if (std::ranges::count(wall.free_, true) != event.stratum) return std::nullopt;
    return wall;
}

SpaceBox Wall::from_centre(const SublevelSet& region, const SpaceBox& box) {
    SpaceBox off;
    for (std::size_t i = 0; i < 3; ++i) off[i] = box[i] - region.bounds().centre[i];
    return off;
}

SpaceHessian Wall::bend(const SublevelSet& region, const SpaceBox& box, double more) const {
    SpaceHessian bend = region.hessian(box);
    if (!is_sphere_) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (free_[i]) continue;
            for (std::size_t j = 0; j < 3; ++j) bend[i][j] = bend[j][i] = i == j ? more : 0;
        }
        return bend;
    }
    const Interval radius = region.bounds().radius;
    SpaceBox out = from_centre(region, box);
    for (Interval& part : out) part = part / radius;
    const SpaceBox slopes = region.over({&box, 1}).front().gradient;
    const Interval turned = product(slopes, out) / radius;
    for (std::size_t i = 0; i < 3; ++i) {
        bend[i][i] = bend[i][i] - turned + Interval(more) * square(out[i]);
        for (std::size_t j = i + 1; j < 3; ++j)
            bend[i][j] = bend[j][i] = bend[i][j] + Interval(more) * (out[i] * out[j]);
    }
    return bend;
}

bool Wall::rises_inwards(const SublevelSet& region, const SpaceBox& box) const {
    const SpaceBox slopes = region.over({&box, 1}).front().gradient;
    if (is_sphere_) return product(slopes, from_centre(region, box)).hi < 0;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!free_[i] && !((Interval(inwards_[i]) * slopes[i]).lo > 0)) return false;
    }
    return true;
}

SpacePoint Wall::down(const SublevelSet& region, const SpaceBox& where) const {
    SpaceMatrix numbers;
    double size = 0;
    const SpaceHessian bend = this->bend(region, where);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            numbers[i][j] = mid(bend[i][j]);
            size += std::abs(numbers[i][j]);
        }
    }
    if (!is_sphere_) return least_direction(numbers, free_);
    // Nothing of it is across, where the matrix is made to rise more than anywhere else.
    const SpacePoint out = middle(outwards_);
    SpacePoint across;
    for (std::size_t i = 0; i < 3; ++i) across[i] = dot(numbers[i], out);
    const double twice = dot(across, out);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            numbers[i][j] +=
                (twice + 2 * size) * out[i] * out[j] - across[i] * out[j] - out[i] * across[j];
        }
    }
    return least_direction(numbers);
}

SpaceBox Wall::along(const SpacePoint& direction) const {
    SpaceBox along = point_box(direction);
    if (!is_sphere_) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (!free_[i]) along[i] = 0;
        }
        return along;
    }
    const Interval across = product(along, outwards_);
    for (std::size_t i = 0; i < 3; ++i) along[i] = along[i] - across * outwards_[i];
    return along;
}

} // namespace isomotion::topology
