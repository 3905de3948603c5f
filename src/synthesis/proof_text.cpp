#include "synthesis/proof_text.h"

#include "formula/enclosure.h"
#include "synthesis/beam_text.h"
#include "synthesis/shader_text.h"

namespace isomotion::synthesis {
namespace {

// A ray and how it ended.
void add_ended_ray(ShaderText& text, const scene::Scene& scene) {
    const bool box = scene.surface.bounds.shape == scene::Bounds::Shape::box;
    text.file("frame.glsl");
    text.file("march/verdict.glsl");
    text.file(box ? "march/clip_box.glsl" : "march/clip_sphere.glsl");
    text.file("march/ray.glsl");
    text.file("proof/ending.glsl");
}

void add_by_place(ShaderText& text, const Passes& passes) {
    if (array_with_grid(passes)) text.define("GRID", 1);
    text.file("proof/by_place.glsl");
}

// In doubles, where rounding no longer hides it, and where there are such bounds. Not where
// elements are found by place: slopes of two lists differ by those of what either leaves out, which
// have no bound.
bool takes_hessian(const formula::Field& field, const FieldStorage& storage, ProofBounds bounds) {
    return bounds == ProofBounds::in_doubles && !array_with_grid(storage) &&
           formula::hessian_program(field);
}

// What its proof begins with: the part it is of, the boxes around it, what F can be in one.
void add_proof(ShaderText& text, const scene::Scene& scene, const Passes& passes,
               ProofBounds bounds) {
    const bool box = scene.surface.bounds.shape == scene::Bounds::Shape::box;
    add_ended_ray(text, scene);
    add_way(text, passes, !passes.beams.empty());
    text.define("PROVED_BLOCK", proved_block);
    text.file("proof/rounding.glsl");
    text.file("proof/way.glsl");
    text.file("proof/outcome.glsl");
    text.file(bounds == ProofBounds::in_doubles ? "proof/in_doubles.glsl" : "proof/in_floats.glsl");
    text.file("proof/tube.glsl");
    text.file(box ? "proof/inside_box.glsl" : "proof/inside_sphere.glsl");
    text.file(bounds == ProofBounds::natural ? "proof/value_over_box.glsl"
                                             : "proof/value_by_gradient.glsl");
}

Pass block_proof(const scene::Scene& scene, const Passes& passes) {
    ShaderText text;
    text.define("BLOCK", proved_block);
    text.define("RAYS", proved_block * proved_block);
    text.define("SQUARES_APART", beam_square);
    text.file("march/beam_place.glsl");
    add_enclosures(text, *scene.surface.field, passes, block_proof_samples());
    add_by_place(text, passes);
    text.file("frame.glsl");
    text.file("march/verdict.glsl");
    text.file("proof/ending.glsl");
    text.file("proof/rounding.glsl");
    add_beam_of_block(text, scene, passes, proved_block);
    text.file("proof/block.frag");
    return std::move(text).pass(Role::block_proof, "block proof", When::once_a_tile);
}

Pass first_proof(const scene::Scene& scene, const Passes& passes) {
    ShaderText text;
    add_enclosures(text, *scene.surface.field, passes,
                   {FieldFunction::value_interval, FieldFunction::gradient_interval});
    add_proof(text, scene, passes, ProofBounds::by_gradient);
    text.file("proof/begin.frag");
    return std::move(text).pass(Role::first_proof, "first proof", When::once_a_tile);
}

Pass proof(const scene::Scene& scene, const Passes& passes, ProofBounds bounds) {
    const formula::Field& field = *scene.surface.field;
    ShaderText text;
    const bool in_doubles = bounds == ProofBounds::in_doubles;
    if (in_doubles) text.version(400);
    add_enclosures(text, field, passes, proof_samples(field, passes, bounds),
                   in_doubles ? formula::Numbers::doubles : formula::Numbers::floats);
    add_by_place(text, passes);
    add_proof(text, scene, passes, bounds);
    text.file("proof/directional.glsl");
    text.file(takes_hessian(field, passes, bounds) ? "proof/bounds_by_hessian.glsl"
                                                   : "proof/bounds_over_box.glsl");
    text.file("proof/prove.glsl");
    text.file("proof/proof.frag");
    switch (bounds) {
    case ProofBounds::natural:
        break;
    case ProofBounds::by_gradient:
        return std::move(text).pass(Role::sharp_proof, "sharp proof", When::where_proof_is_open);
    case ProofBounds::in_doubles:
        return std::move(text).pass(Role::double_proof, "double proof", When::where_proof_is_open);
    }
    return std::move(text).pass(Role::proof, "proof", When::until_proved);
}

Pass proof_mask(const scene::Scene& scene, const Passes& passes) {
    ShaderText text;
    text.file("math/bits.glsl");
    add_ended_ray(text, scene);
    add_way(text, passes, !passes.beams.empty());
    text.file("proof/mask.frag");
    return std::move(text).pass(Role::proof_mask, "proof mask", When::once_a_tile);
}

Pass proof_unmask() {
    ShaderText text;
    text.file("proof/outcome.glsl");
    text.file("proof/unmask.frag");
    return std::move(text).pass(Role::proof_unmask, "proof unmask", When::until_proved);
}

Pass proof_copy() {
    ShaderText text;
    text.file("proof/outcome.glsl");
    text.file("proof/copy.frag");
    return std::move(text).pass(Role::proof_copy, "proof copy", When::until_proved);
}

} // namespace

std::vector<FieldFunction> block_proof_samples() { return {FieldFunction::directional_interval}; }

std::vector<FieldFunction> proof_samples(const formula::Field& field, const FieldStorage& storage,
                                         ProofBounds bounds) {
    std::vector samples{FieldFunction::value_interval, FieldFunction::directional_interval};
    if (bounds != ProofBounds::natural) samples.push_back(FieldFunction::gradient_interval);
    if (takes_hessian(field, storage, bounds)) samples.push_back(FieldFunction::hessian_interval);
    return samples;
}

std::vector<Pass> proof_passes(const scene::Scene& scene, const Passes& passes) {
    std::vector<Pass> list;
    list.push_back(proof_mask(scene, passes));
    list.push_back(block_proof(scene, passes));
    list.push_back(first_proof(scene, passes));
    list.push_back(proof(scene, passes, ProofBounds::natural));
    list.push_back(proof_copy());
    list.push_back(proof_unmask());
    list.push_back(proof(scene, passes, ProofBounds::by_gradient));
    list.push_back(proof(scene, passes, ProofBounds::in_doubles));
    return list;
}

} // namespace isomotion::synthesis
