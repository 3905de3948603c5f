// Divides a picture into draw calls.
//
// Two limits apply to a draw. First, llvmpipe silently ends every loop of a shader after 65535
// iterations summed over all its loops; so a pass limits its evaluations of the field. Second, a
// draw call of several seconds freezes a desktop or makes the driver reset the GPU; so tiles and
// passes have a limited amount of arithmetic. The picture doesn't depend on the plan: a ray
// continues exactly where it stopped.
#pragma once

#include <glm/vec2.hpp>

#include "formula/graph/program.h"
#include "shader/loop_limit.h"

namespace isomotion::render {

struct MarchPlan {
    int tile_width = 0, tile_height = 0;
    int evaluations_per_pass = 0;
    int most_evaluations_per_pass = 0; // where few rays are open yet; 0: no more
    // Whether small pictures begin at corner_of_picture().
    bool spreads_small_pictures = false;

    // Whether a picture of that size is one tile.
    bool holds(int width, int height) const { return width <= tile_width && height <= tile_height; }
    // Where a picture of that size begins in its targets.
    glm::ivec2 corner_of(int width, int height) const;

    // The size of targets that hold a tile.
    int target_width() const;
    int target_height() const;
};

using shader::loop_iterations_per_pass;
// Arithmetic operations in one draw: about a second on two cores with a software renderer.
inline constexpr double operations_per_draw = 1e10;
// For hardware that does so many operations a second in this stage (0: not known), at the
// 5 % of them that marches reach: half a second.
double operations_per_draw_at(double operations_a_second);

// Operations of one ray in one draw: some tenths of a second, as they follow one another.
inline constexpr double operations_of_a_ray = 1e8;

// What a draw may be given.
struct DrawLimits {
    double operations = operations_per_draw;
    // A software renderer shares a draw among its threads, square by square of 64x64 pixels. Tiles
    // that these operations leave small grow up to 512 pixels a side, to 32 squares for each
    // thread, as long as a draw takes at most 8 times the operations for each thread.
    int threads = 1;
};

// Limit on the operations of the field or its gradient at one point. Near it the smallest tile,
// which one thread of a software renderer draws, takes some seconds, whatever the plan.
inline constexpr double operations_at_a_point = 2e7;

// `evaluation` is the cost of sampling the field once. Throws std::length_error if one evaluation
// alone exceeds the loop limit or the operations allowed at a point.
MarchPlan plan_march(const formula::Cost& evaluation, int width, int height, int max_tile,
                     const DrawLimits& limits = {});

// Targets that hold small pictures have at least so many pixels a side.
inline constexpr int side_for_small_pictures = 128;

// Where a picture begins in its targets, in pixels, so that several threads of a software renderer
// draw it: one of at most 64x64 pixels lies about the corner of four squares of these. Multiples of
// 8, so that blocks of rays stay the same; 0 along sides that are longer.
glm::ivec2 corner_of_picture(int width, int height);

// Throws std::length_error if this exceeds the operations allowed at a point.
void expect_drawable(double operations);

} // namespace isomotion::render
