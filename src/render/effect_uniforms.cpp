#include "render/effect_uniforms.h"

namespace isomotion::render {

Uniforms effect_uniforms(const scene::Scene& scene, const scene::SceneAt& now) {
    Uniforms uniforms;
    const scene::PlacementAt& place = now.placement;
    const auto add = [&](const char* name, const glm::dvec3& v, double w = 0) {
        uniforms.push_back({name, glm::vec4(glm::dvec4(v, w))});
    };
    const auto add_vector = [&](const char* name, const glm::dvec3& v) {
        uniforms.push_back({name, glm::vec3(v)});
    };
    if (scene.ground) {
        // In double: the ground may be far from the world's origin and near the surface.
        const glm::dvec3 up = glm::transpose(place.rotate) * glm::dvec3(0, 0, 1);
        add("ground_plane", up, (place.translate.z - now.ground.height) / place.scale);
        add("ground_color", now.ground.color);
    }
    if (scene.fog) {
        add("fog", {now.fog.density, now.fog.start, place.scale});
        add("fog_color", now.fog.color);
    }
    if (scene.occlusion) {
        add("occlusion", {now.occlusion.reach / place.scale, now.occlusion.strength, 0});
    }
    if (scene.environment) {
        const glm::dmat3 to_local = glm::transpose(place.rotate);
        add_vector("environment_ahead", to_local * now.environment->ahead);
        add_vector("environment_left", to_local * now.environment->left);
        add_vector("environment_top", to_local * now.environment->top);
        uniforms.push_back({"environment_intensity", float(now.environment->intensity)});
    }
    if (scene.output.gradient) {
        const auto color = [](const std::array<double, 3>& c) {
            return glm::dvec3(c[0], c[1], c[2]);
        };
        add_vector("sky_top", color(scene.output.gradient->top));
        add_vector("sky_bottom", color(scene.output.gradient->bottom));
    }
    if (scene.material.model != scene::Material::Model::lambert) {
        uniforms.push_back({"gloss", glm::vec4(now.gloss)});
    }
    if (const auto& paint = scene.material.paint) {
        uniforms.push_back({"paint_range", glm::vec2(now.paint_range)});
        // Where it is not asked for, it would tell still frames apart.
        if (paint->value->uses("t")) uniforms.push_back({"paint_time", float(now.time)});
    }
    if (scene.material.inside) add("inside_color", now.inside_color);
    return uniforms;
}

} // namespace isomotion::render
