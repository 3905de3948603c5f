#include "render/packed_rays.h"

#include "synthesis/proof_text.h"

namespace isomotion::render {
namespace {

constexpr int packed_side = 4; // of squares that software renderers go through in step
constexpr int in_square = packed_side * packed_side;
constexpr int packed_row = synthesis::packed_across;
static_assert(packed_row * packed_row == PackedRays::most);

constexpr int rounded_up(int count, int to) { return (count + to - 1) / to * to; }

} // namespace

PackedRays::PackedRays()
    : target_(packed_row, packed_row)
    , list_(gpu::Format::rgba32f, 2 * packed_row, packed_row) {}

void PackedRays::draw(PassTable& table, const gpu::Program& program, const gpu::Rectangle& tile,
                      std::span<const OpenRay> rays, std::span<float> texels) {
    const int squares = rounded_up(int(rays.size()), in_square) / in_square;
    const int squares_across = std::min(squares, packed_row / packed_side);
    const int squares_up = rounded_up(squares, squares_across) / squares_across;
    // The last ray stands in for those that squares and rows lack.
    sent_.clear();
    for (int k = 0; k < rounded_up(in_square * squares_across * squares_up, packed_row); ++k) {
        const OpenRay& ray = rays[std::min(std::size_t(k), rays.size() - 1)];
        const auto proof = texels.subspan(ray.proof, 4);
        sent_.insert(sent_.end(), {float(ray.x), float(ray.y), 0, 0});
        sent_.insert(sent_.end(), proof.begin(), proof.end());
    }
    list_.update_rows(0, sent_);
    table.bind("open_texture", list_);
    program.set("squares_across", squares_across);
    const int width = packed_side * squares_across, height = packed_side * squares_up;
    target_.bind();
    table.draw(program, {tile.x, tile.y, width, height});
    read_.resize(4 * std::size_t(width) * std::size_t(height));
    target_.read(0, 0, 0, width, height, read_);
    for (int k = 0; k < int(rays.size()); ++k) {
        const int of_square = k / in_square, within = k % in_square;
        const int x = packed_side * (of_square % squares_across) + within % packed_side;
        const int y = packed_side * (of_square / squares_across) + within / packed_side;
        const auto proof = std::span(read_).subspan(4 * std::size_t(y * width + x), 4);
        std::ranges::copy(proof, texels.subspan(rays[std::size_t(k)].proof).begin());
    }
}

} // namespace isomotion::render
