#include "render/effect_uniforms.h"

namespace isomotion::render {

EffectUniforms effect_uniforms(const scene::Scene& scene, const scene::SceneAt& now) {
    EffectUniforms uniforms;
    const scene::PlacementAt& place = now.placement;
    const auto add = [&](const char* name, const glm::dvec3& v, double w = 0) {
        uniforms.emplace_back(name, glm::vec4(glm::dvec4(v, w)));
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
    if (scene.material.inside) add("inside_color", now.inside_color);
    return uniforms;
}

} // namespace isomotion::render
