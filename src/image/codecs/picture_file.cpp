#include "picture_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <new>
#include <string_view>

#include <fmt/format.h>

#include "base/file.h"
#include "exr_header.h"
#include "first_look.h"
#include "image/frame.h"

namespace isomotion::image::oiio {
namespace {

using namespace std::string_view_literals;

// What a reader says where the machine has too little memory is no mistake of the file's.
[[noreturn]] void fail(const std::string& file, const std::string& reason) {
    if (reason.find("bad_alloc") != reason.npos) throw std::bad_alloc();
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

std::vector<std::byte> bytes_of(const std::filesystem::path& file, std::size_t most,
                                const base::Confines& within) {
    try {
        return base::read_whole(file, most, within);
    } catch (const base::FileError& error) {
        if (error.system_code() != EFBIG) throw;
        fail(file.string(), fmt::format("has more than {} MB, the most that is read", most >> 20));
    }
}

// Enough for samples of every kind.
std::size_t row_bytes(const OIIO::ImageSpec& is) {
    return std::size_t(is.width) * std::size_t(is.nchannels) * sizeof(float);
}

void check_sides(const std::string& file, std::int64_t width, std::int64_t height,
                 const PictureLimits& limits) {
    if (width < 1 || height < 1 || width > limits.side || height > limits.side)
        fail(file, fmt::format("{} x {} pixels; sides of 1 to {} are possible", width, height,
                               limits.side));
}
void check_channels(const std::string& file, std::int64_t channels, const PictureLimits& limits) {
    if (channels < 1 || channels > limits.channels)
        fail(file, fmt::format("{} channels; 1 to {} are possible", channels, limits.channels));
}

// Readers take memory for whole tiles, however few of their pixels are the picture's.
void check_tiles(const std::string& file, std::int64_t picture_width, std::int64_t width,
                 std::int64_t height, std::int64_t channels, const PictureLimits& limits) {
    if (width == 0 && height == 0) return;
    if (width < 1 || height < 1 || width > limits.side || height > limits.side)
        fail(file, fmt::format("tiles of {} x {} pixels; sides of 1 to {} are possible", width,
                               height, limits.side));
    const std::int64_t across = (picture_width + width - 1) / width * width;
    if (std::size_t(across * height * channels) * sizeof(float) > limits.band_bytes)
        fail(file, fmt::format("tiles of {} x {} pixels in a picture {} wide; a row of tiles may "
                               "take {} MB at most",
                               width, height, picture_width, limits.band_bytes >> 20));
}

// What the file itself says, before a reader takes memory or time for it.
void check_before_opening(const std::string& file, const Signature& signature,
                          std::span<const std::byte> bytes, const PictureLimits& limits) {
    if (signature.reader == "png"sv && !has_end_chunk(bytes))
        fail(file, "not a whole picture: its end is missing");
    if (const std::size_t packed = signature.reader == "png"sv ? count_packed_chunks(bytes) : 0;
        packed > limits.packed_chunks)
        fail(file, fmt::format("{} chunks of packed text or profiles in a PNG; at most {} are read",
                               packed, limits.packed_chunks));
    if (signature.reader == "jpeg"sv) {
        if (const int scans = count_scans(bytes); scans > limits.scans)
            fail(file, fmt::format("{} scans of a progressive JPEG; at most {} are read", scans,
                                   limits.scans));
    }
    if (signature.reader == "openexr"sv) {
        if (const std::string fault = fault_of_exr_headers(bytes); !fault.empty())
            fail(file, fault);
        const ExrSizes sizes = exr_sizes(bytes);
        if (sizes.width == 0 || sizes.height == 0 || sizes.channels == 0) return; // no picture
        check_sides(file, sizes.width, sizes.height, limits);
        check_channels(file, sizes.channels, limits);
        check_tiles(file, sizes.width, sizes.tile_width, sizes.tile_height, sizes.channels, limits);
    }
}

void check(const std::string& file, const Signature& signature, const OIIO::ImageSpec& is,
           const PictureLimits& limits) {
    check_sides(file, is.width, is.height, limits);
    if (is.depth > 1 || is.deep) fail(file, "a volume or deep picture; a flat one belongs here");
    check_channels(file, is.nchannels, limits);
    constexpr std::size_t whole = std::size_t(2) << 30; // readers but OpenEXR's may hold it all
    if (signature.reader != "openexr"sv && is.image_bytes(true) > whole)
        fail(file, fmt::format("{} MB of samples; {} MB are possible", is.image_bytes(true) >> 20,
                               whole >> 20));
    check_tiles(file, is.width, is.tile_width, is.tile_height, is.nchannels, limits);
}

} // namespace

int rows_at_once(const OIIO::ImageSpec& is) {
    constexpr std::size_t bytes = std::size_t(64) << 20;
    if (is.tile_width) return is.tile_height;
    return int(std::clamp<std::size_t>(bytes / row_bytes(is), 1, 128));
}

PictureFile::PictureFile(const std::filesystem::path& file, const PictureLimits& limits,
                         const base::Confines& within)
    : file_(file.string())
    , bytes_(bytes_of(file, limits.bytes, within))
    , memory_(bytes_.data(), bytes_.size()) {
    const Signature* signature = signature_of(bytes_);
    if (!signature) fail(file_, "no picture that is read; EXR, HDR, TIFF, PNG and JPEG are");
    check_before_opening(file_, *signature, bytes_, limits);
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
