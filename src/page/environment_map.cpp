#include "page/environment_map.h"

#include <algorithm>
#include <span>

#include <glm/glm.hpp>
#include <glm/gtc/packing.hpp>

#include "image/environment.h"

namespace isomotion::page {

EnvironmentMap environment_map(const scene::Environment& environment,
                               const std::function<void(const std::string&)>& warn) {
    EnvironmentMap map;
    std::vector<glm::dvec3> sums;
    int block = 1, read_width = 0; // texels across that become one
    image::EnvironmentSink sink;
    sink.begin = [&](int width, int height) {
        read_width = width;
        while (width / block > widest_map) block *= 2;
        map.width = std::max(width / block, 1);
        map.height = std::max(height / block, 1);
        sums.assign(std::size_t(map.width) * std::size_t(map.height), glm::dvec3(0));
    };
    sink.rows = [&](int first, std::span<const float> texels) {
        const std::size_t rows = texels.size() / 4 / std::size_t(read_width);
        for (std::size_t k = 0; k < rows * std::size_t(read_width); ++k) {
            const int x = int(k % std::size_t(read_width)) / block;
            const int y = (first + int(k / std::size_t(read_width))) / block;
            if (x >= map.width || y >= map.height) continue; // a rest less than a block
            const float* texel = &texels[4 * k];
            sums[std::size_t(y) * std::size_t(map.width) + std::size_t(x)] +=
                glm::dvec3(texel[0], texel[1], texel[2]);
        }
    };
    const int mended = image::read_environment(environment.map, sink, environment.within);
    if (mended > 0 && warn) warn(image::mending(environment.map, mended));
    constexpr double largest_half = 65504;
    for (const glm::dvec3& sum : sums) {
        const glm::dvec3 mean = glm::min(sum / double(block * block), glm::dvec3(largest_half));
        for (int k = 0; k < 3; ++k) {
            const glm::uint16 half = glm::packHalf1x16(float(mean[k]));
            map.texels.push_back(std::byte(half & 0xff));
            map.texels.push_back(std::byte(half >> 8));
        }
    }
    return map;
}

} // namespace isomotion::page
