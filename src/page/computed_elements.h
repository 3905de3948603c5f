// Elements of an array that a page works out by the scene's expressions, where that is shorter than
// their values of every frame.
//
// Browsers have functions of their own (sin, exp, ...), which differ from those of `render` in a
// double's last bits. So the expressions are evaluated in intervals, which hold the results of all
// of these (formula/interval/interval_operations.h: within 4 ulps). Where an interval rounds to one
// float, every browser has that; where it doesn't, the page keeps the float of `render`.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "page/value_table.h"
#include "page/web_scene.h"

namespace isomotion::page {

// More elements than these would take a page's script longer than its pictures.
inline constexpr int most_computed = 1000;

struct ComputedElements {
    // Numbers of fields, as rules.h counts them: those whose values change and are left out.
    std::vector<int> fields;
    // What the page keeps of them: row, column and word, in ascending order.
    struct Exception {
        std::uint32_t row, column, word;
        bool operator==(const Exception&) const = default;
    };
    std::vector<Exception> exceptions;
};

// `values` are the array's, row by row. Rows are at these times and have so many elements. None if
// no field can be worked out.
std::optional<ComputedElements> computed_elements(const scene::Surface& surface, std::size_t array,
                                                  const ValueTable& values,
                                                  std::span<const double> times,
                                                  std::span<const int> counts);

// The values without those that are left out.
ValueTable without(const ComputedElements& computed, const scene::Surface& surface,
                   std::size_t array, const ValueTable& values);
// The number of exceptions and their words, little-endian.
void pack(const ComputedElements& computed, std::vector<std::byte>& into);

// {"fields": their numbers, "tracks": [[place, number or program]], each after those it names}.
nlohmann::ordered_json json_of(const ComputedElements& computed, const scene::Surface& surface,
                               std::size_t array);

} // namespace isomotion::page
