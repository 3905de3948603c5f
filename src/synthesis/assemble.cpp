#include "synthesis/assemble.h"

#include <algorithm>

#include <fmt/format.h>

#include "synthesis/effect_text.h"
#include "synthesis/paint_text.h"
#include "synthesis/shader_files.h"

namespace isomotion::synthesis {
namespace {

FieldStorage storage_of(const scene::Scene& scene) {
    std::vector<int> counts;
    for (const auto& array : scene.timeline.animation.arrays()) counts.push_back(array.count);
    return field_storage(*scene.surface.field, scene.surface.parameters, counts);
}

enum class Origin { eye, mirror };

void add_ray(ShaderText& text, const scene::Scene& scene, Origin origin = Origin::eye) {
    const bool box = scene.surface.bounds.shape == scene::Bounds::Shape::box;
    text.file_of_stage("frame.glsl", "stage/frame.glsl");
    text.file("march/verdict.glsl");
    text.file(box ? "march/clip_box.glsl" : "march/clip_sphere.glsl");
    if (origin == Origin::eye) {
        text.file("march/ray.glsl");
    } else {
        text.generated("the eye's ray by another name", "#define pixel_ray eye_ray\n");
        text.file("march/ray.glsl");
        text.generated("and the mirrored one by its", "#undef pixel_ray\n");
        text.file("effects/surface_point.glsl");
        text.file("effects/load_surface.glsl");
        text.file("effects/mirror_ray.glsl");
    }
    text.file("march/state.glsl");
}

void add_isolation(ShaderText& text, const scene::Scene& scene, const Shaders& shaders) {
    const scene::Method method = scene.isolation.method;
    text.file_of_stage("march/store_state.glsl", "stage/store_state.glsl");
    text.file("march/finish.glsl");
    text.file(shaders.samples_derivative ? "march/sample_along.glsl" : "march/sample_value.glsl");
    if (method == scene::Method::hermite) return;
    text.file(method == scene::Method::marching ? "march/uniform_step.glsl"
                                                : "march/adaptive_step.glsl");
    text.file(method == scene::Method::amp_taylor ? "march/taylor_test.glsl"
                                                  : "march/sign_test.glsl");
}

const char* method_file(const scene::Scene& scene) {
    return scene.isolation.method == scene::Method::hermite ? "march/hermite.glsl"
                                                            : "march/amp.glsl";
}

// What else a ray keeps, for each shader that reads its state.
void define_state(ShaderText& text, const Shaders& shaders) {
    if (shaders.state_textures == 3) text.define("THREE_SAMPLES", 1);
}

// So long that compiling it shows: some 0.2 s on a software renderer, and growing with its length.
bool is_long(const formula::Program& gradient) { return gradient.instructions.size() > 1000; }

std::string march_text(const scene::Scene& scene, Shaders& shaders, Origin origin) {
    ShaderText text(shaders.files, shaders.stage);
    define_state(text, shaders);
    add_field(text, *scene.surface.field, shaders,
              {shaders.samples_derivative ? FieldFunction::along : FieldFunction::value});
    add_ray(text, scene, origin);
    add_isolation(text, scene, shaders);
    text.file(shaders.march_takes_gradient ? "march/gradient_at_root.glsl"
                                           : "march/end_at_root.glsl");
    text.file(method_file(scene));
    text.file("march/march.glsl");
    text.file_of_stage("stage/march.frag", "stage/march.comp");
    return text.take();
}

std::string surface_text(const scene::Scene& scene, Shaders& shaders, Origin origin) {
    ShaderText text(shaders.files);
    std::vector<FieldFunction> functions{FieldFunction::value};
    if (!shaders.march_takes_gradient) functions.push_back(FieldFunction::gradient);
    add_field(text, *scene.surface.field, shaders, functions);
    add_ray(text, scene, origin);
    if (origin == Origin::eye) {
        text.file("effects/eye_begin.glsl");
        text.file("effects/surface_point.glsl");
    }
    text.file(shaders.march_takes_gradient ? "shade/gradient_from_state.glsl"
                                           : "shade/gradient_from_field.glsl");
    text.file("effects/end_of_ray.glsl");
    text.file("effects/store_surface.glsl");
    if (scene.ground) text.file("effects/ground.glsl");
    text.generated("generated: the first of what there is",
                   fmt::format("void main() {{\n    Ray ray = pixel_ray();\n"
                               "    SurfacePoint p = end_of_ray(ray, load_state());\n{}"
                               "    store_surface(p);\n}}\n",
                               scene.ground ? "    p = before_ground(ray, p);\n" : ""));
    return text.take();
}

std::string shadow_text(const scene::Scene& scene, Shaders& shaders) {
    ShaderText text(shaders.files, shaders.stage);
    define_state(text, shaders);
    text.define("LIGHTS", int(scene.lights.size()));
    text.define("SHADOWS", shadow_mask(scene));
    add_field(text, *scene.surface.field, shaders,
              {shaders.samples_derivative ? FieldFunction::along : FieldFunction::value});
    add_ray(text, scene);
    add_isolation(text, scene, shaders);
    text.file("shade/shading.glsl");
    add_lights(text, scene);
    text.file("effects/surface_point.glsl");
    text.file("effects/load_surface.glsl");
    if (scene.isolation.method == scene::Method::hermite) {
        text.file("march/end_at_root.glsl");
        text.file("march/hermite.glsl");
        text.file("march/any_hit_hermite.glsl");
    } else {
        text.file("march/any_hit_amp.glsl");
    }
    text.file("effects/shadow.glsl");
    text.file_of_stage("stage/march.frag", "stage/march.comp");
    return text.take();
}

std::string motion_text(const scene::Scene& scene, Shaders& shaders) {
    ShaderText text(shaders.files);
    add_field(text, *scene.surface.field, shaders, {FieldFunction::value, FieldFunction::gradient});
    add_ray(text, scene);
    text.file("effects/motion.frag");
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
    const bool from_surface = keeps_surfaces(scene);
    const formula::Field& field = *scene.surface.field;
    const auto& paint = scene.material.paint;
    std::vector<GeneratedFunction> painting;
    if (paint) painting = paint_functions(*paint->value, field);
    std::vector<FieldFunction> functions;
    // Paint may ask for the gradient too.
    if (!shaders.march_takes_gradient && (!from_surface || paint)) {
        functions.push_back(FieldFunction::gradient);
    }
    if (from_surface && scene.occlusion) functions.push_back(FieldFunction::value);
    if (!functions.empty() || paint) {
        add_field(text, field, shaders, functions, painting);
    } else {
        text.file("math/bits.glsl");
        text.file("math/bits.glsl");
    }
    add_ray(text, scene);
    text.file("shade/shading.glsl");
    if (paint) {
        add_paint(text, *paint);
    } else {
        text.file(scene.material.inside ? "shade/two_sided.glsl" : "shade/one_sided.glsl");
    }
    if (from_surface) {
        text.file("effects/eye_begin.glsl");
        text.file("effects/surface_point.glsl");
        text.file("effects/load_surface.glsl");
        add_shading(text, scene);
    } else {
        text.file("shade/lambert.glsl");
    }
    if (!from_surface || paint) {
        text.file(shaders.march_takes_gradient ? "shade/gradient_from_state.glsl"
                                               : "shade/gradient_from_field.glsl");
    }
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
    text.file(from_surface ? "effects/shade.frag" : "shade/shade.frag");
    return text.take();
}

} // namespace

Shaders assemble(const scene::Scene& scene, const std::vector<Channel>& channels, Stage stage) {
    Shaders shaders;
    shaders.stage = stage;
    static_cast<FieldStorage&>(shaders) = storage_of(scene);
    shaders.vertex = "#version 330 core\n" + read_shader("fullscreen.vert");
    shaders.files.push_back("fullscreen.vert");
    shaders.march_takes_gradient = is_long(scene.surface.field->gradient);
    shaders.samples_derivative =
        shaders.march_takes_gradient || scene.isolation.method != scene::Method::marching;
    shaders.state_textures = scene.isolation.method == scene::Method::hermite ? 3 : 2;
    shaders.march = march_text(scene, shaders, Origin::eye);
    ShaderText active(shaders.files);
    active.file("march/state.glsl");
    active.file("march/active.frag");
    shaders.active = active.take();
    if (keeps_surfaces(scene)) shaders.surface = surface_text(scene, shaders, Origin::eye);
    if (shadow_mask(scene) != 0) shaders.shadow = shadow_text(scene, shaders);
    if (scene.material.reflection == scene::Material::Reflection::self) {
        shaders.mirror = march_text(scene, shaders, Origin::mirror);
        shaders.mirror_surface = surface_text(scene, shaders, Origin::mirror);
    }
    if (std::find(channels.begin(), channels.end(), Channel::velocity) != channels.end()) {
        shaders.motion = motion_text(scene, shaders);
    }
    shaders.shade = shade_text(scene, channels, shaders);
    return shaders;
}

} // namespace isomotion::synthesis
