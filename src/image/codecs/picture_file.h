// Opens pictures of strangers safely.
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "base/confines.h"

namespace isomotion::image::oiio {

// Limits on a picture.
struct PictureLimits {
    std::size_t bytes = std::size_t(4) << 30; // of the file
    int side = 16'384;
    int channels = 64;
    std::size_t band_bytes = std::size_t(256) << 20; // of the rows decoded at once
    int scans = 100;                                 // of a progressive JPEG
    std::size_t packed_chunks = 64;                  // of a PNG
};

// Rows of a band: one row of tiles, or rows of some 64 MB.
int rows_at_once(const OIIO::ImageSpec& is);

// The first picture of an EXR, HDR, TIFF, PNG or JPEG, identified by its first bytes and read from
// memory. No other reader of OpenImageIO is used, since some open further files that the first one
// names.
class PictureFile {
public:
    // Throws FileError; ImageError ("FILE: ...") for another format, a broken file, or one whose
    // header exceeds the limits, which is known before anything is decoded; InputError for a file
    // outside its confines.
    explicit PictureFile(const std::filesystem::path& file, const PictureLimits& limits = {},
                         const base::Confines& within = {});

    const OIIO::ImageSpec& spec() const { return input_->spec(); }

    // Calls take(begin, end, samples) for all rows from the top, with interleaved samples.
    template<class Sample, class Take> void for_each_band(Take&& take) {
        const OIIO::ImageSpec& is = spec();
        const std::size_t row = std::size_t(is.width) * std::size_t(is.nchannels);
        const int at_once = rows_at_once(is);
        std::vector<Sample> band(row * std::size_t(std::min(at_once, is.height)));
        for (int begin = 0; begin < is.height; begin += at_once) {
            const int end = std::min(begin + at_once, is.height);
            read(begin, end, OIIO::BaseTypeFromC<Sample>::value, band.data());
            take(begin, end, std::span<const Sample>(band).first(row * std::size_t(end - begin)));
        }
    }

private:
    void read(int begin, int end, const OIIO::TypeDesc& type, void* samples);

    std::string file_; // as in messages
    std::vector<std::byte> bytes_;
    OIIO::Filesystem::IOMemReader memory_;
    std::unique_ptr<OIIO::ImageInput> input_; // destroyed before the memory that it reads
};

} // namespace isomotion::image::oiio
