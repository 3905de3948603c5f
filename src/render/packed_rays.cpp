#include "render/packed_rays.h"

#include <algorithm>

#include "shader/proof_text.h"

namespace isomotion::render {
namespace {

constexpr int square_side = 4; // software renderers go through the pixels of a square in step
constexpr int in_square = square_side * square_side;
static_assert(square_side == shader::proved_block);

constexpr int floats_of_ray = 8; // in the list
constexpr int floats_of_row = 4 * shader::open_list_across;

constexpr int quotient_up(int count, int by) { return (count + by - 1) / by; }

// The squares that one draw may have in a tile.
int most_squares(int width, int height) {
    return std::min(quotient_up(width, square_side) * quotient_up(height, square_side),
                    PackedRays::most / in_square);
}

// The side of the least square of squares that holds so many.
int least_side(int squares) {
    int least = 1;
    while (least * least < squares) ++least;
    return least;
}

// The most that packed_squares() may have in a row.
constexpr int most_across(int least) { return least + least / 2; }

} // namespace

glm::ivec2 packed_squares(int squares) {
    const int least = least_side(squares);
    glm::ivec2 best(least);
    for (int across = least; across <= most_across(least); ++across) {
        const glm::ivec2 drawn(across, quotient_up(squares, across));
        if (drawn.x * drawn.y < best.x * best.y) best = drawn;
    }
    return best;
}

PackedRays::PackedRays(int width, int height)
    : list_(gpu::Format::rgba32f, shader::open_list_across,
            quotient_up(floats_of_ray * in_square * most_squares(width, height), floats_of_row))
    , target_(square_side * most_across(least_side(most_squares(width, height))),
              square_side * least_side(most_squares(width, height))) {}

OpenRays PackedRays::begin(PassTable& table, const gpu::Program& program,
                           const gpu::Rectangle& tile, std::span<const glm::ivec2> blocks) {
    OpenRays rays;
    rays.pixels.reserve(in_square * blocks.size());
    rays.proofs.reserve(4 * in_square * blocks.size());
    while (!blocks.empty()) {
        const auto now = blocks.first(std::min(blocks.size(), std::size_t(most / in_square)));
        sent_.clear();
        for (const glm::ivec2& block : now)
            sent_.insert(sent_.end(), {float(block.x), float(block.y), 0, 0});
        const int squares = int(now.size());
        draw(table, program, tile, squares, squares);
        for (int square = 0; square < squares; ++square) {
            const glm::ivec2 corner = square_side * now[std::size_t(square)];
            for (int k = 0; k < in_square; ++k) {
                const glm::ivec2 pixel = corner + glm::ivec2(k % square_side, k / square_side);
                if (pixel.x >= tile.width || pixel.y >= tile.height) continue;
                const auto proof = read_of(in_square * square + k);
                rays.pixels.push_back(pixel);
                rays.proofs.insert(rays.proofs.end(), proof.begin(), proof.end());
            }
        }
        blocks = blocks.subspan(now.size());
    }
    return rays;
}

void PackedRays::go_on(PassTable& table, const gpu::Program& program, const gpu::Rectangle& tile,
                       std::span<const std::uint32_t> open, OpenRays& rays) {
    while (!open.empty()) {
        const auto now = open.first(std::min(open.size(), std::size_t(most)));
        sent_.clear();
        for (const std::uint32_t k : now) {
            const glm::ivec2 pixel = rays.pixels[k];
            const auto proof = std::span(rays.proofs).subspan(4 * std::size_t(k), 4);
            sent_.insert(sent_.end(), {float(pixel.x), float(pixel.y), 0, 0});
            sent_.insert(sent_.end(), proof.begin(), proof.end());
        }
        const int entries = int(now.size());
        draw(table, program, tile, entries, quotient_up(entries, in_square));
        for (int k = 0; k < entries; ++k) {
            const auto at = 4 * std::ptrdiff_t(now[std::size_t(k)]);
            std::ranges::copy(read_of(k), rays.proofs.begin() + at);
        }
        open = open.subspan(now.size());
    }
}

void PackedRays::draw(PassTable& table, const gpu::Program& program, const gpu::Rectangle& tile,
                      int entries, int squares) {
    sent_.resize(std::size_t(quotient_up(int(sent_.size()), floats_of_row) * floats_of_row));
    list_.update_rows(0, sent_);
    table.bind("open_texture", list_);
    const glm::ivec2 drawn = packed_squares(squares);
    program.set("squares_across", drawn.x);
    program.set("last_entry", entries - 1);
    const int width = square_side * drawn.x, height = square_side * drawn.y;
    target_.bind();
    table.draw(program, {tile.x, tile.y, width, height});
    across_ = drawn.x;
    read_.resize(4 * std::size_t(width) * std::size_t(height));
    target_.read(0, 0, 0, width, height, read_);
}

std::span<const float, 4> PackedRays::read_of(int ray) const {
    const int square = ray / in_square, within = ray % in_square;
    const int x = square_side * (square % across_) + within % square_side;
    const int y = square_side * (square / across_) + within / square_side;
    return std::span(read_).subspan(4 * std::size_t(y * square_side * across_ + x)).first<4>();
}

} // namespace isomotion::render
