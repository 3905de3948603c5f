// Where proofs of rays go on, as squares of pixels: late passes of proofs have few rays left, and
// what they are drawn over costs more than these.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "gpu/draw.h"

namespace isomotion::render {

struct OpenSquares {
    std::vector<gpu::Rectangle> areas; // neighbours in a row joined
    int pixels = 0;                    // open ones

    static constexpr int side = 16;

    // Adds a part of a row of squares, from left to right.
    void add(const gpu::Rectangle& part) {
        gpu::Rectangle* last = areas.empty() ? nullptr : &areas.back();
        if (last && last->y == part.y && last->x + last->width == part.x) {
            last->width += part.width;
        } else {
            areas.push_back(part);
        }
    }
};

// Finds the squares that have a pixel for which `is_open` is true of the first of its four numbers.
// The areas are rows of whole squares, except at the picture's edges. `texels` has the numbers area
// by area, each row by row.
template<class IsOpen>
OpenSquares open_squares(std::span<const gpu::Rectangle> areas, std::span<const float> texels,
                         const IsOpen& is_open) {
    constexpr int side = OpenSquares::side;
    OpenSquares found;
    std::vector<int> open; // pixels of each square of an area
    for (const gpu::Rectangle& area : areas) {
        open.assign(std::size_t((area.width + side - 1) / side), 0);
        for (int y = 0; y < area.height; ++y) {
            const float* row = texels.data();
            texels = texels.subspan(4 * std::size_t(area.width));
            for (int square = 0; square < int(open.size()); ++square) {
                const int left = square * side;
                int count = 0;
                if (left + side <= area.width) { // of a constant number, which compilers vectorise
                    for (int k = 0; k < side; ++k) count += is_open(row[4 * (left + k)]);
                } else {
                    for (int x = left; x < area.width; ++x) count += is_open(row[4 * x]);
                }
                open[std::size_t(square)] += count;
            }
        }
        for (int square = 0; square < int(open.size()); ++square) {
            if (open[std::size_t(square)] == 0) continue;
            found.pixels += open[std::size_t(square)];
            const int left = square * side;
            found.add({area.x + left, area.y, std::min(side, area.width - left), area.height});
        }
    }
    return found;
}

} // namespace isomotion::render
