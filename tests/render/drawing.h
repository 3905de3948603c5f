// Draws scenes written as text.
#pragma once

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

#include "render/renderer.h"
#include "scene/reading/load.h"
#include "unit/gpu/every_backend.h"

namespace isomotion::render {

// `text` as a scene file, loaded.
inline scene::Scene scene_of(const std::string& text,
                             const std::vector<scene::Override>& overrides = {}) {
    const auto file = std::filesystem::temp_directory_path() /
                      ("isomotion-scene-" + std::to_string(getpid()) + ".toml");
    std::ofstream(file) << text;
    scene::Scene scene = scene::load(file.string(), overrides, scene::Reach::anywhere);
    std::filesystem::remove(file);
    return scene;
}

inline const std::vector<shader::Channel> every_channel{
    shader::Channel::depth, shader::Channel::normal, shader::Channel::position,
    shader::Channel::verdict, shader::Channel::evaluations};

inline Picture draw(gpu::Context& context, const scene::Scene& scene, int frame = 1,
                    std::optional<MarchPlan> plan = {}) {
    Renderer renderer(context, scene,
                      {scene.output.width, scene.output.height, every_channel, plan});
    return renderer.draw(scene::at_frame(scene, frame));
}

inline std::int64_t count(const Picture& picture, Verdict verdict) {
    return picture.verdicts[std::size_t(verdict)];
}

// Bit for bit, NaN and signs of zero included.
inline bool same_bits(const image::Frame& a, const image::Frame& b) {
    if (a.channels.size() != b.channels.size()) return false;
    for (std::size_t c = 0; c < a.channels.size(); ++c) {
        const auto &x = a.channels[c].samples, &y = b.channels[c].samples;
        if (x.size() != y.size() ||
            std::memcmp(x.data(), y.data(), x.size() * sizeof(float)) != 0) {
            return false;
        }
    }
    return true;
}

// A unit sphere seen from distance 5 along -x, so that picture columns run along -y.
inline const std::string sphere_scene = R"(
[surface]
formula = "x^2 + y^2 + z^2 - 1"
bounds = { sphere = 1.5 }
[camera]
position = [5, 0, 0]
target = [0, 0, 0]
fov = 40
[output]
size = [160, 120]
)";

class Drawing : public gpu::EveryBackend {};

} // namespace isomotion::render
