#include "module.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "decode_picture.h"
#include "image/srgb.h"

namespace isomotion::image::oiio {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& reason) {
    throw ImageError(fmt::format("environment {}: {}", file.string(), reason));
}

constexpr PictureLimits limits{.bytes = std::size_t(256) << 20, .channels = 16};

PictureFile opened(const std::filesystem::path& file, const base::Confines& within) {
    try {
        return PictureFile(file, limits, within);
    } catch (const ImageError& error) {
        fail(file, fmt::format("not a picture that can be read; give a latitude-longitude map as "
                               "EXR, HDR, TIFF, PNG or JPEG ({})",
                               error.what()));
    }
}

void check_size(const std::filesystem::path& file, const OIIO::ImageSpec& spec) {
    const auto resized = [&](int width) {
        return fmt::format("oiiotool {} --resize {}x{} smaller{}", file.string(), width, width / 2,
                           file.extension().string());
    };
    if (spec.height <= 0 || spec.width != 2 * std::int64_t(spec.height))
        fail(file, fmt::format("{} x {} pixels; a latitude-longitude map is twice as wide as high. "
                               "Of another projection it must be converted; of this one but not "
                               "quite that size: {}",
                               spec.width, spec.height,
                               resized(std::clamp(spec.width / 2 * 2, 2, widest_environment))));
    if (spec.width > widest_environment)
        fail(file, fmt::format("{} pixels wide; at most {} are possible: {}", spec.width,
                               widest_environment, resized(widest_environment)));
}

using Colour = std::array<std::size_t, 3>; // channels of a picture

Colour colour_of(const std::filesystem::path& file, const std::vector<std::string>& names) {
    const auto named = [&](const char* name) {
        return std::size_t(std::ranges::find(names, name) - names.begin());
    };
    const Colour colour{named("R"), named("G"), named("B")};
    if (std::ranges::find(colour, names.size()) == colour.end()) return colour;
    if (const std::size_t gray = named("Y"); gray < names.size()) return {gray, gray, gray};
    fail(file, fmt::format("no colour: it needs the channels R, G and B, or Y for gray, and has {}",
                           fmt::join(names, ", ")));
}

// Turns decoded samples into light; a file that says sRGB is decoded accordingly already. Colour of
// integers is meant for a screen unless the file says otherwise.
class Decoding {
public:
    explicit Decoding(const OIIO::ImageSpec& spec) {
        const std::string space = spec.get_string_attribute("oiio:ColorSpace");
        srgb_ = space.empty() && !spec.format.is_floating_point();
        if (space.starts_with("Gamma")) gamma_ = spec.get_float_attribute("oiio:Gamma", 1.0f);
    }
    float operator()(float sample) const {
        if (srgb_) return linear_from_srgb(sample);
        return gamma_ == 1.0f ? sample : std::pow(sample, gamma_);
    }

private:
    bool srgb_;
    float gamma_ = 1.0f;
};

constexpr float largest_half = 65504.0f, most = 1e6f;

// The largest light of a map that is finite: what takes the place of infinity.
float largest_of(PictureFile& picture, const Colour& colour, const Decoding& light) {
    float largest = 0.0f;
    for_each_decoded_band(picture, [&](int, const Frame& rows) {
        for (const std::size_t c : colour) {
            for (const float sample : rows.channels[c].samples) {
                if (const float value = light(sample); std::isfinite(value))
                    largest = std::max(largest, value);
            }
        }
    });
    return largest == 0.0f ? largest_half : std::min(largest, most);
}

float mended(float light, float largest) {
    if (!(light > 0.0f)) return 0.0f; // of NaN too
    return std::min(light, largest);
}

} // namespace

int read_environment(const std::filesystem::path& file, const EnvironmentSink& sink,
                     const base::Confines& within) {
    PictureFile picture = opened(file, within);
    const OIIO::ImageSpec spec = picture.spec();
    check_size(file, spec);
    const Colour colour = colour_of(file, spec.channelnames);
    const Decoding light(spec);
    // Whole numbers are from 0 to 1, and need no mending.
    const float largest =
        spec.format.is_floating_point() ? largest_of(picture, colour, light) : 1.0f;

    sink.begin(spec.width, spec.height);
    int changed = 0;
    for_each_decoded_band(picture, [&](int begin, const Frame& rows) {
        std::vector<float> texels(4 * rows.channels[colour[0]].samples.size(), 1.0f);
        for (std::size_t i = 0; i < texels.size(); i += 4) {
            bool whole = true;
            for (std::size_t c = 0; c < 3; ++c) {
                const float sample = light(rows.channels[colour[c]].samples[i / 4]);
                texels[i + c] = mended(sample, largest);
                whole = whole && texels[i + c] == sample;
            }
            changed += !whole;
        }
        sink.rows(begin, texels);
    });
    return changed;
}

} // namespace isomotion::image::oiio
