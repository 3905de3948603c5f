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

// In doubles, where rounding no longer hides it, and where there are such bounds.
bool takes_bend(const formula::Field& field, ProofBounds bounds) {
    return bounds == ProofBounds::in_doubles && formula::bend_program(field);
}

// What its proof begins with: the part it is of, the boxes around it, what F can be in one.
void add_proof(ShaderText& text, const scene::Scene& scene, const Shaders& shaders,
               ProofBounds bounds) {
    const bool box = scene.surface.bounds.shape == scene::Bounds::Shape::box;
    add_ended_ray(text, scene);
    add_way(text, shaders, !shaders.beams.empty());
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

} // namespace

std::vector<FieldFunction> block_proof_samples() { return {FieldFunction::along_interval}; }

std::string block_proof_text(const scene::Scene& scene, Shaders& shaders) {
    ShaderText text(shaders.files);
    text.define("BLOCK", proved_block);
    text.define("RAYS", proved_block * proved_block);
    text.define("SQUARES_APART", beam_square);
    text.file("march/beam_place.glsl");
    add_field(text, *scene.surface.field, shaders, block_proof_samples());
    text.file("frame.glsl");
    text.file("march/verdict.glsl");
    text.file("proof/ending.glsl");
    text.file("proof/rounding.glsl");
    add_beam_of_block(text, scene, shaders, proved_block);
    text.file("proof/block.frag");
    return text.take();
}

std::string begin_proof_text(const scene::Scene& scene, Shaders& shaders) {
    ShaderText text(shaders.files);
    add_field(text, *scene.surface.field, shaders,
              {FieldFunction::value_interval, FieldFunction::gradient_interval});
    add_proof(text, scene, shaders, ProofBounds::by_gradient);
    text.file("proof/begin.frag");
    return text.take();
}

std::vector<FieldFunction> proof_samples(const formula::Field& field, ProofBounds bounds) {
    std::vector samples{FieldFunction::value_interval, FieldFunction::along_interval};
    if (bounds != ProofBounds::natural) samples.push_back(FieldFunction::gradient_interval);
    if (takes_bend(field, bounds)) samples.push_back(FieldFunction::bend_interval);
    return samples;
}

std::string proof_text(const scene::Scene& scene, Shaders& shaders, ProofBounds bounds) {
    const formula::Field& field = *scene.surface.field;
    ShaderText text(shaders.files);
    if (bounds == ProofBounds::in_doubles) {
        text.version(400);
        add_field_on_doubles(text, field, shaders, proof_samples(field, bounds));
    } else {
        add_field(text, field, shaders, proof_samples(field, bounds));
    }
    add_proof(text, scene, shaders, bounds);
    text.file("proof/slope.glsl");
    text.file(takes_bend(field, bounds) ? "proof/bounds_by_bend.glsl"
                                        : "proof/bounds_over_box.glsl");
    text.file("proof/prove.glsl");
    text.file("proof/proof.frag");
    return text.take();
}

std::string to_prove_text(const scene::Scene& scene, Shaders& shaders) {
    ShaderText text(shaders.files);
    text.file("math/bits.glsl");
    add_ended_ray(text, scene);
    add_way(text, shaders, !shaders.beams.empty());
    text.file("proof/open.frag");
    return text.take();
}

std::string close_proofs_text(std::vector<std::string>& files) {
    ShaderText text(files);
    text.file("proof/outcome.glsl");
    text.file("proof/close.frag");
    return text.take();
}

std::string keep_text(std::vector<std::string>& files) {
    ShaderText text(files);
    text.file("proof/outcome.glsl");
    text.file("proof/keep.frag");
    return text.take();
}

} // namespace isomotion::synthesis
