// Converts a tile's attachments of four floats per pixel to a frame's channels, which are planes
// with rows from the top.
#pragma once

#include <cstddef>
#include <vector>

#include "gpu/draw.h"
#include "image/frame.h"

namespace isomotion::render {

class Planes {
public:
    // For frames of this size that are drawn in tiles.
    Planes(int frame_width, int frame_height)
        : width_(frame_width)
        , height_(frame_height) {}

    // Copies rows of an attachment, which are in memory from the bottom up. `y` is the first row's
    // place in the tile. Channel k receives component k, unless it is null.
    void copy(const float* texels, const gpu::Rectangle& tile, int y, int rows,
              const std::vector<image::Channel*>& channels) const;

    // Fills a channel pixel by pixel, rows from the bottom: number(pixel of the tile).
    template<class Number>
    void fill(const gpu::Rectangle& tile, image::Channel& channel, const Number& number) const {
        for (int y = 0; y < tile.height; ++y) {
            float* to = row(channel, tile, y);
            const std::size_t first = std::size_t(y) * std::size_t(tile.width);
            for (std::size_t x = 0; x < std::size_t(tile.width); ++x)
                to[x] = float(number(first + x));
        }
    }

private:
    float* row(image::Channel& channel, const gpu::Rectangle& tile, int y) const {
        const int from_top = height_ - 1 - (tile.y + y);
        return channel.samples.data() + std::size_t(from_top) * std::size_t(width_) +
               std::size_t(tile.x);
    }

    int width_, height_;
};

} // namespace isomotion::render
