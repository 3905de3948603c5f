#include "render/scene_plan.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "shader/paint_text.h"
#include "shader/section_text.h"

namespace isomotion::render {
namespace {

// A list of the elements that matter in a beam is reckoned with so many; rays with longer lists
// take more passes.
constexpr int usual_list = 16;
// A list of a cell of a grid is reckoned with so many elements.
constexpr int usual_list_of_a_cell = 32;

// Part of the loops of a draw for what is gone through beside lists.
constexpr double part_of_others = 0.2;

constexpr int largest_tile = 2048;

std::vector<int> capacities(const shader::Passes& passes) {
    std::vector<int> counts;
    for (const auto& array : passes.arrays) counts.push_back(array.capacity);
    return counts;
}

double loops_of(const formula::Program& program, const std::vector<int>& counts) {
    return formula::cost(program, counts).iterations;
}

using shader::FieldFunction;

double loops_of(const scene::OneSurface& one, const shader::Passes& passes, FieldFunction function,
                const std::vector<int>& counts) {
    return shader::cost(*one.surface.field, passes, {function}, counts).iterations;
}

// How often a pixel's shader asks for the surface's colour: a mirror weighs what it shows by it,
// and the surface seen in it does both again.
int colours_of_a_pixel(const scene::OneSurface& one) {
    using Reflection = scene::Material::Reflection;
    switch (one.surface.material.reflection) {
    case Reflection::none:
        break;
    case Reflection::sky:
        return 2;
    case Reflection::self:
        return 4;
    }
    return 1;
}

// What the loops of one shaded pixel add up to.
double shade_iterations(const scene::OneSurface& one, const shader::Passes& passes,
                        const std::vector<int>& counts) {
    const double gradient =
        passes.march_takes_gradient ? 0.0 : loops_of(one, passes, FieldFunction::gradient, counts);
    const auto loops_of_paint = [&](const formula::Paint& paint) {
        const bool all = shader::sums_all_elements(paint, passes);
        return loops_of(paint.value, all ? capacities(passes) : counts);
    };
    const int colours = colours_of_a_pixel(one);
    double sum = gradient;
    if (const auto& contours = one.surface.material.contours)
        sum += colours * loops_of_paint(*contours->value);
    const formula::Paint* paint = shader::painting(one);
    if (!paint) return sum;
    const double curvature = paint->hessian ? gradient + loops_of(*paint->hessian, counts) : 0.0;
    return sum + colours * (curvature + loops_of_paint(*paint));
}

[[noreturn]] void fail_for_length(double turns) {
    throw std::length_error(fmt::format(
        "the formula is too long: its instructions take {:.0f} turns of a loop for a pixel's "
        "normal "
        "and colour, and a shader can take {:.0f}; name what it repeats, or sum over an array",
        turns, loop_iterations_per_pass));
}

// The passes that don't march must fit the loop limit, too; they know no lists.
void expect_shadeable(const scene::OneSurface& one, const shader::Passes& passes,
                      const std::vector<int>& counts) {
    const double gradient = loops_of(one, passes, FieldFunction::gradient, counts);
    if (passes.has(shader::Role::surface)) {
        // Occlusion takes up to eight samples at the end of a ray (shaders/effects/end_of_ray.glsl)
        // and five of its surroundings, each in one draw.
        const double occlusion = passes.has(shader::Role::occlusion)
                                     ? 5 * gradient
                                     : 0.0; // of several surfaces: six values and five gradients
        // Glass looks for the side that a ray goes on from, too.
        const int samples = passes.has(shader::Role::glass) ? 16 : 8;
        const double end = std::max(gradient, occlusion) +
                           samples * loops_of(one, passes, FieldFunction::value, counts);
        if (end > loop_iterations_per_pass) {
            throw std::length_error(
                fmt::format("shadows, mirrors and other effects sum {:.0f} terms a pixel; a "
                            "shader can sum {:.0f}: draw fewer elements or no effects",
                            end, loop_iterations_per_pass));
        }
    }
    const double sums = shade_iterations(one, passes, counts);
    if (sums > loop_iterations_per_pass && passes.tapes) fail_for_length(sums);
    const formula::Paint* paint = shader::painting(one);
    if (sums > loop_iterations_per_pass && paint && shader::sums_all_elements(*paint, passes)) {
        throw std::length_error(
            fmt::format("the normal and the colour sum {:.0f} terms a pixel; a shader can sum "
                        "{:.0f}: draw fewer elements, or weigh them in the colour by the terms of "
                        "the formula's sums, whose elements are found by place",
                        sums, loop_iterations_per_pass));
    }
    if (sums > loop_iterations_per_pass) {
        throw std::length_error(
            fmt::format("the normal and the paint sum {:.0f} terms a pixel; a shader can sum "
                        "{:.0f}: draw fewer elements or no paint",
                        sums, loop_iterations_per_pass));
    }
    expect_drawable(
        shader::cost(*one.surface.field, passes, {FieldFunction::gradient}, counts).operations);
}

// What an evaluation goes through where elements are found by place, beside its lists, in
// each of the cells that a box meets.
double turns_beside_lists(const scene::OneSurface& one, const shader::Passes& passes,
                          std::size_t array) {
    std::vector<int> others = capacities(passes);
    others[array] = 0;
    const bool over_boxes = std::ranges::any_of(passes.samples, shader::is_on_intervals);
    const double turns =
        1 + shader::cost(*one.surface.field, passes, passes.samples, others).iterations;
    return over_boxes ? shader::most_cells_of_box * turns : turns;
}

// Shares the evaluations that a draw has room for among the parts that sections leave of a ray:
// what a march may take in each, beside F where parts begin and end.
int of_a_part(const scene::OneSurface& one, int evaluations) {
    if (one.scene.sections.empty()) return evaluations;
    const int shared =
        (evaluations - shader::samples_at_sections(one.scene)) / shader::parts_of_a_ray(one.scene);
    if (shared >= 1) return shared;
    throw std::length_error(fmt::format(
        "a draw has room for {} evaluations of the formula at a pixel, and {} sections take {}: "
        "draw fewer elements, or fewer sections",
        evaluations, one.scene.sections.size(),
        shader::samples_at_sections(one.scene) + shader::parts_of_a_ray(one.scene)));
}

MarchPlan plan_of_march(const scene::OneSurface& one, const shader::Passes& passes, int width,
                        int height, int max_texture_size, const std::optional<MarchPlan>& wanted,
                        const DrawLimits& limits) {
    const std::vector<int> counts = capacities(passes);
    std::vector<int> usual = elements_by_place(passes);
    if (shader::has_lists(passes)) usual[0] = std::min(usual[0], usual_list);
    const auto by_place = shader::array_with_grid(passes);
    formula::Cost cost = shader::cost(*one.surface.field, passes, passes.samples, usual);
    // Where F may seem to touch 0, bounds run tapes for a third of a draw's loops.
    const bool judges_touches =
        passes.tapes &&
        passes.samples == std::vector{FieldFunction::directional, FieldFunction::value_interval};
    if (judges_touches) cost.iterations *= 1.5;
    expect_shadeable(one, passes, by_place ? usual : counts);
    cost.iterations = std::max(cost.iterations, shade_iterations(one, passes, usual));
    const MarchPlan fitting =
        plan_march(cost, width, height, std::min(largest_tile, max_texture_size), limits);
    MarchPlan chosen = wanted.value_or(fitting);
    double most = loop_iterations_per_pass;
    // One draw marches and shades.
    const double with_shade =
        (loop_iterations_per_pass - shade_iterations(one, passes, by_place ? usual : counts)) /
        (1 + cost.iterations);
    if (passes.has(shader::Role::fused) && with_shade >= 1) most = with_shade;
    if (by_place) {
        const double fitting_others = part_of_others * loop_iterations_per_pass /
                                      turns_beside_lists(one, passes, std::size_t(*by_place));
        most = std::min(most, std::max(fitting_others, 1.0));
    }
    for (int* evaluations : {&chosen.evaluations_per_pass, &chosen.most_evaluations_per_pass}) {
        if (*evaluations > 0) *evaluations = of_a_part(one, std::min(*evaluations, int(most)));
    }
    return chosen;
}

int without_lists(const scene::OneSurface& one, const shader::Passes& passes, int planned) {
    const formula::Cost all =
        shader::cost(*one.surface.field, passes, passes.samples, capacities(passes));
    const int fitting = int(loop_iterations_per_pass / (1 + all.iterations));
    return std::clamp(of_a_part(one, fitting), 1, planned);
}

// Elements of an array found by place: as many as the loops that shade a pixel can take.
std::uint32_t most_at_a_place(const scene::OneSurface& one, const shader::Passes& passes) {
    constexpr double most = 50'000;
    const auto array = shader::array_with_grid(passes);
    if (!array) return std::uint32_t(most);
    std::vector<int> counts = capacities(passes);
    counts[std::size_t(*array)] = 0;
    const double others = shade_iterations(one, passes, counts);
    counts[std::size_t(*array)] = 1;
    const double each = shade_iterations(one, passes, counts) - others;
    return std::uint32_t(
        std::clamp((loop_iterations_per_pass - others) / std::max(each, 1.0), 1.0, most));
}

// Where only lists tell how many elements an evaluation takes.
float budget_of_elements(const scene::OneSurface& one, const shader::Passes& passes) {
    const auto once = std::vector<int>(passes.arrays.size(), 1);
    const double loops =
        std::max(1.0, shader::cost(*one.surface.field, passes, passes.samples, once).iterations);
    return float((1 - part_of_others) * loop_iterations_per_pass / loops /
                 shader::parts_of_a_ray(one.scene));
}

} // namespace

std::vector<int> elements_by_place(const shader::Passes& passes) {
    std::vector<int> counts = capacities(passes);
    if (const auto by_place = shader::array_with_grid(passes)) {
        int& elements = counts[std::size_t(*by_place)];
        elements = std::min(elements, usual_list_of_a_cell);
    }
    return counts;
}

bool are_lists_long(const elements::ElementGrid& grid, const ScenePlan& plan) {
    constexpr double hard_ray = 50;         // evaluations
    constexpr double part_of_lists = 0.125; // of the budget: shaders/march/march.glsl
    return hard_ray * grid.usual_count() > part_of_lists * plan.element_budget;
}

ScenePlan plan_scene(const scene::OneSurface& one, const shader::Passes& passes, int width,
                     int height, int max_texture_size, const std::optional<MarchPlan>& wanted,
                     const DrawLimits& limits) {
    ScenePlan plan;
    plan.march = plan_of_march(one, passes, width, height, max_texture_size, wanted, limits);
    const auto [usual, most] =
        std::pair(plan.march.evaluations_per_pass, plan.march.most_evaluations_per_pass);
    plan.evaluations_without_lists = without_lists(one, passes, usual);
    plan.most_evaluations_without_lists = without_lists(one, passes, std::max(usual, most));
    plan.most_elements_at_a_place = most_at_a_place(one, passes);
    plan.element_budget = budget_of_elements(one, passes);
    return plan;
}

} // namespace isomotion::render
