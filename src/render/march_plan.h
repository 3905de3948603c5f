// How a picture is cut into draw calls.
//
// Two things bound a draw. llvmpipe ends every loop of a shader, silently, after 65535 iterations
// summed over all its loops, so a pass evaluates the field only as often as fits. And a draw call
// of seconds freezes a desktop or gets the GPU reset, so tiles and passes are cut to a bounded
// amount of arithmetic. The picture doesn't depend on the plan: a ray goes on exactly where it
// stopped.
#pragma once

#include "formula/graph/program.h"
#include "synthesis/loop_limit.h"

namespace isomotion::render {

struct MarchPlan {
    int tile_width = 0, tile_height = 0;
    int evaluations_per_pass = 0;
};

using synthesis::loop_iterations_per_pass;
// Arithmetic operations in one draw: about a second on two cores of a software renderer.
inline constexpr double operations_per_draw = 1e10;

// And of the field or its gradient once: the smallest tile, which one thread of a software renderer
// draws, takes some seconds then, whatever is planned.
inline constexpr double operations_at_a_point = 2e7;

// `evaluation` is the cost of sampling the field once. Throws std::length_error if one evaluation
// alone passes the loop limit or takes more operations than a point may.
MarchPlan plan_march(const formula::Cost& evaluation, int width, int height, int max_tile);

// Throws std::length_error where that is more than a point may take.
void expect_drawable(double operations);

// `planned`, or more where the samples of a polynomial, which no ray keeps from pass to pass, need
// it. `iterations` is what the loops of one evaluation add up to; throws std::length_error where a
// shader can't do so many.
int evaluations_with_polynomial(int degree, double iterations, int planned);

} // namespace isomotion::render
