#include "synthesis/proof_text.h"

#include "synthesis/beam_text.h"
#include "synthesis/shader_text.h"

namespace isomotion::synthesis {
namespace {

// Beams that leave out elements which matter little prove nothing about the whole sum.
bool proves_by_beams(const Shaders& shaders) {
    return !shaders.beams.empty() && !has_lists(shaders);
}

} // namespace

std::vector<FieldFunction> proof_samples(ProofBounds bounds) {
    std::vector samples{FieldFunction::value_interval, FieldFunction::along_interval};
    if (bounds == ProofBounds::by_gradient) samples.push_back(FieldFunction::gradient_interval);
    return samples;
}

std::string proof_text(const scene::Scene& scene, Shaders& shaders, ProofBounds bounds) {
    const bool box = scene.surface.bounds.shape == scene::Bounds::Shape::box;
    ShaderText text(shaders.files);
    add_field(text, *scene.surface.field, shaders, proof_samples(bounds));
    text.file("frame.glsl");
    text.file("march/verdict.glsl");
    text.file(box ? "march/clip_box.glsl" : "march/clip_sphere.glsl");
    text.file("march/ray.glsl");
    add_entrance(text, shaders, proves_by_beams(shaders));
    text.file("proof/ending.glsl");
    text.file("proof/outcome.glsl");
    text.file("proof/tube.glsl");
    text.file(box ? "proof/inside_box.glsl" : "proof/inside_sphere.glsl");
    text.file(bounds == ProofBounds::natural ? "proof/value_over_box.glsl"
                                             : "proof/value_by_gradient.glsl");
    text.file("proof/prove.glsl");
    text.file("proof/proof.frag");
    return text.take();
}

std::string to_prove_text(const scene::Scene& scene, Shaders& shaders) {
    const bool box = scene.surface.bounds.shape == scene::Bounds::Shape::box;
    ShaderText text(shaders.files);
    text.file("math/bits.glsl");
    text.file("frame.glsl");
    text.file("march/verdict.glsl");
    text.file(box ? "march/clip_box.glsl" : "march/clip_sphere.glsl");
    text.file("march/ray.glsl");
    add_way(text, shaders, proves_by_beams(shaders));
    text.file("proof/ending.glsl");
    text.file("proof/open.frag");
    return text.take();
}

std::string waiting_text(std::vector<std::string>& files) {
    ShaderText text(files);
    text.file("proof/outcome.glsl");
    text.file("proof/waiting.frag");
    return text.take();
}

std::string keep_text(std::vector<std::string>& files) {
    ShaderText text(files);
    text.file("proof/outcome.glsl");
    text.file("proof/keep.frag");
    return text.take();
}

} // namespace isomotion::synthesis
