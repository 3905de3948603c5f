#include "module.h"

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

#include "attributes.h"
#include "base/file.h"
#include "image/pixel_hash.h"
#include "image/srgb.h"

namespace isomotion::image::oiio {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& reason) {
    throw ImageError(fmt::format("{}: not a whole picture: {}", file.string(), reason));
}

// OpenImageIO stops reading a PNG at its last row, so that the chunks behind it may be missing.
// They are followed here to the end chunk.
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

// A file's first picture, opened; its rows are read in bands, interleaved.
class Picture {
public:
    explicit Picture(const std::filesystem::path& file)
        : file_(file)
        , bytes_(base::read_whole(file))
        , memory_(bytes_.data(), bytes_.size()) {
        if (is_png(bytes_) && !has_end_chunk(bytes_)) fail(file, "its end is missing");
        OIIO::ImageSpec wish;
        wish.attribute("oiio:UnassociatedAlpha", 1); // colour as it is kept, not multiplied yet
        input_ = OIIO::ImageInput::open(file.string(), &wish, &memory_);
        if (!input_) fail(file, OIIO::geterror());
    }

    const OIIO::ImageSpec& spec() const { return input_->spec(); }

    // Calls take(begin, end, samples) for all rows from the top.
    template<class Sample, class Take> void for_each_band(Take&& take) {
        const OIIO::ImageSpec& spec = input_->spec();
        const int at_once = spec.tile_width ? spec.tile_height : 128;
        const std::size_t row = std::size_t(spec.width) * std::size_t(spec.nchannels);
        std::vector<Sample> band(row * std::size_t(at_once));
        for (int begin = 0; begin < spec.height; begin += at_once) {
            const int end = std::min(begin + at_once, spec.height);
            if (!read(begin, end, OIIO::BaseTypeFromC<Sample>::value, band.data()))
                fail(file_, input_->geterror());
            take(begin, end, std::span<const Sample>(band).first(row * std::size_t(end - begin)));
        }
    }

private:
    bool read(int begin, int end, const OIIO::TypeDesc& type, void* samples) {
        const OIIO::ImageSpec& spec = input_->spec();
        const int top = spec.y + begin, bottom = spec.y + end;
        if (spec.tile_width == 0)
            return input_->read_scanlines(0, 0, top, bottom, 0, 0, spec.nchannels, type, samples);
        return input_->read_tiles(0, 0, spec.x, spec.x + spec.width, top, bottom, spec.z,
                                  spec.z + 1, 0, spec.nchannels, type, samples);
    }

    const std::filesystem::path& file_;
    std::vector<std::byte> bytes_;
    OIIO::Filesystem::IOMemReader memory_;
    std::unique_ptr<OIIO::ImageInput> input_; // after what it reads from
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
    Picture picture(file);
    const OIIO::ImageSpec spec = picture.spec();
    Frame frame{spec.width, spec.height, {}, entries_of(spec)};
    const auto width = std::size_t(spec.width), channels = std::size_t(spec.nchannels);
    for (const std::string& name : spec.channelnames)
        frame.channels.push_back({name, std::vector<float>(width * std::size_t(spec.height))});

    picture.for_each_band<float>([&](int begin, int end, std::span<const float> band) {
        const std::size_t first = width * std::size_t(begin);
        const std::size_t count = width * std::size_t(end - begin);
        for (std::size_t c = 0; c < channels; ++c)
            for (std::size_t i = 0; i < count; ++i)
                frame.channels[c].samples[first + i] = band[i * channels + c];
    });
    make_linear(frame, spec);
    multiply_by_coverage(frame, spec);
    return frame;
}

std::string pixel_hash(const std::filesystem::path& file) {
    Picture picture(file);
    const OIIO::ImageSpec spec = picture.spec();
    PixelHash hash(spec.width, spec.height);
    const auto add_codes = [&](int, int, auto band) { hash.add_codes(band); };
    if (spec.format == OIIO::TypeDesc::UINT8) {
        picture.for_each_band<std::uint8_t>(add_codes);
    } else if (spec.format == OIIO::TypeDesc::UINT16) {
        picture.for_each_band<std::uint16_t>(add_codes);
    } else {
        const auto channels = std::size_t(spec.nchannels);
        picture.for_each_band<float>([&](int, int, std::span<const float> band) {
            for (std::size_t c = 0; c < channels; ++c)
                hash.add_channel(spec.channelnames[c], band, c, channels);
        });
    }
    return hash.text();
}

} // namespace isomotion::image::oiio
