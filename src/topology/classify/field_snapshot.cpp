#include "topology/classify/field_snapshot.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace isomotion::topology {
namespace {

using formula::Interval;

// The bounds are halved in all directions, several times; each part has the elements near it,
// chosen from those near the part that it is of.
class Parts {
public:
    Parts(std::shared_ptr<FrameField> field, const SpaceBox& whole)
        : field_(std::move(field))
        , everything_(field_->everything())
        , whole_(whole) {}

    void over(std::span<const SpaceBox> boxes, std::span<ValueAndGradient> out) {
        by_part<ValueAndGradient>(boxes, out, [&](const auto& near, auto some, auto of_some) {
            field_->over(near, some, of_some);
        });
    }
    void tighten(std::span<const SpaceBox> boxes, std::span<ValueAndGradient> out) {
        by_part<ValueAndGradient>(boxes, out, [&](const auto& near, auto some, auto of_some) {
            field_->tighten(near, some, of_some);
        });
    }
    void values(std::span<const SpaceBox> boxes, std::span<Interval> out) {
        by_part<Interval>(boxes, out, [&](const auto& near, auto some, auto of_some) {
            field_->values(near, some, of_some);
        });
    }
    SpaceHessian hessian(const SpaceBox& box) { return field_->hessian(near(box), box); }

private:
    static constexpr int deepest = 4;
    using Place = std::array<int, 4>; // depth, and which part along each axis

    template<class T, class Evaluate>
    void by_part(std::span<const SpaceBox> boxes, std::span<T> out, Evaluate&& evaluate) {
        std::map<const Elements*, std::vector<std::size_t>> which_are_in;
        for (std::size_t k = 0; k < boxes.size(); ++k) which_are_in[&near(boxes[k])].push_back(k);
        std::vector<SpaceBox> some;
        std::vector<T> of_some;
        for (const auto& [elements, which] : which_are_in) {
            some.clear();
            of_some.clear();
            for (const std::size_t k : which) {
                some.push_back(boxes[k]);
                of_some.push_back(out[k]);
            }
            evaluate(*elements, std::span<const SpaceBox>(some), std::span<T>(of_some));
            for (std::size_t k = 0; k < which.size(); ++k) out[which[k]] = of_some[k];
        }
    }

    double wall(std::size_t axis, int index, int depth) const {
        const Interval side = whole_[axis];
        return side.lo + (side.hi - side.lo) * (double(index) / (1 << depth));
    }
    SpaceBox box_of(const Place& place) const {
        SpaceBox box;
        for (std::size_t i = 0; i < 3; ++i)
            box[i] = {wall(i, place[1 + i], place[0]), wall(i, place[1 + i] + 1, place[0])};
        return box;
    }

    // Elements of the smallest part that holds the box.
    const Elements& near(const SpaceBox& box) {
        if (everything_.rest.empty()) return everything_; // nothing to leave out
        for (int depth = deepest; depth > 0; --depth) {
            Place place{depth};
            double size = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                const double side = wall(i, 1, depth) - wall(i, 0, depth);
                size = std::max(size, side);
                place[1 + i] = int(std::floor((box[i].lo - whole_[i].lo) / side));
            }
            const SpaceBox part = box_of(place);
            bool holds = true, is_small = true;
            for (std::size_t i = 0; i < 3; ++i) {
                holds &= contains(part[i], box[i]);
                is_small &= width(box[i]) < 1e-3 * size;
            }
            // In very small boxes what is left out would blur a sign.
            if (holds) return is_small ? everything_ : near(place);
        }
        return everything_;
    }
    const Elements& near(const Place& place) {
        if (place[0] == 0) return everything_;
        if (const auto known = near_.find(place); known != near_.end()) return known->second;
        const auto half = [](int index) { return index >> 1; }; // also of -1
        const Elements& whole =
            near({place[0] - 1, half(place[1]), half(place[2]), half(place[3])});
        const SpaceBox part = box_of(place);
        return near_.emplace(place, field_->nearer(whole, part)).first->second;
    }

    std::shared_ptr<FrameField> field_;
    const Elements everything_;
    SpaceBox whole_;
    std::map<Place, Elements> near_;
};

} // namespace

FieldSnapshot field_snapshot(std::shared_ptr<FrameField> field, const EnclosedBounds& bounds) {
    FieldSnapshot snapshot;
    for (std::size_t i = 0; i < 3; ++i) snapshot.box[i] = hull(bounds.low[i], bounds.high[i]);
    snapshot.bounds = bounds;
    const auto parts = std::make_shared<Parts>(std::move(field), snapshot.box);
    snapshot.over = [parts](auto boxes, auto out) { parts->over(boxes, out); };
    snapshot.tighten = [parts](auto boxes, auto out) { parts->tighten(boxes, out); };
    snapshot.values = [parts](auto boxes, auto out) { parts->values(boxes, out); };
    snapshot.hessian = [parts](const SpaceBox& box) { return parts->hessian(box); };
    const auto squared_distance = [centre = bounds.centre](const SpaceBox& box) {
        Interval sum = 0;
        for (std::size_t i = 0; i < 3; ++i) sum = sum + square(box[i] - centre[i]);
        return sum;
    };
    const bool is_sphere = bounds.shape == scene::Bounds::Shape::sphere;
    snapshot.is_inside = [=](const SpacePoint& p) {
        bool inside = !is_sphere || squared_distance(point_box(p)).hi < square(bounds.radius).lo;
        for (std::size_t i = 0; i < 3; ++i)
            inside = inside && p[i] > bounds.low[i].hi && p[i] < bounds.high[i].lo;
        return inside;
    };
    snapshot.is_outside = [=](const SpaceBox& box) {
        bool outside = is_sphere && squared_distance(box).lo > square(bounds.radius).hi;
        for (std::size_t i = 0; i < 3; ++i)
            outside = outside || box[i].lo > bounds.high[i].hi || box[i].hi < bounds.low[i].lo;
        return outside;
    };
    return snapshot;
}

} // namespace isomotion::topology
