#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <png.h>

#include "image/frame.h"

namespace isomotion::image::files {

// Writes a PNG in memory, with rows in order from the top.
//
// libpng reports failure by a longjmp over its callers, and no exception may pass through it. So
// each call is made where a jump skips no destructor.
class PngWriter {
public:
    // Opaque, or with a separate alpha that is not multiplied into the colour; 8 or 16 bits per
    // sample.
    PngWriter(int width, int height, bool has_alpha, int bits, const Metadata& metadata);
    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;
    ~PngWriter();

    // Interleaved samples of whole rows, in native byte order.
    void write_rows(const void* samples, std::size_t bytes, int rows);
    std::vector<std::byte> finish() &&;

private:
    PngWriter();
    static void take(png_structp png, png_bytep data, std::size_t size);
    static void fail(png_structp png, const char* reason);
    template<class Calls> void by_libpng(Calls&& calls);

    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    std::vector<std::byte> bytes_;
    char reason_[128] = "";
    bool out_of_memory_ = false;
};

} // namespace isomotion::image::files
