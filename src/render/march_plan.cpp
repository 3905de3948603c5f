#include "render/march_plan.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace isomotion::render {

void expect_drawable(double operations) {
    if (operations <= operations_at_a_point) return;
    throw std::length_error(
        fmt::format("the formula or its gradient takes {:.3g} operations at every point, all "
                    "elements of its sums counted; a picture is drawn of at most {:.3g}",
                    operations, operations_at_a_point));
}

double operations_per_draw_at(double operations_a_second) {
    constexpr double reached = 0.05, seconds = 0.5;
    constexpr double most = 1e12;
    return std::clamp(reached * seconds * operations_a_second, operations_per_draw, most);
}

MarchPlan plan_march(const formula::Cost& evaluation, int width, int height, int max_tile,
                     const DrawLimits& limits) {
    const double by_loops = loop_iterations_per_pass / (1 + evaluation.iterations);
    if (by_loops < 1) {
        throw std::length_error(
            fmt::format("the formula sums {:.0f} terms at every point; a shader can sum {:.0f}",
                        evaluation.iterations, loop_iterations_per_pass - 1));
    }
    expect_drawable(evaluation.operations);
    constexpr double march_operations = 40;   // of a step beside the field
    constexpr double useful_evaluations = 64; // fewer a pass and the passes' own cost shows
    const double operations = evaluation.operations + march_operations;

    MarchPlan plan;
    const double evaluations = std::min(useful_evaluations, by_loops);
    constexpr int square = 64; // of a software renderer's thread
    int tile = square;
    const auto can_grow = [&](double evaluations_of_a_pixel) {
        return 2 * tile <= max_tile &&
               4.0 * tile * tile * operations * evaluations_of_a_pixel <= limits.operations;
    };
    while (can_grow(evaluations)) tile *= 2;
    const double pixels = double(std::min(tile, width)) * std::min(tile, height);
    const double by_work = limits.operations / (pixels * operations);
    const auto squares = [&] { return (tile / square) * (tile / square); };
    // The limit is of two threads.
    while (limits.threads > 1 && squares() < 32 * limits.threads && can_grow(2.0 / limits.threads))
        tile *= 2;
    plan.tile_width = std::min(tile, width);
    plan.tile_height = std::min(tile, height);
    plan.evaluations_per_pass = int(std::clamp(std::min(by_work, by_loops), 1.0, 60'000.0));
    return plan;
}

} // namespace isomotion::render
