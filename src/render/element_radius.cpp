#include "render/element_radius.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "formula/evaluate/evaluate.h"

namespace isomotion::render {
namespace {

using formula::Bindings;
using formula::Interval;

constexpr int most_elements = 16;
constexpr int halvings = 8; // of the bounds, around the place where an element matters most
constexpr double narrowest = 0x1p-6; // of the bounds' radius: none is told to be smaller
constexpr double widest = 0x1p-2;

using Box = std::array<Interval, 3>;

// F with no element or with one.
template<class T> class Alone {
public:
    Alone(const formula::Program& program, const Bindings<float>& all)
        : all_(all)
        , evaluator_(program)
        , none_(room_for(0, all))
        , one_(room_for(1, all)) {}

    void choose(int element) {
        for (std::size_t f = 0; f < one_.arrays[0].fields.size(); ++f) {
            const std::vector<float>& column = all_.arrays[0].fields[f];
            if (!column.empty()) one_.arrays[0].fields[f] = {T(column[std::size_t(element)])};
        }
    }
    T without(const std::array<T, 3>& at) { return value(none_, at); }
    // What the chosen element changes.
    T change(const std::array<T, 3>& at) { return value(one_, at) - value(none_, at); }

private:
    static Bindings<T> room_for(int elements, const Bindings<float>& all) {
        Bindings<T> some;
        some.parameters.assign(all.parameters.begin(), all.parameters.end());
        some.seed = all.seed;
        some.arrays.resize(1);
        some.arrays[0].count = elements;
        some.arrays[0].fields.resize(all.arrays[0].fields.size());
        return some;
    }
    T value(const Bindings<T>& bindings, const std::array<T, 3>& at) {
        T result{};
        evaluator_.point(bindings, at, std::span(&result, 1));
        return result;
    }

    const Bindings<float>& all_;
    formula::Evaluator<T> evaluator_;
    Bindings<T> none_, one_;
};

std::pair<Interval, Interval> halves(const Interval& a) {
    const double middle = 0.5 * (a.lo + a.hi);
    return {{a.lo, middle}, {middle, a.hi}};
}

std::array<double, 3> middle(const Box& box) {
    return {0.5 * (box[0].lo + box[0].hi), 0.5 * (box[1].lo + box[1].hi),
            0.5 * (box[2].lo + box[2].hi)};
}

// Down to the part of the box with the largest bound of the element's change.
std::array<double, 3> place_of_most(Alone<Interval>& alone, Box box) {
    for (int k = 0; k < 3 * halvings; ++k) {
        Interval& side = box[std::size_t(k % 3)];
        const auto [low, high] = halves(side);
        side = low;
        const double at_low = magnitude(alone.change(box));
        side = high;
        if (at_low > magnitude(alone.change(box))) side = low;
    }
    return middle(box);
}

double radius_around(Alone<double>& alone, const std::array<double, 3>& place, double bounds) {
    const double most = std::abs(alone.change(place));
    const double enough = std::min(std::abs(alone.without(place)), 0.5 * most);
    // Nothing, or nothing that can be told.
    if (!(enough > 0)) return std::numeric_limits<double>::infinity();
    const auto reaches = [&](std::size_t axis, double distance) {
        std::array<double, 3> at = place;
        at[axis] += distance;
        return std::abs(alone.change(at)) >= enough;
    };
    double radius = narrowest * bounds;
    // The radius goes to the nearest side of all, in steps of an eighth.
    for (; radius < widest * bounds; radius *= 1.125) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (!reaches(axis, radius) || !reaches(axis, -radius)) return radius;
        }
    }
    return std::numeric_limits<double>::infinity();
}

} // namespace

double least_element_radius(const formula::Field& field, const scene::SurfaceAt& now) {
    double least = std::numeric_limits<double>::infinity();
    const Bindings<float>& all = now.bindings;
    if (all.arrays.size() != 1 || all.arrays[0].count == 0) return least;
    Alone<Interval> bounded(field.value, all);
    Alone<double> sampled(field.value, all);
    const glm::dvec3 &low = now.bounds.min, &high = now.bounds.max;
    const Box whole{Interval{low.x, high.x}, {low.y, high.y}, {low.z, high.z}};
    const int elements = std::min(all.arrays[0].count, most_elements);
    for (int k = 0; k < elements; ++k) {
        const int element = int(std::int64_t(k) * all.arrays[0].count / elements);
        bounded.choose(element);
        sampled.choose(element);
        const auto place = place_of_most(bounded, whole);
        least = std::min(least, radius_around(sampled, place, now.bounds.radius));
    }
    return least;
}

double ElementRadius::least(const formula::Field& field, const scene::SurfaceAt& now) {
    if (!known_ || known_->elements != now.bindings || known_->bounds != now.bounds) {
        known_ = Known{now.bindings, now.bounds, least_element_radius(field, now)};
    }
    return known_->least;
}

} // namespace isomotion::render
