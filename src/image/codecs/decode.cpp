#include "module.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "attributes.h"
#include "decode_picture.h"
#include "image/pixel_hash.h"
#include "image/srgb.h"

namespace isomotion::image::oiio {
namespace {

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

void for_each_decoded_band(PictureFile& picture, const std::function<void(int, Frame&&)>& take) {
    const OIIO::ImageSpec& spec = picture.spec();
    const auto channels = std::size_t(spec.nchannels);
    picture.for_each_band<float>([&](int begin, int end, std::span<const float> band) {
        Frame rows{spec.width, end - begin, {}, {}};
        for (std::size_t c = 0; c < channels; ++c) {
            std::vector<float> samples(band.size() / channels);
            for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = band[i * channels + c];
            rows.channels.push_back({spec.channelnames[c], std::move(samples)});
        }
        make_linear(rows, spec);
        multiply_by_coverage(rows, spec);
        take(begin, std::move(rows));
    });
}

Frame decode(const std::filesystem::path& file) {
    PictureFile picture(file);
    const OIIO::ImageSpec& spec = picture.spec();
    Frame frame{spec.width, spec.height, {}, entries_of(spec)};
    for (const std::string& name : spec.channelnames) frame.channels.push_back({name, {}});
    for_each_decoded_band(picture, [&](int, Frame&& rows) {
        for (std::size_t c = 0; c < rows.channels.size(); ++c) {
            std::vector<float>& samples = frame.channels[c].samples;
            const std::vector<float>& more = rows.channels[c].samples;
            samples.insert(samples.end(), more.begin(), more.end());
        }
    });
    return frame;
}

std::string pixel_hash(const std::filesystem::path& file) {
    PictureFile picture(file);
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
