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
};

// The squares with a pixel for which `is_open` is true of the first of its four numbers. `record`
// has these for `width` x `height` pixels, row by row.
template<class IsOpen>
OpenSquares open_squares(std::span<const float> record, int width, int height,
                         const IsOpen& is_open) {
    constexpr int side = OpenSquares::side;
    OpenSquares found;
    std::vector<int> open(std::size_t((width + side - 1) / side)); // pixels of each square of a row
    for (int low = 0; low < height; low += side) {
        const int top = std::min(low + side, height);
        std::ranges::fill(open, 0);
        for (int y = low; y < top; ++y) {
            const float* row = record.data() + std::size_t(y) * std::size_t(width) * 4;
            for (int square = 0; square < int(open.size()); ++square) {
                const int left = square * side;
                int count = 0;
                if (left + side <= width) { // of a constant number, which compilers vectorise
                    for (int k = 0; k < side; ++k) count += is_open(row[4 * (left + k)]);
                } else {
                    for (int x = left; x < width; ++x) count += is_open(row[4 * x]);
                }
                open[std::size_t(square)] += count;
            }
        }
        for (int square = 0; square < int(open.size()); ++square) {
            if (open[std::size_t(square)] == 0) continue;
            found.pixels += open[std::size_t(square)];
            const int left = square * side, right = std::min(left + side, width);
            gpu::Rectangle* last = found.areas.empty() ? nullptr : &found.areas.back();
            if (last && last->y == low && last->x + last->width == left) {
                last->width = right - last->x;
            } else {
                found.areas.push_back({left, low, right - left, top - low});
            }
        }
    }
    return found;
}

} // namespace isomotion::render
