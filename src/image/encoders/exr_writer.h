#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <ImfOutputFile.h>
#include <half.h>

#include "image/frame.h"

namespace isomotion::image::files {

// A channel's samples in some rows: as halves, or, if there are none, as floats.
struct ExrSamples {
    std::span<const Imath::half> halves;
    std::span<const float> floats;
};

struct ExrChannel {
    std::string name;
    bool is_half;
};

// Writes an EXR in memory, with rows in order from the top.
class ExrWriter {
public:
    ExrWriter(int width, int height, std::vector<ExrChannel> channels, const Metadata& metadata);
    ~ExrWriter();

    // The samples of each channel, in the constructor's order.
    void write_rows(int begin, int end, std::span<const ExrSamples> samples);
    std::vector<std::byte> finish() &&;

private:
    class Bytes;

    int width_;
    std::vector<ExrChannel> channels_;
    std::unique_ptr<Bytes> bytes_;
    // Destroyed before the bytes, which it writes to until then.
    std::unique_ptr<Imf::OutputFile> file_;
};

} // namespace isomotion::image::files
