#include "module.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <half.h>

#include "attributes.h"
#include "image/pixel_hash.h"
#include "image/srgb.h"

namespace isomotion::image::oiio {
namespace {

// Takes what an encoder writes. OpenImageIO's writers do not report a full disk, so files are made
// in memory and the bytes are written by write_whole().
class ByteSink final : public OIIO::Filesystem::IOProxy {
public:
    ByteSink()
        : IOProxy("", Write) {}

    const char* proxytype() const override { return "bytes"; }
    std::size_t size() const override { return bytes_.size(); }
    std::size_t write(const void* data, std::size_t size) override {
        const std::size_t written = pwrite(data, size, m_pos);
        m_pos += std::int64_t(written);
        return written;
    }
    std::size_t pwrite(const void* data, std::size_t size, std::int64_t offset) override {
        const auto begin = std::size_t(offset);
        if (bytes_.size() < begin + size) bytes_.resize(begin + size);
        std::memcpy(bytes_.data() + begin, data, size);
        return size;
    }

    std::vector<std::byte> take() && { return std::move(bytes_); }

private:
    std::vector<std::byte> bytes_;
};

// One file being encoded, which takes its rows in order from the top.
class Encoder {
public:
    Encoder(const std::string& kind, const OIIO::ImageSpec& spec)
        : output_(OIIO::ImageOutput::create(kind)) {
        if (!output_) throw ImageError("OpenImageIO on this machine cannot write " + kind);
        output_->set_ioproxy(&sink_);
        expect(output_->open("frame." + kind, spec));
    }

    void write_rows(int begin, int end, const OIIO::TypeDesc& type, const void* samples) {
        expect(output_->write_scanlines(begin, end, 0, type, samples));
    }

    std::vector<std::byte> finish() && {
        expect(output_->close());
        output_.reset();
        return std::move(sink_).take();
    }

private:
    void expect(bool done) {
        if (done && !output_->has_error()) return;
        // The frame is not at fault.
        const std::string reason = output_->geterror();
        if (reason.find("bad_alloc") != reason.npos) throw std::bad_alloc();
        throw std::runtime_error("encoding failed: " + reason);
    }

    ByteSink sink_;
    std::unique_ptr<OIIO::ImageOutput> output_; // after the sink, which it writes to until it ends
};

// How many rows are interleaved at a time: enough to compress in parallel, few enough that a 16k
// frame does not need its size in memory again.
constexpr int rows_at_once = 128;

template<class Pack> void write_in_bands(int height, const Pack& pack) {
    for (int begin = 0; begin < height; begin += rows_at_once)
        pack(begin, std::min(begin + rows_at_once, height));
}

std::uint8_t signal(float light, std::uint8_t) { return srgb8().code(light); }
std::uint16_t signal(float light, std::uint16_t) {
    return quantised<std::uint16_t>(srgb_from_linear(std::clamp(light, 0.0f, 1.0f)));
}

template<class Code>
void pack_pixel(const ColourPlanes& planes, std::size_t pixel, std::vector<Code>& out) {
    float scale = 1.0f;
    if (planes.coverage) {
        const float coverage = std::min(planes.coverage[pixel], 1.0f);
        scale = coverage > 0.0f ? 1.0f / coverage : 0.0f;
    }
    for (const float* plane : {planes.red, planes.green, planes.blue})
        out.push_back(signal(scale > 0.0f ? plane[pixel] * scale : 0.0f, Code{}));
    if (planes.coverage) out.push_back(quantised<Code>(planes.coverage[pixel]));
}

template<class Code> std::vector<std::byte> encode_png(const Frame& frame, PixelHash* hash) {
    const ColourPlanes planes = colour_planes(frame);
    const int channels = planes.coverage ? 4 : 3;
    const OIIO::TypeDesc type = OIIO::BaseTypeFromC<Code>::value;

    OIIO::ImageSpec spec(frame.width, frame.height, channels, type);
    add_as_text(spec, frame.metadata);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("oiio:UnassociatedAlpha", 1); // or the writer divides by alpha once more

    Encoder encoder("png", spec);
    std::vector<Code> rows;
    write_in_bands(frame.height, [&](int begin, int end) {
        const auto width = std::size_t(frame.width);
        rows.clear();
        for (std::size_t i = width * std::size_t(begin); i < width * std::size_t(end); ++i)
            pack_pixel(planes, i, rows);
        if (hash) hash->add_codes(std::span<const Code>(rows));
        encoder.write_rows(begin, end, type, rows.data());
    });
    return std::move(encoder).finish();
}

bool is_colour(const std::string& name) {
    return name == "R" || name == "G" || name == "B" || name == "A";
}

// The half that a file keeps for the value.
float to_half(float value) {
    constexpr float largest_half = 65504.0f;
    if (!std::isfinite(value)) return value;
    return Imath::half(std::clamp(value, -largest_half, largest_half));
}

std::vector<std::byte> encode_exr(const Frame& frame, PixelHash* hash) {
    const std::size_t channels = frame.channels.size();
    OIIO::ImageSpec spec(frame.width, frame.height, int(channels), OIIO::TypeFloat);
    spec.channelnames.clear();
    for (std::size_t i = 0; i < channels; ++i) {
        const std::string& name = frame.channels[i].name;
        spec.channelnames.push_back(name);
        spec.channelformats.push_back(is_colour(name) ? OIIO::TypeHalf : OIIO::TypeFloat);
        if (name == "A") spec.alpha_channel = int(i);
        if (name == "Z") spec.z_channel = int(i);
    }
    spec.attribute("DateTime", no_date);
    add_typed(spec, frame.metadata);
    spec.attribute("compression", "zip");
    spec.attribute("oiio:ColorSpace", "Linear");

    Encoder encoder("exr", spec);
    std::vector<float> rows;
    write_in_bands(frame.height, [&](int begin, int end) {
        const std::size_t first = std::size_t(frame.width) * std::size_t(begin);
        const std::size_t count = std::size_t(frame.width) * std::size_t(end - begin);
        rows.resize(count * channels);
        for (std::size_t c = 0; c < channels; ++c) {
            const bool half = is_colour(frame.channels[c].name);
            const float* samples = frame.channels[c].samples.data() + first;
            for (std::size_t i = 0; i < count; ++i)
                rows[i * channels + c] = half ? to_half(samples[i]) : samples[i];
            if (hash) hash->add_channel(frame.channels[c].name, rows, c, channels);
        }
        encoder.write_rows(begin, end, OIIO::TypeFloat, rows.data());
    });
    return std::move(encoder).finish();
}

} // namespace

std::vector<std::byte> encode(const Frame& frame, Format format, PixelHash* hash) {
    switch (format) {
    case Format::png8:
        return encode_png<std::uint8_t>(frame, hash);
    case Format::png16:
        return encode_png<std::uint16_t>(frame, hash);
    case Format::exr:
        return encode_exr(frame, hash);
    }
    throw ImageError("encode: no such format");
}

} // namespace isomotion::image::oiio
