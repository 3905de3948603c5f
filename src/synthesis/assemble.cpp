#include "synthesis/assemble.h"

#include <algorithm>

#include <fmt/format.h>

#include "synthesis/paint_text.h"
#include "synthesis/shader_files.h"

namespace isomotion::synthesis {
namespace {

FieldStorage storage_of(const scene::Scene& scene) {
    std::vector<int> counts;
    for (const auto& array : scene.timeline.animation.arrays()) counts.push_back(array.count);
    return field_storage(*scene.surface.field, scene.surface.parameters, counts);
}

void add_ray(ShaderText& text, const scene::Scene& scene) {
    const bool box = scene.surface.bounds.shape == scene::Bounds::Shape::box;
    text.file("frame.glsl");
    text.file(box ? "march/clip_box.glsl" : "march/clip_sphere.glsl");
    text.file("march/ray.glsl");
    text.file("march/state.glsl");
}

// So long that compiling it shows: some 0.2 s on a software renderer, and growing with its length.
bool is_long(const formula::Program& gradient) { return gradient.instructions.size() > 1000; }

std::string march_text(const scene::Scene& scene, Shaders& shaders) {
    const scene::Method method = scene.isolation.method;
    ShaderText text(shaders.files);
    add_field(text, *scene.surface.field, shaders,
              {shaders.samples_derivative ? FieldFunction::along : FieldFunction::value});
    add_ray(text, scene);
    text.file("march/store_state.glsl");
    text.file(shaders.samples_derivative ? "march/sample_along.glsl" : "march/sample_value.glsl");
    text.file(method == scene::Method::marching ? "march/uniform_step.glsl"
                                                : "march/adaptive_step.glsl");
    text.file(method == scene::Method::amp_taylor ? "march/taylor_test.glsl"
                                                  : "march/sign_test.glsl");
    text.file(shaders.march_takes_gradient ? "march/gradient_at_root.glsl"
                                           : "march/end_at_root.glsl");
    text.file("march/march.frag");
    return text.take();
}

struct ChannelShader {
    Channel channel;
    const char* file;
    const char* function;
    const char* location;
};

constexpr ChannelShader channel_shaders[] = {
    {Channel::depth, "channels/depth.glsl", "write_depth", "DEPTH_LOCATION"},
    {Channel::normal, "channels/normal.glsl", "write_normal", "NORMAL_LOCATION"},
    {Channel::position, "channels/position.glsl", "write_position", "POSITION_LOCATION"},
};

std::string shade_text(const scene::Scene& scene, const std::vector<Channel>& channels,
                       Shaders& shaders) {
    ShaderText text(shaders.files);
    text.define("LIGHTS", int(scene.lights.size()));
    const formula::Field& field = *scene.surface.field;
    const auto& paint = scene.material.paint;
    std::vector<GeneratedFunction> painting;
    if (paint) painting = paint_functions(*paint->value, field);
    if (!shaders.march_takes_gradient) {
        add_field(text, field, shaders, {FieldFunction::gradient}, painting);
    } else if (paint) {
        add_field(text, field, shaders, {}, painting);
    } else {
        text.file("math/bits.glsl");
    }
    add_ray(text, scene);
    text.file("shade/shading.glsl");
    if (paint) {
        add_paint(text, *paint);
    } else {
        text.file(scene.material.inside ? "shade/two_sided.glsl" : "shade/one_sided.glsl");
    }
    text.file("shade/lambert.glsl");
    text.file(shaders.march_takes_gradient ? "shade/gradient_from_state.glsl"
                                           : "shade/gradient_from_field.glsl");
    std::string calls;
    for (const ChannelShader& shader : channel_shaders) {
        if (std::find(channels.begin(), channels.end(), shader.channel) == channels.end()) continue;
        text.define(shader.location, 2 + int(shaders.attachments.size()));
        text.file(shader.file);
        calls += fmt::format("    {}(ray, hit, on_surface);\n", shader.function);
        shaders.attachments.push_back(shader.channel);
    }
    text.generated("generated: the channels asked for",
                   "void write_channels(Ray ray, Hit hit, bool on_surface) {\n" + calls + "}\n");
    text.file("shade/shade.frag");
    return text.take();
}

} // namespace

Shaders assemble(const scene::Scene& scene, const std::vector<Channel>& channels) {
    Shaders shaders;
    static_cast<FieldStorage&>(shaders) = storage_of(scene);
    shaders.vertex = "#version 330 core\n" + read_shader("fullscreen.vert");
    shaders.files.push_back("fullscreen.vert");
    shaders.march_takes_gradient = is_long(scene.surface.field->gradient);
    shaders.samples_derivative =
        shaders.march_takes_gradient || scene.isolation.method != scene::Method::marching;
    shaders.march = march_text(scene, shaders);
    ShaderText active(shaders.files);
    active.file("march/state.glsl");
    active.file("march/active.frag");
    shaders.active = active.take();
    shaders.shade = shade_text(scene, channels, shaders);
    return shaders;
}

} // namespace isomotion::synthesis
