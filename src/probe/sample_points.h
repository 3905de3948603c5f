// Points at which probes look, the same on every machine.
#pragma once

#include <glm/glm.hpp>

#include "scene/scene_at.h"

namespace isomotion::probe {

// The index-th number, counted from 1, of Halton's sequence of a prime base; in [0, 1).
inline double halton(int index, int base) {
    double result = 0, weight = 1;
    for (; index > 0; index /= base) {
        weight /= base;
        result += weight * (index % base);
    }
    return result;
}

// The k-th point, counted from 1, of a sequence that fills the box about the bounds evenly.
inline glm::dvec3 sample_point(const scene::BoundsAt& bounds, int k) {
    const glm::dvec3 unit(halton(k, 2), halton(k, 3), halton(k, 5));
    return bounds.min + unit * (bounds.max - bounds.min);
}

inline bool is_in(const scene::BoundsAt& bounds, const glm::dvec3& p) {
    if (bounds.shape == scene::Bounds::Shape::sphere)
        return glm::distance(p, bounds.centre) <= bounds.radius;
    return glm::all(glm::lessThanEqual(bounds.min, p)) &&
           glm::all(glm::lessThanEqual(p, bounds.max));
}

} // namespace isomotion::probe
