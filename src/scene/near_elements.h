// Bindings of a field near a place. For an array with many elements they hold only those that
// matter there.
#pragma once

#include <optional>

#include "elements/grid_maker.h"
#include "scene/scene_at.h"

namespace isomotion::scene {

// The region that a grid of elements covers: the bounds with a margin for rounding. Truth's tubes
// extend beyond the bounds by less than this margin.
elements::Region region_of_elements(const BoundsAt& bounds);

// Finds the array whose elements are worth finding by place, once for all times.
class ElementFinder {
public:
    explicit ElementFinder(const OneSurface& one);

    std::optional<int> array() const;

private:
    friend class NearElements;
    std::optional<elements::GridMaker> maker_;
};

// Bindings at one time. Queries at neighbouring places are cheap.
class NearElements {
public:
    // Throws std::length_error where too many elements matter at one place.
    NearElements(const ElementFinder& finder, const SurfaceAt& now);

    // Valid until the next call. Returns all() if no array is found by place.
    const formula::Bindings<double>& at(const glm::dvec3& p);
    const formula::Bindings<double>& all() const { return all_; }
    bool is_by_place() const { return grid_.has_value(); }
    // For each array: how many elements a sum has at most places.
    std::vector<int> usual_counts() const;

private:
    formula::Bindings<double> all_, near_;
    std::optional<elements::ElementGrid> grid_;
    std::size_t array_ = 0;
    const elements::Cell* cell_ = nullptr;
};

} // namespace isomotion::scene
