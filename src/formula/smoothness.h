// Classifies a formula within its domain: polynomial, smooth, with kinks, jumps or poles. The
// classification uses intervals of the operations' arguments, not their names: sqrt(x^2 + 1) is
// smooth.
//
// It chooses the method of marching, and proves nothing.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "formula/field.h"

namespace isomotion::formula {

struct Smoothness {
    std::optional<int> degree{}; // of a polynomial in x, y and z
    // Whether there may be any that a method must know, see graph/roughness.h.
    bool kinks = false, jumps = false, poles = false;
    // Whether samples may look as if F touched 0 where it doesn't: squares of expressions, see
    // graph/squares.h, and logarithms of what may come to 0 in floats, see graph/log_sums.h.
    bool false_touches = false;

    bool is_smooth() const { return !kinks && !jumps && !poles; }
};

// A part of a formula's domain, with the values of its names.
struct Region {
    Bindings<Interval> bindings;
    std::array<Interval, 3> box;
};

// Smoothness over all regions, with an effort of a few times `operations`; what is not decided then
// counts as rough. Kinks and poles count if they are found on random lines, kinks only if slopes
// really change there. Kinks and poles that meet no such line count where F may be 0.
Smoothness smoothness(const Field& field, std::span<const Region> regions, double operations = 2e7);

// "polynomial of degree 4", "smooth", "with kinks, jumps"
std::string words(const Smoothness& smoothness);

} // namespace isomotion::formula
