#include "image/srgb.h"

#include <cmath>

#include "image/frame.h"

namespace isomotion::image {

float linear_from_srgb(float signal) {
    return signal <= 0.04045f ? signal / 12.92f : std::pow((signal + 0.055f) / 1.055f, 2.4f);
}

float srgb_from_linear(float light) {
    return light <= 0.0031308f ? light * 12.92f : 1.055f * std::pow(light, 1.0f / 2.4f) - 0.055f;
}

Srgb8::Srgb8() {
    for (int code = 0; code < 256; ++code) {
        light_[std::size_t(code)] = linear_from_srgb(float(code) / 255.0f);
        from_[std::size_t(code)] =
            code == 0 ? 0.0f : linear_from_srgb((float(code) - 0.5f) / 255.0f);
    }
    std::uint8_t code = 0;
    for (std::size_t bucket = 0; bucket < first_.size(); ++bucket) {
        const float light = float(bucket) / float(first_.size());
        while (code < 255 && light >= from_[code + 1u]) ++code;
        first_[bucket] = code;
    }
}

const Srgb8& srgb8() {
    static const Srgb8 tables;
    return tables;
}

ColourPlanes colour_planes(const Frame& frame) {
    const auto plane = [&](const char* name) {
        const Channel* channel = frame.find(name);
        return channel ? channel->samples.data() : nullptr;
    };
    const ColourPlanes planes{plane("R"), plane("G"), plane("B"), plane("A")};
    if (!planes.red || !planes.green || !planes.blue)
        throw ImageError("a picture for the eye needs the channels R, G and B");
    return planes;
}

} // namespace isomotion::image
