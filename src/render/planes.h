// Converts an attachment of four floats per pixel to a frame's channels, which are planes with rows
// from the top.
#pragma once

#include <functional>
#include <vector>

#include "gpu/target.h"
#include "image/frame.h"

namespace isomotion::render {

class Planes {
public:
    // For frames of this size that are drawn in tiles.
    Planes(int frame_width, int frame_height)
        : width_(frame_width)
        , height_(frame_height) {}

    // Reads the lower left tile.width x tile.height of an attachment. Channel k receives component
    // k, unless it is null.
    void read(const gpu::Target& from, int attachment, const gpu::Rectangle& tile,
              const std::vector<image::Channel*>& channels);
    // The same for rows from the bottom that are in memory; `y` is the first row's place in the
    // tile.
    void copy(const float* texels, const gpu::Rectangle& tile, int y, int rows,
              const std::vector<image::Channel*>& channels) const;
    // Fills a channel pixel by pixel, rows from the bottom.
    void fill(const gpu::Rectangle& tile, image::Channel& channel,
              const std::function<float(std::size_t pixel)>& number) const;

private:
    float* row(image::Channel& channel, const gpu::Rectangle& tile, int y) const {
        const int from_top = height_ - 1 - (tile.y + y);
        return channel.samples.data() + std::size_t(from_top) * std::size_t(width_) +
               std::size_t(tile.x);
    }

    int width_, height_;
    std::vector<float> strip_;
};

} // namespace isomotion::render
