#include "shader/proof_text.h"

#include <algorithm>

#include "formula/enclosure.h"
#include "formula/glsl/glsl_model.h"
#include "shader/beam_text.h"
#include "shader/march_text.h"
#include "shader/model_text.h"
#include "shader/shader_text.h"
#include "shader/surfaces_text.h"

namespace isomotion::shader {
namespace {

// Operations on numbers that one on models counts as: of a ray's, and of a block's.
constexpr double model_operations = 36, block_model_operations = 90;

// Whether F is proved by models (formula/glsl/glsl_model.h) rather than by bounds on it and its
// slope. Where doubles aren't to be had, bounds are what tries again what models leave open.
bool goes_by_models(const formula::Field& field, const FieldStorage& storage, ProofBounds bounds) {
    return bounds != ProofBounds::by_gradient && !storage.tapes &&
           formula::modelled_degree(field) > 0;
}

// Adds models of F around points.
void add_value_models(ShaderText& text, const formula::Field& field, formula::Numbers numbers) {
    add_models(text, field, "PointModel", "models/point.glsl", numbers);
    text.define(Feature::value_by_model);
    text.file("proof/value.glsl");
}

// What a proof by bounds asks of the field.
std::vector<FieldFunction> samples_of_block() { return {FieldFunction::directional_interval}; }

// A ray and how it ended.
void add_ended_ray(ShaderText& text, const scene::OneSurface& one) {
    text.file("frame.glsl");
    text.file("march/verdict.glsl");
    define_bounds(text, one);
    text.define(one.is_alone() ? Feature::eye_rays : Feature::ended_rays);
    text.file("march/ray.glsl");
    text.file("proof/ending.glsl");
}

// Beams by models tell proofs more than rays begin and end by.
void add_trimmed_ends(ShaderText& text, const PassPlan& plan) {
    if (!settles_blocks(plan)) return;
    text.define(Feature::trimmed);
}

void add_by_place(ShaderText& text, const PassPlan& plan) {
    if (array_with_grid(plan)) text.define(Feature::grid);
}

// Second derivatives are taken in doubles, where rounding no longer hides their gain, and where
// there are such bounds. They are not taken where elements are found by place: slopes of two lists
// differ by those of what either leaves out, which have no bound.
bool takes_hessian(const formula::Field& field, const FieldStorage& storage, ProofBounds bounds) {
    return bounds == ProofBounds::in_doubles && !array_with_grid(storage) && !storage.tapes &&
           formula::hessian_program(field);
}

std::vector<FieldFunction> samples_of_ray(const formula::Field& field, const FieldStorage& storage,
                                          ProofBounds bounds) {
    std::vector samples{FieldFunction::value_interval, FieldFunction::directional_interval};
    if (bounds != ProofBounds::natural) samples.push_back(FieldFunction::gradient_interval);
    if (takes_hessian(field, storage, bounds)) samples.push_back(FieldFunction::hessian_interval);
    return samples;
}

// Adds what a ray's proof begins with: the part it is of, the boxes around it, what F can be in
// one.
void add_proof(ShaderText& text, const scene::OneSurface& one, const PassPlan& plan,
               ProofBounds bounds) {
    add_ended_ray(text, one);
    if (has_lists(plan)) text.define(Feature::lists);
    add_trimmed_ends(text, plan);
    add_entrance(text, plan, !plan.beams.empty());
    text.file("proof/rounding.glsl");
    if (has_lists(plan)) text.file("proof/lists.glsl");
    if (bounds == ProofBounds::in_doubles) text.define(Feature::doubles);
    text.file("proof/ray.glsl");
    add_inside_bounds(text, one);
}

void add_value_at(ShaderText& text, ProofBounds bounds) {
    if (bounds != ProofBounds::natural) text.define(Feature::value_by_gradient);
    text.file("proof/value.glsl");
}

// The bounds on F at a root with which proofs of single rays begin. Terms of one sum do not cancel
// as a polynomial's do, so that natural bounds are close.
ProofBounds bounds_at_root(const FieldStorage& storage) {
    return has_lists(storage) ? ProofBounds::natural : ProofBounds::by_gradient;
}

// Takes the place of pixels that fragments lie on.
void add_packed(ShaderText& text) {
    text.define(Feature::proved_block, proved_block);
    text.define(Feature::list_across, open_list_across);
    text.file("proof/packed.glsl");
}

// Proofs of single rays by models.
void add_ray_models(ShaderText& text, const formula::Field& field, formula::Numbers numbers) {
    add_value_models(text, field, numbers);
    const bool again = numbers == formula::Numbers::doubles;
    add_piece_models(text, field, again ? "models/turning_ray.glsl" : "models/ray.glsl", numbers);
    text.file("models/piece_of_ray.glsl");
    text.file("proof/prove_by_models.glsl");
}

// The same by bounds, of which the text must have the functions.
void add_ray_bounds(ShaderText& text, const formula::Field& field, const PassPlan& plan,
                    ProofBounds bounds) {
    add_value_at(text, bounds);
    if (takes_hessian(field, plan, bounds)) text.define(Feature::hessian);
    text.file("proof/bounds_of_piece.glsl");
    text.file("proof/prove.glsl");
}

Pass block_proof(const scene::OneSurface& one, const PassPlan& plan, Role role) {
    const formula::Field& field = *one.surface.field;
    const bool by_models = goes_by_models(field, plan, ProofBounds::natural);
    const bool is_coarse = role == Role::coarse_block_proof;
    const int block = is_coarse ? coarse_proved_block : proved_block;
    ShaderText text;
    text.define(Feature::block, block);
    text.define(Feature::rays, block * block);
    text.define(Feature::squares_apart, beam_square);
    text.file("march/beam_place.glsl");
    if (by_models) {
        if (is_coarse) text.define(Feature::coarse);
        if (!is_coarse && !settles_blocks(plan))
            text.define(Feature::coarse_block, coarse_proved_block);
        add_enclosures(text, field, plan, {});
        add_piece_models(text, field, "models/block.glsl");
    } else {
        add_enclosures(text, field, plan, samples_of_block());
    }
    add_by_place(text, plan);
    text.file("frame.glsl");
    text.file("march/verdict.glsl");
    text.file("proof/ending.glsl");
    text.file("proof/rounding.glsl");
    if (has_lists(plan)) text.define(Feature::lists);
    add_trimmed_ends(text, plan);
    add_beam_of_block(text, one, plan, block);
    if (has_lists(plan)) text.file("proof/lists.glsl");
    if (by_models) {
        text.file("models/piece_of_block.glsl");
        if (!is_coarse) add_inside_bounds(text, one);
        if (!is_coarse && settles_blocks(plan)) text.file("march/slab.glsl");
        text.file("proof/roots_of_block.glsl");
    }
    text.file(by_models ? "proof/block_by_models.frag" : "proof/block.frag");
    return std::move(text).pass(role, is_coarse ? "coarse block proof" : "block proof",
                                When::once_a_tile);
}

Pass block_mask(const PassPlan& plan) {
    ShaderText text;
    text.define(Feature::block, proved_block);
    text.define(Feature::squares_apart, beam_square);
    text.file("march/beam_place.glsl");
    define_parent(text, plan.beams.back());
    text.file("proof/rounding.glsl");
    text.file("march/part_of_beam.glsl");
    text.file("proof/block_mask.frag");
    return std::move(text).pass(Role::block_mask, "block mask", When::once_a_tile);
}

Pass first_proof(const scene::OneSurface& one, const PassPlan& plan) {
    const formula::Field& field = *one.surface.field;
    const bool by_models = goes_by_models(field, plan, ProofBounds::natural);
    ShaderText text;
    text.define(Feature::whole_blocks);
    add_packed(text);
    if (by_models) {
        add_enclosures(text, field, plan, {});
        add_proof(text, one, plan, ProofBounds::natural);
        add_value_models(text, field, formula::Numbers::floats);
    } else {
        const ProofBounds bounds = bounds_at_root(plan);
        std::vector functions{FieldFunction::value_interval};
        if (bounds == ProofBounds::by_gradient)
            functions.push_back(FieldFunction::gradient_interval);
        add_enclosures(text, field, plan, functions);
        add_proof(text, one, plan, bounds);
        add_value_at(text, bounds);
    }
    text.file("proof/begin.frag");
    return std::move(text).pass(Role::first_proof, "first proof", When::once_a_tile);
}

Pass proof(const scene::OneSurface& one, const PassPlan& plan, ProofBounds bounds) {
    const formula::Field& field = *one.surface.field;
    ShaderText text;
    const bool in_doubles = bounds == ProofBounds::in_doubles;
    const auto numbers = in_doubles ? formula::Numbers::doubles : formula::Numbers::floats;
    if (in_doubles) text.version(400);
    add_packed(text);
    if (goes_by_models(field, plan, bounds)) {
        add_enclosures(text, field, plan, {}, numbers);
        add_by_place(text, plan);
        add_proof(text, one, plan, bounds);
        add_ray_models(text, field, numbers);
    } else {
        add_enclosures(text, field, plan, samples_of_ray(field, plan, bounds), numbers);
        add_by_place(text, plan);
        add_proof(text, one, plan, bounds);
        add_ray_bounds(text, field, plan, bounds);
    }
    text.file("proof/proof.frag");
    switch (bounds) {
    case ProofBounds::natural:
        break;
    case ProofBounds::by_gradient:
        return std::move(text).pass(Role::sharp_proof, "sharp proof", When::where_proof_is_open);
    case ProofBounds::in_doubles:
        return std::move(text).pass(Role::double_proof, "double proof", When::where_proof_is_open);
    }
    return std::move(text).pass(Role::proof, "proof", When::once_a_tile);
}

Pass ending_of_surface(const scene::OneSurface& one) {
    ShaderText text;
    text.file("math/bits.glsl");
    add_ray(text, one);
    text.file("surfaces/way.glsl");
    text.file("proof/ending_of_surface.frag");
    return std::move(text).pass(Role::ending, "ending", When::once_a_tile);
}

} // namespace

formula::Cost cost_of_block_piece(const formula::Field& field, const FieldStorage& storage,
                                  std::span<const int> counts) {
    if (!goes_by_models(field, storage, ProofBounds::natural))
        return cost(field, storage, samples_of_block(), counts);
    formula::Cost piece = cost(field, storage, {FieldFunction::value}, counts);
    piece.operations *= block_model_operations;
    return piece;
}

formula::Cost cost_of_piece(const formula::Field& field, const FieldStorage& storage,
                            ProofBounds bounds, std::span<const int> counts) {
    if (!goes_by_models(field, storage, bounds))
        return cost(field, storage, samples_of_ray(field, storage, bounds), counts);
    formula::Cost piece = cost(field, storage, {FieldFunction::value}, counts);
    piece.operations *= model_operations;
    return piece;
}

std::vector<Pass> proof_passes(const scene::OneSurface& one, const PassPlan& plan) {
    std::vector<Pass> list;
    if (!one.is_alone()) list.push_back(ending_of_surface(one));
    // Beams by models have proved as much.
    if (goes_by_models(*one.surface.field, plan, ProofBounds::natural) && !settles_blocks(plan))
        list.push_back(block_proof(one, plan, Role::coarse_block_proof));
    if (lies_in_beams(plan, proved_block)) list.push_back(block_mask(plan));
    list.push_back(block_proof(one, plan, Role::block_proof));
    list.push_back(first_proof(one, plan));
    list.push_back(proof(one, plan, ProofBounds::natural));
    list.push_back(proof(one, plan, ProofBounds::by_gradient));
    // Tapes are run on floats alone.
    if (!plan.tapes) list.push_back(proof(one, plan, ProofBounds::in_doubles));
    return list;
}

} // namespace isomotion::shader
