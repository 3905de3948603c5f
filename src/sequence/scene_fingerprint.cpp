#include "sequence/scene_fingerprint.h"

#include "base/fingerprint.h"
#include "scene/source_print.h"
#include "shader/effect.h"

namespace isomotion::sequence {
namespace {

using base::Fingerprint;

void add_numbers(Fingerprint& print, std::initializer_list<double> numbers) {
    print.add_values(std::span(numbers.begin(), numbers.size()));
}

void add(Fingerprint& print, const scene::Isolation& settings) {
    print.add(scene::name(settings.method));
    add_numbers(print, {settings.step, settings.near, settings.far, settings.horizon,
                        double(settings.bisections), double(settings.beam.value_or(false)),
                        double(settings.beam.has_value()), double(settings.certify),
                        settings.safety, double(settings.limit)});
}

void add(Fingerprint& print, const scene::Output& output) {
    add_numbers(print, {double(output.width), double(output.height), output.background[0],
                        output.background[1], output.background[2], double(output.transparent),
                        double(output.samples)});
    if (const auto& sky = output.gradient) {
        print.add_values(std::span<const double>(sky->top));
        print.add_values(std::span<const double>(sky->bottom));
    }
}

// A surface with the settings that all share. `effects`: of the surface, or of all.
Fingerprint print_of(const scene::OneSurface& one, std::span<const shader::Effect> effects) {
    const auto& [scene, surface, index] = one;
    const animation::Animation& animation = surface.animation;
    Fingerprint print;
    print.add("isomotion scene 1").add(scene.title).add(formula::identity(*surface.field));
    print.add(animation::to_string(scene.timeline.fps)).add(std::to_string(animation.seed()));
    for (const animation::Track& track : animation.tracks()) scene::add(print, track);
    for (std::size_t a = 0; a < animation.arrays().size(); ++a)
        scene::add_array(print, animation, a);
    for (const shader::Effect effect : effects) print.add(shader::name(effect));
    print.add(std::to_string(int(surface.bounds.shape)));
    add(print, surface.isolation);
    add_numbers(print, {double(scene.camera.projection), scene.camera.shutter});
    for (const scene::Light& light : scene.lights) {
        add_numbers(print, {double(light.is_point), double(light.shadow), double(light.headlight)});
        if (light.with_camera) print.add("with the camera");
    }
    const scene::Material& material = surface.material;
    if (const auto& paint = material.paint) {
        print.add(paint->value->text);
        add_numbers(print, {double(paint->map)});
        if (paint->shown) add_numbers(print, {paint->shown->least, paint->shown->most});
    }
    if (const auto& color = material.color_by_place) print.add(color->text);
    if (const auto& contours = material.contours) print.add(contours->value->text);
    if (const auto& glass = material.glass) {
        add_numbers(print, {double(glass->depth)});
        if (glass->priority != 0) add_numbers(print, {double(glass->priority)});
    }
    if (scene.environment) {
        print.add(scene.environment->map.filename().string());
        add_numbers(print, {double(scene.environment->background)});
    }
    add(print, scene.output);
    return print;
}

} // namespace

std::string scene_fingerprint(const scene::Scene& scene) {
    Fingerprint print = print_of({scene, 0}, shader::effects(scene));
    for (std::size_t k = 1; k < scene.surfaces.size(); ++k) {
        const scene::OneSurface one(scene, k);
        print.add(one.surface.label).add(print_of(one, shader::effects(one)).text());
    }
    return print.text();
}

} // namespace isomotion::sequence
