// The sums of a field over its array: what single elements add to them.
#pragma once

#include <optional>

#include "formula/field.h"

namespace isomotion::formula {

struct Sums {
    static constexpr int array = 0;

    Program with_field; // F, then the sums
    Program terms;      // one element's part of each of them
    int count = 0;
};

// Of fields with one array, summed over at most four times, no sum within another; these are the
// ones of which elements can be left out. For intervals, as in enclosure.h.
std::optional<Sums> sums_of(const Field& field);

// void field_and_sums_interval(vec2 x, vec2 y, vec2 z, out vec2 f, out vec2 s0, ...)
std::string glsl_field_and_sums_interval(const Sums& sums, const ArrayPacking& packing);
// void terms_interval(int e0, vec2 x, vec2 y, vec2 z, out vec2 s0, ...)
std::string glsl_terms_interval(const Sums& sums, const ArrayPacking& packing);

} // namespace isomotion::formula
