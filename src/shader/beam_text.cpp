#include "shader/beam_text.h"

#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "formula/glsl/glsl_interval.h"
#include "formula/glsl/glsl_model.h"
#include "formula/linear_sum.h"
#include "shader/beam_copies_text.h"
#include "shader/march_text.h"
#include "shader/model_text.h"
#include "shader/section_text.h"
#include "shader/shader_text.h"
#include "shader/surfaces_text.h"

namespace isomotion::shader {
namespace {

// What loops over an array in a beam's shader may add up to, once to make a list and once to walk.
// Lanes of blocks with lists of other lengths go through the longest of each, so that the driver's
// limit is spent up to six times over: llvmpipe ends all loops of a shader after 65535 turns.
constexpr int most_terms = 10'000;
// The first beams all go through all elements.
constexpr int most_terms_at_first = 20'000;

// The pieces that a beam's way is bounded in to make its lists.
int pieces_of(const BeamLevel& beam) { return beam.lists == BeamLists::whole ? 10 : 6; }

// What lists of elements need: the bound of F, and of what an element adds to its sum.
void add_bounds_of_sum(ShaderText& text, const formula::Field& field, const FieldStorage& storage) {
    const formula::LinearSum sum = formula::known_linear_sum(field);
    std::set<std::string> kernels = formula::interval_kernels_used(sum.rest_and_factor);
    kernels.merge(formula::interval_kernels_used(sum.term));
    add_field(text, field, storage, {FieldFunction::value_interval},
              {{field.text, std::move(kernels),
                formula::glsl_rest_and_factor_interval(sum, field.packing) +
                    formula::glsl_term_interval(sum, field.packing)}},
              true);
}

// Adds boxes around pieces of beams, within those of `parent` if it is not null.
void add_boxes(ShaderText& text, const scene::OneSurface& one, const PassPlan& plan,
               const BeamLevel* parent) {
    text.generated("generated: least and most tau, the shortest piece; rounding, a length",
                   "uniform vec4 beam;\n");
    define_bounds(text, one);
    if (parent && has_copies(plan))
        add_copies_of_parent(text, plan, int(parent - plan.beams.data()) + 1);
    if (parent) define_parent(text, *parent);
    if (parent) text.file("march/part_of_beam.glsl");
    text.file("march/beam_of_block.glsl");
}

// Bounds of Chebyshev polynomials, of waves and of noise cost more than the samples they save.
bool bounds_pay(const formula::Field& field) {
    for (std::size_t id = 0; id < field.graph.size(); ++id) {
        switch (field.graph[formula::NodeId(id)].op) {
        case formula::Op::chebyshev:
        case formula::Op::noise:
        case formula::Op::sin:
        case formula::Op::cos:
        case formula::Op::tan:
        case formula::Op::asin:
        case formula::Op::acos:
            return false;
        default:
            break;
        }
    }
    return true;
}

std::string name_of(const BeamLevel& beam) {
    return fmt::format("beams of {} pixel{}{}", beam.block, beam.block == 1 ? "" : "s",
                       beam.by_models ? " by models" : "");
}

// Declares the values that a beam's shader finds: attachments in fragment shaders, otherwise
// images.
void declare_results(ShaderText& text, Stage stage, std::span<const std::string_view> names) {
    const bool draws = stage == Stage::fragment;
    std::string declared, stored;
    for (std::size_t k = 0; k < names.size(); ++k) {
        if (!draws) {
            declared += fmt::format(
                "layout(rgba32f, binding = {0}) writeonly uniform image2D beam_image_{0};\n", k);
            stored += fmt::format("    imageStore(beam_image_{}, at, {});\n", k, names[k]);
        }
        const std::string as_output = draws ? fmt::format("layout(location = {}) out ", k) : "";
        declared += fmt::format("{}vec4 {};\n", as_output, names[k]);
    }
    if (!draws) declared += fmt::format("void store_results(ivec2 at) {{\n{}}}\n", stored);
    text.generated("generated: what a beam's shader finds", declared);
}

Pass beam_pass_by_intervals(const scene::OneSurface& one, const PassPlan& plan, int level) {
    const formula::Field& field = *one.surface.field;
    const BeamLevel& beam = plan.beams[std::size_t(level)];
    // The beams that these lie in.
    const BeamLevel* parent = level > 0 ? &beam - 1 : nullptr;
    ShaderText text(plan.stage);
    const bool makes_lists = beam.lists != BeamLists::none;
    const bool writes_buffer = makes_lists && !has_copies(plan);
    constexpr std::array<std::string_view, 3> results{"part", "lists", "list_of_all"};
    text.define(Feature::beam_boxes);
    declare_results(text, plan.stage, std::span(results).first(std::size_t(writes_buffer ? 3 : 1)));
    if (writes_buffer) text.version(430);
    define_blocks(text, beam);
    text.define(Feature::both_ends, int(beam.lists == BeamLists::whole));
    if (has_lists(plan)) {
        text.define(Feature::lists);
        text.define(Feature::left_out, parts_left_out);
        add_bounds_of_sum(text, field, storage_at_level(plan, level));
    } else {
        add_field(text, field, plan, {FieldFunction::value_interval});
    }
    if (array_with_grid(plan)) text.define(Feature::grid);
    if (makes_lists) {
        const bool whole = beam.lists == BeamLists::whole;
        text.define(Feature::front, fmt::format("{:#.3}", beam.front));
        text.define(Feature::list_of_all, int(whole));
        text.define(Feature::lists_of_a_block, lists_of_a_block(beam));
        text.define(Feature::texels, plan.arrays[0].texels);
        const int pieces = pieces_of(beam);
        text.define(Feature::pieces, pieces);
        text.define(Feature::front_pieces, whole ? int(std::lround(beam.front * pieces)) : pieces);
        text.define(Feature::most_terms, parent ? most_terms : most_terms_at_first);
        // Read as a texture: software renderers go through the lanes one by one to read a storage
        // buffer.
        if (writes_buffer)
            text.file("march/write_lists.glsl");
        else
            add_masks(text, plan);
    }
    text.file("frame.glsl");
    add_boxes(text, one, plan, parent);
    add_sections(text, one.scene);
    if (makes_lists) text.file("march/beam_list.glsl");
    text.file("march/beam_by_intervals.glsl");
    text.file("stage/main.glsl");
    Pass pass = std::move(text).pass(Role::beams, name_of(beam), When::once_a_tile);
    pass.level = level;
    return pass;
}

Pass beam_pass_by_models(const scene::OneSurface& one, const PassPlan& plan, int level) {
    const BeamLevel& beam = plan.beams[std::size_t(level)];
    ShaderText text(plan.stage);
    text.define(Feature::beam_boxes);
    declare_results(text, plan.stage, std::array<std::string_view, 2>{"part", "roots"});
    define_blocks(text, beam);
    if (one.surface.isolation.certify) text.define(Feature::both_ends);
    add_enclosures(text, *one.surface.field, plan, {});
    add_piece_models(text, *one.surface.field, "models/block.glsl");
    text.file("frame.glsl");
    add_boxes(text, one, plan, level > 0 ? &beam - 1 : nullptr);
    text.file("models/piece_of_block.glsl");
    text.define(Feature::bounds_rounding, "beam.w");
    add_inside_bounds(text, one);
    text.file("march/beam_by_models.glsl");
    text.file("stage/main.glsl");
    Pass pass = std::move(text).pass(Role::beams, name_of(beam), When::once_a_tile);
    pass.level = level;
    return pass;
}

void add_entrance_file(ShaderText& text, bool by_beams) {
    if (by_beams) {
        text.define(Feature::beams);
        text.file("march/part_of_beam.glsl");
    }
    text.file("march/enter_beam.glsl");
}

} // namespace

void define_blocks(ShaderText& text, const BeamLevel& beam) {
    text.define(Feature::block, beam.block);
    text.define(Feature::square_bits, beam.square_bits);
    text.define(Feature::squares_apart, beam_square);
    text.file("march/beam_place.glsl");
}

bool uses_beams(const scene::OneSurface& one) {
    return one.surface.isolation.beam.value_or(
        one.surface.isolation.method == scene::Method::hermite && bounds_pay(*one.surface.field));
}

Pass beam_pass(const scene::OneSurface& one, const PassPlan& plan, int level) {
    if (plan.beams[std::size_t(level)].by_models) return beam_pass_by_models(one, plan, level);
    return beam_pass_by_intervals(one, plan, level);
}

bool can_settle_blocks(const scene::OneSurface& one, int finest) {
    // Between two waves of a longer polynomial no block of 8 pixels lies in a usual picture, and
    // models of more products cost more than they save.
    const int most = bounds_pay(*one.surface.field) ? 10 : 8;
    const int degree = formula::modelled_degree(*one.surface.field);
    return one.surface.isolation.method == scene::Method::hermite &&
           one.surface.isolation.beam.value_or(true) && one.scene.sections.empty() &&
           one.is_alone() && degree > 0 && degree <= most && finest > 1;
}

bool lies_in_beams(const PassPlan& plan, int block) {
    return !plan.beams.empty() && plan.beams.back().block >= block;
}

void define_parent(ShaderText& text, const BeamLevel& parent) {
    if (parent.by_models) text.define(Feature::parent_settles);
    text.define(Feature::parent_block, parent.block);
    text.define(Feature::parent_square_bits, parent.square_bits);
}

void add_beam_of_block(ShaderText& text, const scene::OneSurface& one, const PassPlan& plan,
                       int block) {
    add_boxes(text, one, plan, lies_in_beams(plan, block) ? &plan.beams.back() : nullptr);
}

void add_light_beams(ShaderText& text, const PassPlan& plan) {
    define_blocks(text, plan.beams.back());
    if (has_lists(plan)) text.file("march/choose_list.glsl");
    text.file("effects/light_beam.glsl");
}

void add_entrance(ShaderText& text, const PassPlan& plan, bool by_beams) {
    if (by_beams) define_blocks(text, plan.beams.back());
    if (by_beams && has_lists(plan)) {
        text.file("march/choose_list.glsl");
        if (has_copies(plan)) add_copies_of_ray(text, plan);
    }
    add_entrance_file(text, by_beams);
}

void add_way(ShaderText& text, const PassPlan& plan, bool by_beams) {
    if (by_beams) define_blocks(text, plan.beams.back());
    add_entrance_file(text, by_beams);
}

BeamLevel level_by_models(int finest) { return {finest, BeamLists::none, 1, 4, true}; }

std::vector<BeamLevel> beam_levels(const FieldStorage& storage, int finest) {
    using enum BeamLists;
    // A picture of 512 pixels has 16 squares of the smaller blocks, 4 of the largest. Squares of
    // single pixels lie side by side.
    const int bits = finest == 1 ? 6 : 4;
    if (!has_lists(storage)) return {{finest, none, 1, bits}};
    // Fewer programs: a page shows its first picture when all are compiled. Beams of 16 pixels that
    // go through more elements than these take longer than two levels.
    if (has_copies(storage) && storage.arrays[0].capacity <= 32)
        return {{16, whole, 0.3, 3}, {finest, front, 0.12, bits}};
    return {{64, whole, 0.3, 2}, {16, whole, 0.3, 3}, {finest, front, 0.12, bits}};
}

} // namespace isomotion::shader
