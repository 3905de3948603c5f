// Rays of a picture packed together into a square of pixels, for passes over few rays that lie
// apart: shaders/proof/packed.glsl.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "gpu/target.h"
#include "render/pass_table.h"

namespace isomotion::render {

// A ray whose proof goes on.
struct OpenRay {
    int x = 0, y = 0;      // its pixel in the tile
    std::size_t proof = 0; // where its four numbers are
};

// The open rays of areas whose records `texels` holds one after another, each row by row: those for
// which `is_open` is true of the first of their four numbers. They come square by square of 4 x 4
// pixels, so that neighbours stay together.
template<class IsOpen>
std::vector<OpenRay> open_rays(std::span<const gpu::Rectangle> areas, std::span<const float> texels,
                               const IsOpen& is_open) {
    constexpr int side = 4;
    std::vector<OpenRay> found;
    std::size_t before = 0;
    for (const gpu::Rectangle& area : areas) {
        const auto add = [&](int x, int y) {
            const std::size_t at =
                before + 4 * (std::size_t(y) * std::size_t(area.width) + std::size_t(x));
            if (is_open(texels[at])) found.push_back({area.x + x, area.y + y, at});
        };
        for (int low = 0; low < area.height; low += side) {
            for (int left = 0; left < area.width; left += side) {
                for (int y = low; y < std::min(low + side, area.height); ++y)
                    for (int x = left; x < std::min(left + side, area.width); ++x) add(x, y);
            }
        }
        before += 4 * std::size_t(area.width) * std::size_t(area.height);
    }
    return found;
}

class PackedRays {
public:
    // The most that one draw takes.
    static constexpr int most = 128 * 128;

    PackedRays();

    // Draws a pass over the proofs of some rays and replaces these in `texels`. There must be one
    // ray, and `most` at most.
    void draw(PassTable& table, const gpu::Program& program, const gpu::Rectangle& tile,
              std::span<const OpenRay> rays, std::span<float> texels);

    // Has the next draws of a program take each ray at its own pixel.
    static void unpack(const gpu::Program& program) { program.set("squares_across", 0); }

private:
    gpu::Target target_;
    gpu::Texture list_;
    std::vector<float> sent_, read_;
};

} // namespace isomotion::render
