// Branch and prune (Kearfott 1996): goes through a box by parts, each halved until it is judged.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "formula/interval/interval.h"

namespace isomotion::formula {

// What a judge says of a part.
enum class Judged {
    settled, // nothing more to learn there
    open,    // to be halved
    refused, // the search ends in vain
};

// Sides of a box, from `first` to before `last`.
struct Sides {
    std::size_t first = 0, last = 0;
};

// Whether a double lies between the ends.
constexpr bool is_divisible(Interval side) {
    const double middle = mid(side);
    return side.lo < middle && middle < side.hi;
}

struct LongestSide {
    std::size_t side = 0;
    double part = 0; // its length as a part of the domain's
};

// The longest of the sides as a part of the domain's, the first of equals. Sides that can't be
// halved count as 0.
template<std::size_t n>
LongestSide longest_side(const std::array<Interval, n>& box, const std::array<Interval, n>& domain,
                         Sides sides = {0, n}) {
    LongestSide longest{sides.first, 0};
    for (std::size_t k = sides.first; k < sides.last; ++k) {
        const double whole = domain[k].hi - domain[k].lo;
        const double part = is_divisible(box[k]) ? (box[k].hi - box[k].lo) / whole : 0;
        if (part > longest.part) longest = {k, part};
    }
    return longest;
}

// Whether the judge settles parts that make up the box. Open parts are halved along the side that
// is longest as a part of the domain's, and the lower half is judged first. False where a part is
// refused, or is open and can't be halved: parts that were to be judged later have not been, then.
template<std::size_t n, class Judge>
[[nodiscard]] bool prune(const std::array<Interval, n>& box, const std::array<Interval, n>& domain,
                         Sides sides, Judge&& judge) {
    std::vector<std::array<Interval, n>> open{box};
    while (!open.empty()) {
        std::array<Interval, n> low = open.back();
        open.pop_back();
        const Judged judged = judge(std::as_const(low));
        if (judged == Judged::settled) continue;
        const auto [side, part] = longest_side(low, domain, sides);
        if (judged == Judged::refused || part == 0) return false;
        open.push_back(low);
        open.back()[side].lo = low[side].hi = mid(low[side]);
        open.push_back(low);
    }
    return true;
}

// The same for the whole domain.
template<std::size_t n, class Judge>
[[nodiscard]] bool prune(const std::array<Interval, n>& domain, Judge&& judge) {
    return prune(domain, domain, {0, n}, judge);
}

} // namespace isomotion::formula
