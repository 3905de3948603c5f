// What a formula is where it is looked at: a polynomial, smooth, with kinks, jumps or poles. By
// intervals of what its operations are given, not by their names: sqrt(x^2 + 1) is smooth.
//
// This chooses how rays march, and proves nothing.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "formula/field.h"

namespace isomotion::formula {

struct Smoothness {
    std::optional<int> degree{}; // of a polynomial in x, y and z
    // Whether there may be any that a method has to know of, see graph/roughness.h.
    bool kinks = false, jumps = false, poles = false;
    bool squares = false; // of expressions, see graph/squares.h

    bool is_smooth() const { return !kinks && !jumps && !poles; }
};

// Where a formula is looked at, and what its names stand for meanwhile.
struct Region {
    Bindings<Interval> bindings;
    std::array<Interval, 3> box;
};

// Smoothness in all regions together, for a few times so many operations; what is not told then
// counts as rough. Kinks count where slopes really change, on random lines, as poles do on them;
// what no such line meets counts where F may be 0.
Smoothness smoothness(const Field& field, std::span<const Region> regions, double operations = 2e7);

// "polynomial of degree 4", "smooth", "with kinks, jumps"
std::string words(const Smoothness& smoothness);

} // namespace isomotion::formula
