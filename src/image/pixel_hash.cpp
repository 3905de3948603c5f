#include "image/pixel_hash.h"

#include <array>
#include <cmath>
#include <limits>

namespace isomotion::image {

PixelHash::PixelHash(int width, int height)
    : size_{width, height} {}

void PixelHash::add_channel(const std::string& name, std::span<const float> interleaved,
                            std::size_t first, std::size_t stride) {
    base::ContentHash& hash = channels_[name];
    std::array<float, 1024> some;
    std::size_t count = 0;
    const auto flush = [&] { hash.add_values(std::span<const float>(some.data(), count)); };
    for (std::size_t i = first; i < interleaved.size(); i += stride) {
        const float sample = interleaved[i];
        some[count++] = std::isnan(sample) ? std::numeric_limits<float>::quiet_NaN() : sample;
        if (count < some.size()) continue;
        flush();
        count = 0;
    }
    flush();
}

std::string PixelHash::text() const {
    base::ContentHash whole;
    whole.add_values(std::span<const std::int32_t>(size_));
    for (const auto& [name, hash] : channels_) whole.add(name).add(hash.text());
    return whole.text();
}

} // namespace isomotion::image
