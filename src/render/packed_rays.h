// Rays of a picture packed together into squares of pixels, for passes over rays that are few and
// apart: shaders/proof/packed.glsl.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "gpu/target.h"
#include "render/pass_table.h"

namespace isomotion::render {

// Single rays of a tile.
struct OpenRays {
    std::vector<glm::ivec2> pixels;
    std::vector<float> proofs; // four numbers each: shaders/proof/ray.glsl
};

// How many squares are drawn a row and a column, so that few of the last row are in vain.
glm::ivec2 packed_squares(int squares);

class PackedRays {
public:
    // The most that one draw takes.
    static constexpr int most = 512 * 512;

    // For tiles of so many pixels.
    PackedRays(int width, int height);

    // Draws a pass over these blocks of rays, and returns the rays that lie in the tile with what
    // the pass made of them.
    OpenRays begin(PassTable& table, const gpu::Program& program, const gpu::Rectangle& tile,
                   std::span<const glm::ivec2> blocks);

    // Draws a pass over the proofs of those rays that `open` numbers, and replaces these.
    void go_on(PassTable& table, const gpu::Program& program, const gpu::Rectangle& tile,
               std::span<const std::uint32_t> open, OpenRays& rays);

private:
    // Draws squares of the entries that `sent_` lists, and reads what becomes of their rays.
    void draw(PassTable& table, const gpu::Program& program, const gpu::Rectangle& tile,
              int entries, int squares);
    // The four numbers read of a ray.
    std::span<const float, 4> read_of(int ray) const;

    gpu::Texture list_;
    gpu::Target target_;
    int across_ = 0;                 // squares of a row, as drawn last
    std::vector<float> sent_, read_; // last
};

} // namespace isomotion::render
