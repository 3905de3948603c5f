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
    text.file("section/cap.glsl");
}

void add_sections_over_boxes(ShaderText& text, const scene::Scene& scene) {
    if (scene.sections.empty()) return;
    add_sections(text, scene);
    text.file("section/over_box.glsl");
}

void add_crossings(ShaderText& text, const scene::OneSurface& one) {
    if (one.scene.sections.empty()) return;
    const bool bounds =
        scene::traits(one.surface.isolation.method).samples == scene::Samples::value_and_bounds;
    text.generated("generated: F at a place",
                   bounds ? "float field_at(vec3 p, vec3 direction) {\n    return field(p);\n}\n"
                          : "float field_at(vec3 p, vec3 direction) {\n"
                            "    return sample_field(p, direction).x;\n}\n");
    text.define(Feature::parts, parts_of_a_ray(one.scene));
    text.file("section/cross.glsl");
}

void begin_turn_of_part(ShaderText& text) {
    text.generated("the method's turn by another name", "#define turn turn_of_method\n");
}

void end_turn_of_part(ShaderText& text) {
    text.generated("and that of a part by its", "#undef turn\n");
    text.file("section/first_sample.glsl");
}

void add_march_through_parts(ShaderText& text, const scene::OneSurface& one,
                             const std::string& file, bool samples_tell) {
    if (one.scene.sections.empty()) {
        text.file(file);
        return;
    }
    text.generated("the march of one part by other names",
                   samples_tell ? "#define march march_part\n"
                                : "#define begin begin_part\n#define march march_part\n");
    text.file(file);
    text.generated("and that of all by these", "#undef begin\n#undef march\n");
    if (samples_tell) {
        text.define(Feature::parts, parts_of_a_ray(one.scene));
        text.file("section/march_by_samples.glsl");
    } else {
        add_crossings(text, one);
        text.file("section/march.glsl");
    }
}

void add_gradient_of_rest(ShaderText& text, const scene::Scene& scene, const std::string& file) {
    if (scene.sections.empty()) {
        text.file(file);
        return;
    }
    text.generated("the gradient of F by another name",
                   "#define surface_gradient matter_gradient\n");
    text.file(file);
    text.generated("and that of what is left by its", "#undef surface_gradient\n");
    text.file("section/gradient.glsl");
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
