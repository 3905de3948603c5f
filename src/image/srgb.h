#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace isomotion::image {

struct Frame;

/// The transfer functions of IEC 61966-2-1 between light and screen signal, both 0 to 1.
float linear_from_srgb(float signal);
float srgb_from_linear(float light);

/// The nearest integer code for a value of 0 to 1. Values outside are clamped; NaN gives 0.
template<class Code> Code quantised(float value) {
    constexpr auto top = std::numeric_limits<Code>::max();
    if (!(value > 0.0f)) return 0;
    if (value >= 1.0f) return top;
    return static_cast<Code>(value * float(top) + 0.5f);
}

/// sRGB in 8 bits by tables, since pow() for every sample costs more than compressing the picture.
class Srgb8 {
public:
    Srgb8();

    std::uint8_t code(float light) const {
        if (!(light > 0.0f)) return 0;
        if (light >= 1.0f) return 255;
        // The curve rises by less than one code per bucket, so this loop runs at most once.
        std::uint8_t code = first_[std::size_t(light * float(first_.size()))];
        while (code < 255 && light >= from_[code + 1u]) ++code;
        return code;
    }
    float light(std::uint8_t code) const { return light_[code]; }

private:
    std::array<float, 256> light_;         // the light of each code
    std::array<float, 256> from_;          // the least light for which a code is nearest
    std::array<std::uint8_t, 4096> first_; // the code at the lower end of each bucket
};

const Srgb8& srgb8();

/// The samples of a frame's colour; `coverage` is null for an opaque frame.
struct ColourPlanes {
    const float* red;
    const float* green;
    const float* blue;
    const float* coverage;
};

/// Throws an ImageError if R, G or B is missing.
ColourPlanes colour_planes(const Frame& frame);

} // namespace isomotion::image
