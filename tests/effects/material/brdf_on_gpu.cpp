#include "brdf_on_gpu.h"

#include <cstring>

#include "gpu/draw.h"
#include "gpu/target.h"
#include "shader/shader_files.h"
#include "shader/shader_text.h"
#include "unit/gpu/every_backend.h"

namespace isomotion::effects {
namespace {

constexpr int width = 256;

std::string shader(const std::string& model, const std::string& call) {
    shader::ShaderText text;
    for (const std::string& kernel : shader::kernel_files({"pow"})) text.file(kernel);
    if (model == "ggx") text.define(shader::Feature::ggx);
    if (model == "blinn-phong") text.define(shader::Feature::blinn_phong);
    text.file("effects/material.glsl");
    text.generated("a place a pixel", R"(
uniform sampler2D normals, viewers, lights;
uniform vec3 albedo;
out vec4 result;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec3 normal = texelFetch(normals, at, 0).xyz;
    vec3 to_viewer = texelFetch(viewers, at, 0).xyz;
    vec3 to_light = texelFetch(lights, at, 0).xyz;
    result = vec4()" + call + R"(, 1.0);
}
)");
    return text.text();
}

gpu::Texture texture_of(const std::vector<Geometry>& places, int height,
                        glm::vec3 Geometry::*part) {
    std::vector<float> texels(std::size_t(width * height) * 4);
    for (std::size_t k = 0; k < places.size(); ++k) {
        std::memcpy(&texels[4 * k], &(places[k].*part), sizeof(glm::vec3));
    }
    return {gpu::Format::rgba32f, width, height, texels};
}

} // namespace

BrdfOnGpu::BrdfOnGpu(const std::string& model, const std::string& call)
    : program_(gpu::fullscreen_vertex, shader(model, call), model) {}

std::vector<glm::vec3> BrdfOnGpu::operator()(const Gloss& gloss,
                                             const std::vector<Geometry>& places) const {
    const int height = (int(places.size()) + width - 1) / width;
    const gpu::Texture normals = texture_of(places, height, &Geometry::normal);
    const gpu::Texture viewers = texture_of(places, height, &Geometry::to_viewer);
    const gpu::Texture lights = texture_of(places, height, &Geometry::to_light);
    normals.bind(0);
    viewers.bind(1);
    lights.bind(2);
    program_.bind_sampler("normals", 0);
    program_.bind_sampler("viewers", 1);
    program_.bind_sampler("lights", 2);
    program_.set("albedo", gloss.albedo);
    program_.set("gloss", gloss.numbers);
    const gpu::Target target(width, height);
    target.bind();
    program_.use();
    gpu::Fullscreen().draw();
    const std::vector<float> pixels = target.read(0, 0, 0, width, height);
    std::vector<glm::vec3> results(places.size());
    for (std::size_t k = 0; k < results.size(); ++k) {
        std::memcpy(&results[k], &pixels[4 * k], sizeof(glm::vec3));
    }
    return results;
}

} // namespace isomotion::effects
