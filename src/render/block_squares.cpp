#include "render/block_squares.h"

#include <algorithm>
#include <cmath>

namespace isomotion::render {
namespace {

bool are_alike(const Blocks& blocks, int x, int y, int side) {
    if (x + side > blocks.across || y + side > blocks.up) return false;
    const BlockKind kind = blocks.at(x, y);
    for (int row = y; row < y + side; ++row) {
        const auto begin = blocks.kinds.begin() + row * blocks.across + x;
        if (std::any_of(begin, begin + side, [kind](BlockKind k) { return k != kind; }))
            return false;
    }
    return true;
}

// Adds those of a square of blocks, of which the side is a power of two.
void add_squares(const Blocks& blocks, BlockKind kind, int x, int y, int side,
                 std::vector<gpu::Square>& found) {
    if (x >= blocks.across || y >= blocks.up) return;
    if (side == 1 || are_alike(blocks, x, y, side)) {
        if (blocks.at(x, y) == kind)
            found.push_back({Blocks::side * x, Blocks::side * y, Blocks::side * side});
        return;
    }
    const int half = side / 2;
    for (const int up : {y, y + half})
        for (const int right : {x, x + half}) add_squares(blocks, kind, right, up, half, found);
}

// The rays of a block: origin + tau axis + (1 + w tau) across, |across - middle| <= spread.
struct BlockRays {
    glm::dvec3 origin, axis, middle;
    double w = 0, spread = 0;
};

// The tau of the planes that touch the sphere around the bounds, and are parallel to the picture.
struct Depths {
    double low = 0, high = 0;
};

// More than float32 moves a ray or the bounds by, also where these are far from the origin.
double rounding(const glm::dvec3& centre, double size) {
    return 1e-5 * (glm::length(centre) + size);
}

bool meet_sphere(const BlockRays& rays, const Depths& depths, const glm::dvec3& centre,
                 double radius) {
    const glm::dvec3 direction = rays.axis + rays.w * rays.middle;
    const glm::dvec3 from = rays.origin + rays.middle - centre;
    const double tau = std::clamp(-glm::dot(from, direction) / glm::dot(direction, direction),
                                  depths.low, depths.high);
    const double spread = std::max(1 + rays.w * depths.high, 0.0) * rays.spread;
    return glm::length(from + tau * direction) <= radius + spread + rounding(centre, radius);
}

bool meet_box(const BlockRays& rays, Depths depths, const glm::dvec3& least,
              const glm::dvec3& most) {
    const glm::dvec3 direction = rays.axis + rays.w * rays.middle;
    const glm::dvec3 from = rays.origin + rays.middle;
    const double spread = std::max(1 + rays.w * depths.high, 0.0) * rays.spread +
                          rounding(0.5 * (least + most), glm::length(most - least));
    for (int k = 0; k < 3; ++k) {
        const double low = least[k] - spread - from[k], high = most[k] + spread - from[k];
        if (direction[k] == 0) {
            if (low > 0 || high < 0) return false;
            continue;
        }
        const double a = low / direction[k], b = high / direction[k];
        depths.low = std::max(depths.low, std::min(a, b));
        depths.high = std::min(depths.high, std::max(a, b));
    }
    return depths.low <= depths.high;
}

} // namespace

std::vector<gpu::Square> squares_of(const Blocks& blocks, BlockKind kind) {
    constexpr int largest = 4; // in blocks: not above gpu::Squares::longest_side
    static_assert(largest * Blocks::side <= gpu::Squares::longest_side);
    std::vector<gpu::Square> found;
    for (int y = 0; y < blocks.up; y += largest)
        for (int x = 0; x < blocks.across; x += largest)
            add_squares(blocks, kind, x, y, largest, found);
    return found;
}

Blocks blocks_in_bounds(const FrameBlock& frame, bool is_box, const gpu::Rectangle& tile) {
    const auto narrow = [](const glm::vec4& v) { return glm::dvec3(v); };
    const glm::dvec3 right = narrow(frame.ray_right), up = narrow(frame.ray_up);
    const glm::dvec3 least = narrow(frame.bounds_min), most = narrow(frame.bounds_max);
    BlockRays rays{
        narrow(frame.ray_origin), narrow(frame.ray_axis), {}, double(frame.ray_axis.w), 0};
    const glm::dvec3 centre = is_box ? 0.5 * (least + most) : least;
    const double radius = is_box ? 0.5 * glm::length(most - least) : double(frame.bounds_min.w);

    const glm::dvec3 forward = glm::normalize(glm::cross(up, right));
    const double depth = glm::dot(rays.axis, forward);
    const double middle = glm::dot(centre - rays.origin, forward) / depth;
    const double half = 1.001 * radius / std::abs(depth);
    const Depths depths{std::max(middle - half, -1.0), middle + half};

    const glm::dvec2 pixel(frame.picture.x, frame.picture.y);
    const double half_block = 0.5 * Blocks::side;
    rays.spread = half_block * (pixel.x * glm::length(right) + pixel.y * glm::length(up));
    Blocks blocks(tile.width, tile.height);
    for (int y = 0; y < blocks.up; ++y) {
        for (int x = 0; x < blocks.across; ++x) {
            const glm::dvec2 at =
                (glm::dvec2(tile.x + Blocks::side * x, tile.y + Blocks::side * y) + half_block) *
                    pixel -
                1.0;
            rays.middle = at.x * right + at.y * up;
            const bool meets =
                depths.low <= depths.high && (is_box ? meet_box(rays, depths, least, most)
                                                     : meet_sphere(rays, depths, centre, radius));
            blocks.at(x, y) = meets ? BlockKind::open : BlockKind::empty;
        }
    }
    return blocks;
}

} // namespace isomotion::render
