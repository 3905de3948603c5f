#include "synthesis/proof_text.h"

#include "formula/enclosure.h"
#include "synthesis/beam_text.h"
#include "synthesis/shader_text.h"

namespace isomotion::synthesis {

namespace {

// In doubles, where rounding no longer hides it, and where there are such bounds.
bool takes_bend(const formula::Field& field, ProofBounds bounds) {
    return bounds == ProofBounds::in_doubles && formula::bend_program(field);
}

} // namespace

std::vector<FieldFunction> proof_samples(const formula::Field& field, ProofBounds bounds) {
    std::vector samples{FieldFunction::value_interval, FieldFunction::along_interval};
    if (bounds != ProofBounds::natural) samples.push_back(FieldFunction::gradient_interval);
    if (takes_bend(field, bounds)) samples.push_back(FieldFunction::bend_interval);
    return samples;
}

std::string proof_text(const scene::Scene& scene, Shaders& shaders, ProofBounds bounds) {
    const bool box = scene.surface.bounds.shape == scene::Bounds::Shape::box;
    // Beams that leave out elements which matter little prove nothing about the whole sum.
    const bool beam = !shaders.beams.empty() && !has_lists(shaders);
    const formula::Field& field = *scene.surface.field;
    const bool doubles = bounds == ProofBounds::in_doubles;
    ShaderText text(shaders.files);
    if (doubles) {
        text.version(400);
        add_field_on_doubles(text, field, shaders, proof_samples(field, bounds));
    } else {
        add_field(text, field, shaders, proof_samples(field, bounds));
    }
    text.file("frame.glsl");
    text.file("march/verdict.glsl");
    text.file(box ? "march/clip_box.glsl" : "march/clip_sphere.glsl");
    text.file("march/ray.glsl");
    text.file("march/state.glsl");
    add_entrance(text, shaders, beam);
    text.file("proof/outcome.glsl");
    text.file(doubles ? "proof/in_doubles.glsl" : "proof/in_floats.glsl");
    text.file("proof/tube.glsl");
    text.file(box ? "proof/inside_box.glsl" : "proof/inside_sphere.glsl");
    text.file(bounds == ProofBounds::natural ? "proof/value_over_box.glsl"
                                             : "proof/value_by_gradient.glsl");
    text.file(takes_bend(field, bounds) ? "proof/bounds_by_bend.glsl"
                                        : "proof/bounds_over_box.glsl");
    text.file("proof/prove.glsl");
    text.file("proof/proof.frag");
    return text.take();
}

std::string unfinished_proofs_text(std::vector<std::string>& files) {
    ShaderText text(files);
    text.file("proof/unfinished.frag");
    return text.take();
}

} // namespace isomotion::synthesis
