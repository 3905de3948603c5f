#include "module.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <half.h>

#include "exr_writer.h"
#include "image/pixel_hash.h"
#include "image/srgb.h"
#include "png_writer.h"

namespace isomotion::image::files {
namespace {

// How many rows are interleaved at a time: enough to compress in parallel, few enough that a 16k
// frame does not need its size in memory again.
constexpr int rows_at_once = 128;

template<class Pack> void write_in_bands(int height, const Pack& pack) {
    for (int begin = 0; begin < height; begin += rows_at_once)
        pack(begin, std::min(begin + rows_at_once, height));
}

std::uint8_t signal(float light, std::uint8_t) { return srgb8().code(light); }
std::uint16_t signal(float light, std::uint16_t) {
    return quantised<std::uint16_t>(srgb_from_linear(std::clamp(light, 0.0f, 1.0f)));
}

template<class Code>
void pack_pixel(const ColourPlanes& planes, std::size_t pixel, std::vector<Code>& out) {
    float scale = 1.0f;
    if (planes.coverage) {
        const float coverage = std::min(planes.coverage[pixel], 1.0f);
        scale = coverage > 0.0f ? 1.0f / coverage : 0.0f;
    }
    for (const float* plane : {planes.red, planes.green, planes.blue})
        out.push_back(signal(scale > 0.0f ? plane[pixel] * scale : 0.0f, Code{}));
    if (planes.coverage) out.push_back(quantised<Code>(planes.coverage[pixel]));
}

template<class Code> std::vector<std::byte> encode_png(const Frame& frame, PixelHash* hash) {
    const ColourPlanes planes = colour_planes(frame);
    PngWriter writer(frame.width, frame.height, planes.coverage != nullptr, 8 * int(sizeof(Code)),
                     frame.metadata);
    std::vector<Code> rows;
    write_in_bands(frame.height, [&](int begin, int end) {
        const auto width = std::size_t(frame.width);
        rows.clear();
        for (std::size_t i = width * std::size_t(begin); i < width * std::size_t(end); ++i)
            pack_pixel(planes, i, rows);
        if (hash) hash->add_codes(std::span<const Code>(rows));
        writer.write_rows(rows.data(), rows.size() * sizeof(Code), end - begin);
    });
    return std::move(writer).finish();
}

bool is_colour(const std::string& name) {
    return name == "R" || name == "G" || name == "B" || name == "A";
}

// The half that a file keeps for the value.
Imath::half to_half(float value) {
    constexpr float largest_half = 65504.0f;
    if (!std::isfinite(value)) return value;
    return std::clamp(value, -largest_half, largest_half);
}

std::vector<std::byte> encode_exr(const Frame& frame, PixelHash* hash) {
    std::vector<ExrChannel> channels;
    for (const Channel& channel : frame.channels)
        channels.push_back({channel.name, is_colour(channel.name)});
    ExrWriter writer(frame.width, frame.height, channels, frame.metadata);
    std::vector<std::vector<Imath::half>> halves(channels.size());
    std::vector<ExrSamples> rows(channels.size());
    write_in_bands(frame.height, [&](int begin, int end) {
        const std::size_t first = std::size_t(frame.width) * std::size_t(begin);
        const std::size_t count = std::size_t(frame.width) * std::size_t(end - begin);
        for (std::size_t c = 0; c < channels.size(); ++c) {
            rows[c] = {{}, std::span(frame.channels[c].samples).subspan(first, count)};
            std::span<const float> kept = rows[c].floats;
            std::vector<float> rounded;
            if (channels[c].is_half) {
                halves[c].resize(count);
                std::ranges::transform(kept, halves[c].begin(), to_half);
                rows[c] = {halves[c], {}};
                if (hash) kept = rounded = {halves[c].begin(), halves[c].end()};
            }
            if (hash) hash->add_channel(channels[c].name, kept, 0, 1);
        }
        writer.write_rows(begin, end, rows);
    });
    return std::move(writer).finish();
}

} // namespace

std::vector<std::byte> encode(const Frame& frame, Format format, PixelHash* hash) {
    switch (format) {
    case Format::png8:
        return encode_png<std::uint8_t>(frame, hash);
    case Format::png16:
        return encode_png<std::uint16_t>(frame, hash);
    case Format::exr:
        return encode_exr(frame, hash);
    }
    throw ImageError("encode: no such format");
}

} // namespace isomotion::image::files
