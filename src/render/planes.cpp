#include "render/planes.h"

#include <algorithm>

namespace isomotion::render {
namespace {

// Compilers vectorise this only if they know that no two of these overlap.
void split(const float* __restrict from, int pixels, float* __restrict r, float* __restrict g,
           float* __restrict b, float* __restrict a) {
    for (int x = 0; x < pixels; ++x) {
        r[x] = from[4 * x];
        g[x] = from[4 * x + 1];
        b[x] = from[4 * x + 2];
        a[x] = from[4 * x + 3];
    }
}

} // namespace

void Planes::copy(const float* texels, const gpu::Rectangle& tile, int y, int rows,
                  const std::vector<image::Channel*>& channels) const {
    const bool is_color =
        channels.size() == 4 && std::none_of(channels.begin(), channels.end(),
                                             [](const auto* channel) { return !channel; });
    for (int k = 0; k < rows; ++k) {
        const float* from = texels + std::size_t(k) * std::size_t(tile.width) * 4;
        if (is_color) { // one way through memory instead of four
            split(from, tile.width, row(*channels[0], tile, y + k), row(*channels[1], tile, y + k),
                  row(*channels[2], tile, y + k), row(*channels[3], tile, y + k));
            continue;
        }
        for (std::size_t c = 0; c < channels.size(); ++c) {
            if (!channels[c]) continue;
            float* to = row(*channels[c], tile, y + k);
            for (int x = 0; x < tile.width; ++x) to[x] = from[std::size_t(4 * x) + c];
        }
    }
}

} // namespace isomotion::render
