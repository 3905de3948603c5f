#include "topology/field_moment.h"

#include <cmath>
#include <map>
#include <memory>

namespace isomotion::topology {
namespace {

using formula::Interval;

constexpr double uncertainty = 1e-9; // of the bounds, as a part of their size

// The bounds are divided into blocks, each with the elements near it.
class Blocks {
public:
    Blocks(const SpaceFormula& formula, const scene::BoundsAt& bounds)
        : field_(formula)
        , everything_(field_.everything())
        , bounds_(bounds) {}

    void over(std::span<const SpaceBox> boxes, std::span<ValueAndGradient> out) {
        std::map<const FrameField::Near*, std::vector<std::size_t>> by_elements;
        for (std::size_t k = 0; k < boxes.size(); ++k) by_elements[&near(boxes[k])].push_back(k);
        std::vector<SpaceBox> some;
        std::vector<ValueAndGradient> of_some;
        for (const auto& [elements, which] : by_elements) {
            some.clear();
            for (std::size_t k : which) some.push_back(boxes[k]);
            of_some.resize(some.size());
            field_.over(*elements, some, of_some);
            for (std::size_t k = 0; k < which.size(); ++k) out[which[k]] = of_some[k];
        }
    }
    SpaceHessian hessian(const SpaceBox& box) { return field_.hessian(near(box), box); }

private:
    static constexpr int blocks = 16;

    double wall(std::size_t axis, int index) const {
        const int k = int(axis);
        return bounds_.min[k] + (bounds_.max[k] - bounds_.min[k]) * (double(index) / blocks);
    }

    // Small boxes are where what is left out would blur a sign.
    const FrameField::Near& near(const SpaceBox& box) {
        if (everything_.empty()) return everything_;
        std::array<int, 3> at;
        SpaceBox block;
        for (std::size_t i = 0; i < 3; ++i) {
            const double size = wall(i, 1) - wall(i, 0);
            at[i] = int(std::floor((box[i].lo - bounds_.min[int(i)]) / size));
            block[i] = {wall(i, at[i]), wall(i, at[i] + 1)};
            if (!contains(block[i], box[i]) || width(box[i]) < 1e-3 * size) return everything_;
        }
        const auto [it, is_new] = near_.try_emplace(at);
        if (is_new) {
            ValueAndGradient g;
            field_.over(everything_, {&block, 1}, {&g, 1});
            field_.tighten(everything_, {&block, 1}, {&g, 1});
            it->second = field_.nearer(everything_, 0);
        }
        return it->second;
    }

    FrameField field_;
    const FrameField::Near everything_;
    scene::BoundsAt bounds_;
    std::map<std::array<int, 3>, FrameField::Near> near_;
};

} // namespace

Moment field_moment(const SpaceFormula& formula, const scene::BoundsAt& bounds) {
    const auto blocks = std::make_shared<Blocks>(formula, bounds);
    const double slack = uncertainty * bounds.radius;
    const bool is_sphere = bounds.shape == scene::Bounds::Shape::sphere;
    Moment moment;
    moment.over = [blocks](auto boxes, auto out) { blocks->over(boxes, out); };
    moment.hessian = [blocks](const SpaceBox& box) { return blocks->hessian(box); };
    for (std::size_t i = 0; i < 3; ++i)
        moment.box[i] = {bounds.min[int(i)] - slack, bounds.max[int(i)] + slack};
    moment.is_inside = [=](const SpacePoint& p) {
        const glm::dvec3 at(p[0], p[1], p[2]);
        if (is_sphere) return glm::distance(at, bounds.centre) < bounds.radius - slack;
        return glm::all(glm::greaterThan(at, bounds.min + slack)) &&
               glm::all(glm::lessThan(at, bounds.max - slack));
    };
    moment.is_outside = [=](const SpaceBox& box) {
        Interval squared = 0;
        bool beyond_a_wall = false;
        for (std::size_t i = 0; i < 3; ++i) {
            const int k = int(i);
            squared = squared + square(box[i] - Interval(bounds.centre[k]));
            beyond_a_wall |= box[i].lo > bounds.max[k] + slack || box[i].hi < bounds.min[k] - slack;
        }
        return beyond_a_wall ||
               (is_sphere && squared.lo > (bounds.radius + slack) * (bounds.radius + slack));
    };
    return moment;
}

} // namespace isomotion::topology
