// Inspects the bytes of a picture before a reader opens it. A reader may allocate memory as soon as
// it opens a file, and take long before its first row.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace isomotion::image::oiio {

// The four bytes from `at` on, which must be there.
std::uint32_t little_endian(std::span<const std::byte> bytes, std::size_t at);

// OpenImageIO stops reading a PNG at its last row, so chunks after it may be missing. This function
// follows them to the end chunk.
bool has_end_chunk(std::span<const std::byte> png);

// The number of a PNG's chunks that hold packed text or a packed profile, up to its end chunk. A
// few kilobytes of each may unpack to the 8 MB that libpng allows it, and all are kept.
std::size_t count_packed_chunks(std::span<const std::byte> png);

// The number of passes over the whole picture that libjpeg makes before the first row: 1 for a
// baseline JPEG, some 10 for a progressive one.
int count_scans(std::span<const std::byte> jpeg);

// Upper limits of the numbers that headers of an EXR may contain, wherever these are.
struct ExrSizes {
    std::int64_t width = 0, height = 0; // of data windows
    std::int64_t tile_width = 0, tile_height = 0;
    std::int64_t channels = 0;
};
ExrSizes exr_sizes(std::span<const std::byte> exr);

} // namespace isomotion::image::oiio
