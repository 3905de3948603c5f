#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "image/frame.h"

namespace isomotion::image {

enum class Format {
    png8,  ///< R, G, B and A alone, as sRGB in 8 bits
    png16, ///< the same in 16 bits
    exr,   ///< every channel: R, G, B, A as linear half, the others as 32-bit float
};

constexpr std::string_view name(Format format) {
    switch (format) {
    case Format::png8:
        return "png 8";
    case Format::png16:
        return "png 16";
    case Format::exr:
        return "exr";
    }
    return "?";
}

/// Longest name in a file's metadata, in bytes.
constexpr std::size_t longest_name(Format format) { return format == Format::exr ? 255 : 79; }

enum class PngDepth { bits8, bits16 };

/// The format that a file name implies. Throws an ImageError that lists the choices.
Format format_of(const std::filesystem::path& file, PngDepth depth = PngDepth::bits8);

/// The bytes of a file with the frame. They depend on the frame alone: not on the time, the machine
/// or the number of threads. (A `DateTime` in the metadata is written as given.)
///
/// EXR keeps NaN and infinite samples. A finite colour beyond the range of half becomes the largest
/// half, because a bright light is not an infinite one. Metadata keeps its types.
///
/// PNG stores unpremultiplied colour, so it cannot hold light where the coverage is 0. NaN becomes
/// 0 and infinity the largest value. Metadata becomes text (see to_text()).
std::vector<std::byte> encode(const Frame& frame, Format format);

struct Encoded {
    std::vector<std::byte> bytes;
    std::string pixels; ///< the pixel_hash() of a file of these bytes
};
/// The same, with a hash of its pixels, which costs little during encoding.
Encoded encode_with_hash(const Frame& frame, Format format);

} // namespace isomotion::image
