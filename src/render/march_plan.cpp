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

namespace {

// Pixels along the side of a square that a software renderer gives to one of its threads.
constexpr int side_of_a_thread = 64;

// The tile grown until it has enough squares for all threads.
template<class Work>
int shared_tile(int tile, int most, const DrawLimits& limits, const Work& work) {
    const double shared = 8.0 * limits.threads * limits.operations;
    while (limits.threads > 1 && 2 * tile <= most && work(2 * tile) <= shared &&
           tile / side_of_a_thread * (tile / side_of_a_thread) < 32 * limits.threads)
        tile *= 2;
    return tile;
}

// Small pictures lie in two squares along each side.
int length_of_target(bool spreads, int tile) {
    return spreads ? std::max(tile, side_for_small_pictures) : tile;
}

} // namespace

glm::ivec2 MarchPlan::corner_of(int width, int height) const {
    return spreads_small_pictures && holds(width, height) ? corner_of_picture(width, height)
                                                          : glm::ivec2(0);
}

int MarchPlan::target_width() const { return length_of_target(spreads_small_pictures, tile_width); }

int MarchPlan::target_height() const {
    return length_of_target(spreads_small_pictures, tile_height);
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
    int tile = 64;
    while (2 * tile <= max_tile &&
           4.0 * tile * tile * operations * evaluations <= limits.operations) {
        tile *= 2;
    }
    const auto work = [&](int side, double evaluations_of_a_ray) {
        return double(std::min(side, width)) * std::min(side, height) * operations *
               evaluations_of_a_ray;
    };
    plan.evaluations_per_pass =
        int(std::clamp(std::min(limits.operations / work(tile, 1), by_loops), 1.0, 60'000.0));
    // Hard rays also take loops that no evaluation tells: where bounds judge, and past free cells.
    plan.most_evaluations_per_pass =
        int(std::clamp(std::min(operations_of_a_ray / operations, by_loops / 3),
                       double(plan.evaluations_per_pass), 60'000.0));
    tile = shared_tile(tile, std::min(max_tile, 512), limits,
                       [&](int side) { return work(side, plan.evaluations_per_pass); });
    plan.tile_width = std::min(tile, width);
    plan.tile_height = std::min(tile, height);
    return plan;
}

glm::ivec2 corner_of_picture(int width, int height) {
    const auto corner = [](int length) {
        constexpr int block = 8;
        return length > side_of_a_thread
                   ? 0
                   : side_of_a_thread - block * ((length + 2 * block - 1) / (2 * block));
    };
    return {corner(width), corner(height)};
}

} // namespace isomotion::render
