// Draws with one pixel per block, squares of which are placed apart: shaders/march/beam_place.glsl.
#pragma once

#include <algorithm>

#include "gpu/draw.h"
#include "synthesis/beam_text.h"

namespace isomotion::render {

inline int blocks_in(int length, int block) { return (length + block - 1) / block; }

// Texels for squares of that many pixels.
inline int texels_apart(int length, int square) {
    return blocks_in(length, square) * synthesis::beam_square;
}

// Draws these blocks, from the corner of a square on, whose squares are `side` blocks across; none
// beyond them.
inline void draw_apart(const gpu::Fullscreen& triangle, const gpu::Rectangle& blocks, int side) {
    const int right = blocks.x + blocks.width, top = blocks.y + blocks.height;
    for (int y = blocks.y; y < top; y += side) {
        for (int x = blocks.x; x < right; x += side) {
            gpu::set_viewport({x / side * synthesis::beam_square, y / side * synthesis::beam_square,
                               std::min(side, right - x), std::min(side, top - y)});
            triangle.draw();
        }
    }
}

} // namespace isomotion::render
