#include "picture_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include <fmt/format.h>

#include "base/file.h"
#include "image/frame.h"

namespace isomotion::image::oiio {
namespace {

using namespace std::string_view_literals;

[[noreturn]] void fail(const std::string& file, const std::string& reason) {
    throw ImageError(fmt::format("{}: {}", file, reason));
}

struct Signature {
    std::string_view bytes;
    const char* reader; // OpenImageIO's name of the format
};

constexpr std::array signatures{
    Signature{"\x76\x2f\x31\x01"sv, "openexr"},
    Signature{"#?RADIANCE"sv, "hdr"},
    Signature{"#?RGBE"sv, "hdr"},
    Signature{"II*\0"sv, "tiff"},
    Signature{"MM\0*"sv, "tiff"},
    Signature{"II+\0"sv, "tiff"},
    Signature{"MM\0+"sv, "tiff"},
    Signature{"\x89PNG\r\n\x1a\n"sv, "png"},
    Signature{"\xff\xd8\xff"sv, "jpeg"},
};

// Null for none of the five formats.
const Signature* signature_of(std::span<const std::byte> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const auto found = std::ranges::find_if(
        signatures, [&](const Signature& is) { return text.starts_with(is.bytes); });
    return found == signatures.end() ? nullptr : &*found;
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

std::vector<std::byte> bytes_of(const std::filesystem::path& file, std::size_t most) {
    try {
        return base::read_whole(file, most);
    } catch (const base::FileError& error) {
        if (error.code() != EFBIG) throw;
        fail(file.string(), fmt::format("has more than {} MB, the most that is read", most >> 20));
    }
}

// Enough for samples of every kind.
std::size_t row_bytes(const OIIO::ImageSpec& is) {
    return std::size_t(is.width) * std::size_t(is.nchannels) * sizeof(float);
}

void check(const std::string& file, const Signature& signature, const OIIO::ImageSpec& is,
           const PictureLimits& limits) {
    if (is.width < 1 || is.height < 1 || is.width > limits.side || is.height > limits.side)
        fail(file, fmt::format("{} x {} pixels; sides of 1 to {} are possible", is.width, is.height,
                               limits.side));
    if (is.depth > 1 || is.deep) fail(file, "a volume or deep picture; a flat one belongs here");
    if (is.nchannels < 1 || is.nchannels > limits.channels)
        fail(file, fmt::format("{} channels; 1 to {} are possible", is.nchannels, limits.channels));
    constexpr std::size_t whole = std::size_t(2) << 30; // readers but OpenEXR's may hold it all
    if (signature.reader != "openexr"sv && is.image_bytes(true) > whole)
        fail(file, fmt::format("{} MB of samples; {} MB are possible", is.image_bytes(true) >> 20,
                               whole >> 20));
    const int rows = rows_at_once(is);
    if (row_bytes(is) * std::size_t(rows) > limits.band_bytes)
        fail(file, fmt::format("tiles of {} rows in a picture {} wide; they may take {} MB at most",
                               rows, is.width, limits.band_bytes >> 20));
}

} // namespace

int rows_at_once(const OIIO::ImageSpec& is) {
    constexpr std::size_t bytes = std::size_t(64) << 20;
    if (is.tile_width) return is.tile_height;
    return int(std::clamp<std::size_t>(bytes / row_bytes(is), 1, 128));
}

PictureFile::PictureFile(const std::filesystem::path& file, const PictureLimits& limits)
    : file_(file.string())
    , bytes_(bytes_of(file, limits.bytes))
    , memory_(bytes_.data(), bytes_.size()) {
    const Signature* signature = signature_of(bytes_);
    if (!signature) fail(file_, "no picture that is read; EXR, HDR, TIFF, PNG and JPEG are");
    if (signature->reader == "png"sv && !has_end_chunk(bytes_))
        fail(file_, "not a whole picture: its end is missing");
    input_ = OIIO::ImageInput::create(signature->reader);
    OIIO::ImageSpec wish, found;
    wish.attribute("oiio:UnassociatedAlpha", 1); // colour as it is kept, not multiplied yet
    const bool opened = input_ && std::string_view(input_->format_name()) == signature->reader &&
                        input_->set_ioproxy(&memory_) && input_->open("picture", found, wish);
    if (!opened)
        fail(file_, "not a whole picture: " + (input_ ? input_->geterror() : OIIO::geterror()));
    check(file_, *signature, spec(), limits);
}

void PictureFile::read(int begin, int end, const OIIO::TypeDesc& type, void* samples) {
    const OIIO::ImageSpec& is = spec();
    const int top = is.y + begin, bottom = is.y + end;
    const bool done =
        is.tile_width == 0
            ? input_->read_scanlines(0, 0, top, bottom, 0, 0, is.nchannels, type, samples)
            : input_->read_tiles(0, 0, is.x, is.x + is.width, top, bottom, is.z, is.z + 1, 0,
                                 is.nchannels, type, samples);
    if (!done) fail(file_, "not a whole picture: " + input_->geterror());
}

} // namespace isomotion::image::oiio
