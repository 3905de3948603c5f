// Parameters and fields of elements that are far from 0, as the bounds of their surface are, and
// fields that hold the same numbers counted from nearby.
#pragma once

#include <utility>
#include <vector>

#include "scene/reading/surface.h"
#include "scene/scene_at.h"

namespace isomotion::scene {

struct FarNumbers {
    std::vector<formula::FarNumber> numbers;
    // The surface's own arrays and its vocabulary with these fields, which no formula can name:
    // parameters in an array of one element.
    std::vector<animation::Array> arrays;
    formula::Vocabulary vocabulary;
    // The fields' values at first, each with its array.
    std::vector<std::pair<std::size_t, std::vector<float>>> columns;
};

// What the formula reads of them. They are counted from multiples of `unit`.
FarNumbers far_numbers(const SurfaceParts& parts, const SurfaceAt& first, double unit);

} // namespace isomotion::scene
