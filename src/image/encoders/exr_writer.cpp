#include "exr_writer.h"

#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <thread>
#include <utility>

#include <Iex.h>
#include <ImfChannelList.h>
#include <ImfDoubleAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfIntAttribute.h>
#include <ImfRationalAttribute.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>
#include <fmt/format.h>

#include "image/encode.h"

namespace isomotion::image::files {
namespace {

// OpenEXR's own failures; the frame is not at fault.
template<class Calls> auto by_openexr(Calls&& calls) {
    try {
        return calls();
    } catch (const Iex::BaseExc& failure) {
        throw std::runtime_error(fmt::format("encoding failed: {}", failure.what()));
    }
}

Imf::Rational ratio_of(const std::string& name, const Rational& ratio) {
    constexpr auto top = std::numeric_limits<int>::max();
    if (ratio.numerator < -top || ratio.numerator > top || ratio.denominator < 1 ||
        ratio.denominator > top)
        throw ImageError(fmt::format("metadata {}: {} is not a ratio of 32-bit integers with a "
                                     "positive denominator",
                                     name, to_text(ratio)));
    return {int(ratio.numerator), int(ratio.denominator)};
}

struct Adder {
    Imf::Header& header;
    const std::string& name;

    void operator()(const std::string& text) const {
        header.insert(name == "DateTime" ? "capDate" : name, Imf::StringAttribute(text));
    }
    void operator()(int number) const { header.insert(name, Imf::IntAttribute(number)); }
    void operator()(double number) const { header.insert(name, Imf::DoubleAttribute(number)); }
    void operator()(const Rational& ratio) const {
        header.insert(name, Imf::RationalAttribute(ratio_of(name, ratio)));
    }
    // OpenEXR has no arrays of doubles.
    void operator()(const std::vector<double>& numbers) const { (*this)(to_text(numbers)); }
};

void add(Imf::Header& header, const Metadata& metadata) {
    for (const Entry& entry : metadata) {
        if (entry.name.empty() || entry.name.size() > longest_name(Format::exr))
            throw ImageError(fmt::format("metadata \"{}\": a name has 1 to {} bytes", entry.name,
                                         longest_name(Format::exr)));
        // `channels`, `compression`, `dataWindow` ...
        if (header.find(entry.name) != header.end())
            throw ImageError(
                fmt::format("metadata {}: OpenEXR has its own value of that name", entry.name));
        std::visit(Adder{header, entry.name}, entry.value);
    }
}

// Blocks of rows are compressed by so many threads.
int threads() {
    static const int count = [] {
        const int cores = int(std::thread::hardware_concurrency());
        if (Imf::globalThreadCount() < cores) Imf::setGlobalThreadCount(cores);
        return cores;
    }();
    return count;
}

} // namespace

class ExrWriter::Bytes final : public Imf::OStream {
public:
    Bytes()
        : OStream("frame.exr") {}

    void write(const char data[], int size) override {
        const std::size_t end = at_ + std::size_t(size);
        if (bytes.size() < end) bytes.resize(end);
        std::memcpy(bytes.data() + at_, data, std::size_t(size));
        at_ = end;
    }
    std::uint64_t tellp() override { return at_; }
    void seekp(std::uint64_t to) override { at_ = to; }

    std::vector<std::byte> bytes;

private:
    std::size_t at_ = 0;
};

ExrWriter::ExrWriter(int width, int height, std::vector<ExrChannel> channels,
                     const Metadata& metadata)
    : width_(width)
    , channels_(std::move(channels))
    , bytes_(std::make_unique<Bytes>()) {
    by_openexr([&] {
        Imf::Header header(width, height);
        header.compression() = Imf::ZIP_COMPRESSION;
        for (const ExrChannel& channel : channels_)
            header.channels().insert(channel.name,
                                     Imf::Channel(channel.is_half ? Imf::HALF : Imf::FLOAT));
        add(header, metadata);
        file_ = std::make_unique<Imf::OutputFile>(*bytes_, header, threads());
    });
}

ExrWriter::~ExrWriter() = default;

void ExrWriter::write_rows(int begin, int end, std::span<const ExrSamples> samples) {
    by_openexr([&] {
        const auto width = std::size_t(width_);
        Imf::FrameBuffer rows;
        for (std::size_t c = 0; c < channels_.size(); ++c) {
            const bool half = channels_[c].is_half;
            const std::size_t bytes = half ? sizeof(Imath::half) : sizeof(float);
            const void* first = half ? static_cast<const void*>(samples[c].halves.data())
                                     : static_cast<const void*>(samples[c].floats.data());
            // A slice is addressed from row 0 on, and only read.
            char* const base = reinterpret_cast<char*>(reinterpret_cast<std::uintptr_t>(first) -
                                                       std::size_t(begin) * width * bytes);
            rows.insert(channels_[c].name,
                        Imf::Slice(half ? Imf::HALF : Imf::FLOAT, base, bytes, width * bytes));
        }
        file_->setFrameBuffer(rows);
        file_->writePixels(end - begin);
    });
}

std::vector<std::byte> ExrWriter::finish() && {
    file_.reset();
    return std::move(bytes_->bytes);
}

} // namespace isomotion::image::files
