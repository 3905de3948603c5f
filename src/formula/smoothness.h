// What a formula is where it is looked at: a polynomial, smooth, with kinks, jumps or poles. By
// intervals of what its operations are given, not by their names: sqrt(x^2 + 1) is smooth.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "formula/field.h"

namespace isomotion::formula {

struct Smoothness {
    std::optional<int> degree; // of a polynomial in x, y and z
    // Whether there may be any, see graph/roughness.h.
    bool kinks = false, jumps = false, poles = false;

    bool is_smooth() const { return !kinks && !jumps && !poles; }
};

// Where a formula is looked at, and what its names stand for meanwhile.
struct Region {
    Bindings<Interval> bindings;
    std::array<Interval, 3> box;
};

// Of all regions together. Boxes that can't be told smooth are divided, for about as many
// operations as are allowed; what is not told then counts as rough.
Smoothness smoothness(const Field& field, std::span<const Region> regions, double operations = 2e7);

// "polynomial of degree 4", "smooth", "with kinks and poles"
std::string words(const Smoothness& smoothness);

} // namespace isomotion::formula
