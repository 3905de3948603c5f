// What the bytes of a picture tell before a reader is asked, which may take memory as soon as it
// opens a file, and time before its first row.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace isomotion::image::oiio {

// OpenImageIO stops reading a PNG at its last row, so that the chunks behind it may be missing.
// They are followed here to the end chunk.
bool has_end_chunk(std::span<const std::byte> png);

// Passes over the whole picture, which libjpeg makes before it gives the first row: 1 for a
// baseline JPEG, some 10 for a progressive one.
int count_scans(std::span<const std::byte> jpeg);

// The largest of each number that headers of an EXR may be taken to have, wherever they are.
struct ExrSizes {
    std::int64_t width = 0, height = 0; // of data windows
    std::int64_t tile_width = 0, tile_height = 0;
    std::int64_t channels = 0;
};
ExrSizes exr_sizes(std::span<const std::byte> exr);

} // namespace isomotion::image::oiio
