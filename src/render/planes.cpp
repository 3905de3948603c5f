#include "render/planes.h"

#include <algorithm>
#include <span>

namespace isomotion::render {
namespace {

// Some rows at a time, which stay in a processor's cache from the driver's copy to ours.
constexpr int floats_of_a_strip = 1 << 16;

} // namespace

void Planes::read(const gpu::Target& from, int attachment, const gpu::Rectangle& tile,
                  const std::vector<image::Channel*>& channels) {
    const int rows = std::clamp(floats_of_a_strip / (4 * tile.width), 1, tile.height);
    strip_.resize(std::size_t(4 * tile.width) * std::size_t(rows));
    for (int y = 0; y < tile.height; y += rows) {
        const int now = std::min(rows, tile.height - y);
        const auto floats = std::size_t(4 * tile.width) * std::size_t(now);
        from.read(attachment, 0, y, tile.width, now, std::span(strip_).first(floats));
        copy(strip_.data(), tile, y, now, channels);
    }
}

void Planes::copy(const float* texels, const gpu::Rectangle& tile, int y, int rows,
                  const std::vector<image::Channel*>& channels) const {
    const bool is_color =
        channels.size() == 4 && std::none_of(channels.begin(), channels.end(),
                                             [](const auto* channel) { return !channel; });
    for (int k = 0; k < rows; ++k) {
        const float* from = texels + std::size_t(k) * std::size_t(tile.width) * 4;
        if (is_color) { // one way through memory instead of four
            float *r = row(*channels[0], tile, y + k), *g = row(*channels[1], tile, y + k);
            float *b = row(*channels[2], tile, y + k), *a = row(*channels[3], tile, y + k);
            for (int x = 0; x < tile.width; ++x) {
                r[x] = from[4 * x];
                g[x] = from[4 * x + 1];
                b[x] = from[4 * x + 2];
                a[x] = from[4 * x + 3];
            }
            continue;
        }
        for (std::size_t c = 0; c < channels.size(); ++c) {
            if (!channels[c]) continue;
            float* to = row(*channels[c], tile, y + k);
            for (int x = 0; x < tile.width; ++x) to[x] = from[std::size_t(4 * x) + c];
        }
    }
}

void Planes::fill(const gpu::Rectangle& tile, image::Channel& channel,
                  const std::function<float(std::size_t pixel)>& number) const {
    for (int y = 0; y < tile.height; ++y) {
        float* to = row(channel, tile, y);
        for (int x = 0; x < tile.width; ++x) {
            to[x] = number(std::size_t(y) * std::size_t(tile.width) + std::size_t(x));
        }
    }
}

} // namespace isomotion::render
