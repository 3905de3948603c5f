#include "image/decode.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "image/file.h"
#include "image/image_attributes.h"
#include "image/srgb.h"

namespace isomotion::image {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& reason) {
    throw ImageError(fmt::format("{}: not a whole picture: {}", file.string(), reason));
}

/// OpenImageIO stops reading a PNG at its last row, so that the chunks behind it may be missing.
/// They are followed here to the end chunk.
bool has_end_chunk(std::span<const std::byte> png) {
    constexpr std::size_t signature = 8, overhead = 12; // length, type and checksum of a chunk
    constexpr std::array end_type{std::byte{'I'}, std::byte{'E'}, std::byte{'N'}, std::byte{'D'}};
    std::size_t at = signature;
    while (at + overhead <= png.size()) {
        std::size_t length = 0;
        for (const std::byte digit : png.subspan(at, 4)) length = length << 8 | std::size_t(digit);
        if (length > png.size() - at - overhead) return false;
        if (std::ranges::equal(png.subspan(at + 4, 4), end_type)) return true;
        at += length + overhead;
    }
    return false;
}

bool is_png(std::span<const std::byte> bytes) {
    constexpr std::array start{std::byte{0x89}, std::byte{'P'}, std::byte{'N'}, std::byte{'G'}};
    return bytes.size() >= start.size() && std::ranges::equal(bytes.first(start.size()), start);
}

/// Reads bands of rows of a file, interleaved and as float.
class Rows {
public:
    explicit Rows(OIIO::ImageInput& input)
        : input_(input)
        , spec_(input.spec())
        , at_once_(spec_.tile_width ? spec_.tile_height : 128) {}

    int at_once() const { return at_once_; }

    bool read(int begin, int end, float* samples) {
        const int top = spec_.y + begin, bottom = spec_.y + end;
        if (spec_.tile_width == 0)
            return input_.read_scanlines(0, 0, top, bottom, 0, 0, spec_.nchannels, OIIO::TypeFloat,
                                         samples);
        return input_.read_tiles(0, 0, spec_.x, spec_.x + spec_.width, top, bottom, spec_.z,
                                 spec_.z + 1, 0, spec_.nchannels, OIIO::TypeFloat, samples);
    }

private:
    OIIO::ImageInput& input_;
    const OIIO::ImageSpec& spec_;
    int at_once_;
};

void make_linear(Frame& frame, const OIIO::ImageSpec& spec) {
    if (spec.get_string_attribute("oiio:ColorSpace") != "sRGB") return;
    const bool bytes = spec.format == OIIO::TypeDesc::UINT8;
    for (std::size_t c = 0; c < frame.channels.size(); ++c) {
        if (int(c) == spec.alpha_channel) continue;
        for (float& sample : frame.channels[c].samples)
            sample =
                bytes ? srgb8().light(quantised<std::uint8_t>(sample)) : linear_from_srgb(sample);
    }
}

void multiply_by_coverage(Frame& frame, const OIIO::ImageSpec& spec) {
    if (spec.alpha_channel < 0 || !spec.get_int_attribute("oiio:UnassociatedAlpha")) return;
    const std::vector<float>& coverage = frame.channels[std::size_t(spec.alpha_channel)].samples;
    for (std::size_t c = 0; c < frame.channels.size(); ++c) {
        if (int(c) == spec.alpha_channel) continue;
        std::vector<float>& samples = frame.channels[c].samples;
        std::ranges::transform(samples, coverage, samples.begin(), std::multiplies{});
    }
}

} // namespace

Frame decode(const std::filesystem::path& file) {
    const std::vector<std::byte> bytes = read_whole(file);
    if (is_png(bytes) && !has_end_chunk(bytes)) fail(file, "its end is missing");

    OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
    OIIO::ImageSpec wish;
    wish.attribute("oiio:UnassociatedAlpha", 1); // multiplied below, after the light is linear
    const auto input = OIIO::ImageInput::open(file.string(), &wish, &memory);
    if (!input) fail(file, OIIO::geterror());

    const OIIO::ImageSpec spec = input->spec();
    Frame frame{spec.width, spec.height, {}, entries_of(spec)};
    const auto width = std::size_t(spec.width), channels = std::size_t(spec.nchannels);
    for (const std::string& name : spec.channelnames)
        frame.channels.push_back({name, std::vector<float>(width * std::size_t(spec.height))});

    Rows rows(*input);
    std::vector<float> band(width * channels * std::size_t(rows.at_once()));
    for (int begin = 0; begin < spec.height; begin += rows.at_once()) {
        const int end = std::min(begin + rows.at_once(), spec.height);
        if (!rows.read(begin, end, band.data())) fail(file, input->geterror());
        const std::size_t first = width * std::size_t(begin);
        const std::size_t count = width * std::size_t(end - begin);
        for (std::size_t c = 0; c < channels; ++c)
            for (std::size_t i = 0; i < count; ++i)
                frame.channels[c].samples[first + i] = band[i * channels + c];
    }
    make_linear(frame, spec);
    multiply_by_coverage(frame, spec);
    return frame;
}

Metadata read_metadata(const std::filesystem::path& file) { return decode(file).metadata; }

} // namespace isomotion::image
