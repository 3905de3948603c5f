#include "shader/section_text.h"

#include <algorithm>

namespace isomotion::shader {
namespace {

int balls(const scene::Scene& scene) {
    int mask = 0;
    for (std::size_t k = 0; k < scene.sections.size(); ++k)
        mask |= int(scene.sections[k].is_ball) << k;
    return mask;
}

} // namespace

int parts_of_a_ray(const scene::Scene& scene) {
    return 1 + int(std::ranges::count_if(scene.sections, &scene::Cut::is_ball));
}

int samples_at_sections(const scene::Scene& scene) {
    return scene.sections.empty() ? 0 : 2 * parts_of_a_ray(scene);
}

void add_sections(ShaderText& text, const scene::Scene& scene) {
    if (scene.sections.empty()) return;
    text.define(Feature::sections, int(scene.sections.size()));
    text.define(Feature::section_balls, balls(scene));
    text.file("section/sections.glsl");
}

void add_parts(ShaderText& text, const scene::Scene& scene) {
    if (scene.sections.empty()) return;
    text.file("section/parts.glsl");
}

void add_crossings(ShaderText& text, const scene::OneSurface& one) {
    if (one.scene.sections.empty()) return;
    text.define(Feature::parts, parts_of_a_ray(one.scene));
    text.file("section/cross.glsl");
}

void add_march_of_parts(ShaderText& text, const scene::OneSurface& one, bool samples_tell) {
    const bool is_cut = !one.scene.sections.empty();
    if (is_cut && samples_tell) {
        text.define(Feature::caps_by_samples);
        text.define(Feature::parts, parts_of_a_ray(one.scene));
    }
    text.file("march/march.glsl");
    if (is_cut && !samples_tell) add_crossings(text, one);
    if (is_cut) text.file("section/march.glsl");
}

bool has_cap_color(const scene::OneSurface& one) {
    const scene::Material& material = one.surface.material;
    if (one.scene.sections.empty()) return false;
    return material.cap || (material.inside && !material.paint);
}

Uniform sections_uniform(const scene::OneSurfaceAt& now) {
    std::vector<scene::SectionAt> local;
    for (const scene::SectionAt& section : now.scene.sections)
        local.push_back(in_formula_coordinates(section, now.surface.placement));
    return {"sections", scene::packed(local)};
}

} // namespace isomotion::shader
