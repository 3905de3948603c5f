#include "page/environment_map.h"

#include <algorithm>
#include <span>

#include <glm/gtc/packing.hpp>

#include "image/environment.h"
#include "image/environment_levels.h"
#include "shader/effect_text.h"

namespace isomotion::page {

namespace {

// Linear R, G and B as halves.
std::vector<std::byte> halves_of(const image::EnvironmentMap& map) {
    constexpr float largest_half = 65504;
    std::vector<std::byte> halves;
    for (std::size_t k = 0; k < map.texels.size(); ++k) {
        if (k % 4 == 3) continue;
        const glm::uint16 half = glm::packHalf1x16(std::min(map.texels[k], largest_half));
        halves.push_back(std::byte(half & 0xff));
        halves.push_back(std::byte(half >> 8));
    }
    return halves;
}

EnvironmentMap page_map_of(const image::EnvironmentMap& map) {
    return {map.width, map.height, halves_of(map)};
}

} // namespace

std::optional<Environment> environment(const scene::Scene& scene,
                                       const std::function<void(const std::string&)>& warn) {
    const auto& from = scene.environment;
    if (!from) return std::nullopt;
    image::EnvironmentReduction reduction(widest_map);
    image::EnvironmentSink sink;
    sink.begin = [&](int width, int height) { reduction.begin(width, height); };
    sink.rows = [&](int first, std::span<const float> texels) { reduction.rows(first, texels); };
    const int mended = image::read_environment(from->map, sink, from->within, from->stated_at);
    if (mended > 0 && warn) warn(image::mending(from->map, mended));
    const image::EnvironmentMap map = reduction.map();
    Environment all{page_map_of(map), std::nullopt};
    if (shader::mirrors_environment({scene, 0}))
        all.levels = page_map_of(image::environment_levels(map, image::widest_level));
    return all;
}

} // namespace isomotion::page
