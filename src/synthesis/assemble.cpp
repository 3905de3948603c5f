#include "synthesis/assemble.h"

#include <algorithm>

#include <fmt/format.h>

#include "synthesis/shader_files.h"

namespace isomotion::synthesis {
namespace {

// One shader, put together from files and generated parts.
class Text {
public:
    explicit Text(std::vector<std::string>& files)
        : files_(files) {}

    void file(const std::string& name) {
        text_ += fmt::format("\n// shaders/{}\n{}", name, read_shader(name));
        if (std::find(files_.begin(), files_.end(), name) == files_.end()) files_.push_back(name);
    }
    // #version must be the very first line.
    void prelude() { text_ = read_shader("prelude.glsl"); }
    void define(std::string_view name, int value) {
        text_ += fmt::format("#define {} {}\n", name, value);
    }
    void generated(std::string_view what, const std::string& text) {
        text_ += fmt::format("\n// {}\n{}", what, text);
    }
    std::string take() { return std::move(text_); }

private:
    std::vector<std::string>& files_;
    std::string text_;
};

std::vector<ArrayStorage> array_storage(const scene::Scene& scene) {
    std::vector<ArrayStorage> storage;
    const auto& packing = scene.surface.field->packing;
    for (std::size_t a = 0; a < packing.size(); ++a) {
        ArrayStorage array;
        array.name = fmt::format("array{}", a);
        array.texels = std::max<int>(1, (int(packing[a].size()) + 3) / 4);
        array.capacity = std::max(1, scene.timeline.animation.arrays()[a].count);
        const std::size_t bytes = std::size_t(array.capacity) * std::size_t(array.texels) * 16;
        array.kind = bytes <= ArrayStorage::uniform_block_bytes
                         ? ArrayStorage::Kind::uniform_block
                         : ArrayStorage::Kind::texture_buffer;
        storage.push_back(array);
    }
    return storage;
}

std::string parameter_declarations(const Shaders& shaders) {
    std::string text = "layout(std140) uniform Parameters {\n";
    text += fmt::format("    vec4 parameters[{}];\n", shaders.parameter_vectors);
    if (shaders.count_vectors > 0) {
        text += fmt::format("    ivec4 array_counts[{}];\n", shaders.count_vectors);
    }
    text += "};\n";
    for (std::size_t a = 0; a < shaders.arrays.size(); ++a) {
        const ArrayStorage& array = shaders.arrays[a];
        const bool block = array.kind == ArrayStorage::Kind::uniform_block;
        text +=
            fmt::format("#define {}_count array_counts[{}].{}\n", array.name, a / 4, "xyzw"[a % 4]);
        text += block ? fmt::format("layout(std140) uniform {0}_block {{ vec4 {0}[{1}]; }};\n",
                                    array.name, array.capacity * array.texels)
                      : fmt::format("uniform samplerBuffer {};\n", array.name);
        const std::string at =
            array.texels == 1 ? "element" : fmt::format("element * {} + texel", array.texels);
        text +=
            fmt::format("vec4 {0}_texel(int element, int texel) {{ return {1}; }}\n", array.name,
                        block ? fmt::format("{}[{}]", array.name, at)
                              : fmt::format("texelFetch({}, {})", array.name, at));
    }
    return text;
}

// The field and what its text stands on.
void add_field(Text& text, const scene::Scene& scene, const Shaders& shaders,
               const formula::Program& program, const std::string& function) {
    for (const auto& kernel : kernel_files(formula::kernels_used(program))) text.file(kernel);
    text.generated("generated: parameters of the surface", parameter_declarations(shaders));
    // The user's text as a comment, where a line end or backslash could not end the comment.
    std::string formula = scene.surface.field->text;
    std::replace_if(
        formula.begin(), formula.end(), [](char c) { return c < ' ' || c == '\\' || c > '~'; },
        ' ');
    text.generated("generated from: " + formula, function);
}

void add_ray(Text& text, const scene::Scene& scene) {
    const bool box = scene.surface.bounds.shape == scene::Bounds::Shape::box;
    text.file("frame.glsl");
    text.file(box ? "march/clip_box.glsl" : "march/clip_sphere.glsl");
    text.file("march/ray.glsl");
    text.file("march/state.glsl");
}

std::string march_text(const scene::Scene& scene, Shaders& shaders) {
    const formula::Field& field = *scene.surface.field;
    const scene::Method method = scene.isolation.method;
    const bool derivative = samples_derivative(method);
    Text text(shaders.files);
    text.prelude();
    add_field(text, scene, shaders, derivative ? field.along : field.value,
              derivative ? formula::glsl_along(field) : formula::glsl_value(field));
    add_ray(text, scene);
    text.file("march/store_state.glsl");
    text.file(derivative ? "march/sample_along.glsl" : "march/sample_value.glsl");
    text.file(method == scene::Method::marching ? "march/uniform_step.glsl"
                                                : "march/adaptive_step.glsl");
    text.file(method == scene::Method::amp_taylor ? "march/taylor_test.glsl"
                                                  : "march/sign_test.glsl");
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
    const formula::Field& field = *scene.surface.field;
    Text text(shaders.files);
    text.prelude();
    text.define("LIGHTS", int(scene.lights.size()));
    add_field(text, scene, shaders, field.gradient, formula::glsl_gradient(field));
    add_ray(text, scene);
    text.file("shade/shading.glsl");
    text.file("shade/lambert.glsl");
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

bool samples_derivative(scene::Method method) { return method != scene::Method::marching; }

Shaders assemble(const scene::Scene& scene, const std::vector<Channel>& channels) {
    Shaders shaders;
    shaders.parameter_vectors = std::max(1, (scene.surface.parameters + 3) / 4);
    shaders.arrays = array_storage(scene);
    shaders.count_vectors = (int(shaders.arrays.size()) + 3) / 4;
    shaders.vertex = "#version 330 core\n" + read_shader("fullscreen.vert");
    shaders.files.push_back("fullscreen.vert");
    shaders.march = march_text(scene, shaders);
    Text active(shaders.files);
    active.prelude();
    active.file("march/state.glsl");
    active.file("march/active.frag");
    shaders.active = active.take();
    shaders.shade = shade_text(scene, channels, shaders);
    return shaders;
}

} // namespace isomotion::synthesis
