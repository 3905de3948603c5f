#include "png_writer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdio>
#include <new>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "image/encode.h"

namespace isomotion::image::files {
namespace {

// PNG's words for what other formats call otherwise.
constexpr std::array<std::pair<const char*, const char*>, 3> keywords{
    {{"Artist", "Author"}, {"DocumentName", "Title"}, {"ImageDescription", "Description"}}};

std::string keyword(const std::string& name) {
    if (name.empty() || name.size() > longest_name(Format::png8))
        throw ImageError(fmt::format("metadata \"{}\": a name has 1 to {} bytes", name,
                                     longest_name(Format::png8)));
    for (const auto& [other, ours] : keywords)
        if (name == other) return ours;
    return name;
}

// The moment of `2026:01:31 12:00:00`.
std::optional<png_time> moment(const std::string& text) {
    int year = 0, month = 0, day = 0, hour = 0, minute = 0, second = 0;
    if (std::sscanf(text.c_str(), "%4d:%2d:%2d %2d:%2d:%2d", &year, &month, &day, &hour, &minute,
                    &second) != 6)
        return std::nullopt;
    return png_time{png_uint_16(year), png_byte(month),  png_byte(day),
                    png_byte(hour),    png_byte(minute), png_byte(second)};
}

struct Words {
    std::string keyword, text;
};

} // namespace

void PngWriter::take(png_structp png, png_bytep data, std::size_t size) {
    auto& self = *static_cast<PngWriter*>(png_get_io_ptr(png));
    bool done = true;
    try {
        const auto* first = reinterpret_cast<const std::byte*>(data);
        self.bytes_.insert(self.bytes_.end(), first, first + size);
    } catch (...) { // there is no memory for more
        done = false;
    }
    if (done) return;
    self.out_of_memory_ = true;
    png_error(png, "there is no memory");
}

void PngWriter::fail(png_structp png, const char* reason) {
    auto& self = *static_cast<PngWriter*>(png_get_error_ptr(png));
    std::snprintf(self.reason_, sizeof self.reason_, "%s", reason); // may lie on libpng's stack
    png_longjmp(png, 1);
}

template<class Calls> void PngWriter::by_libpng(Calls&& calls) {
    if (setjmp(png_jmpbuf(png_)) == 0) {
        calls();
        return;
    }
    if (out_of_memory_ || std::string(reason_) == "Out of memory") throw std::bad_alloc();
    throw std::runtime_error(fmt::format("encoding failed: {}", reason_));
}

PngWriter::PngWriter()
    : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, this, fail, nullptr))
    , info_(png_ ? png_create_info_struct(png_) : nullptr) {
    if (info_) return;
    png_destroy_write_struct(&png_, nullptr);
    throw std::bad_alloc();
}

PngWriter::PngWriter(int width, int height, bool has_alpha, int bits, const Metadata& metadata)
    : PngWriter() {
    std::vector<Words> words;
    std::optional<png_time> time;
    for (const Entry& entry : metadata) {
        Words now{keyword(entry.name), to_text(entry.value)};
        if (now.keyword == "DateTime") time = moment(now.text);
        if (now.keyword != "DateTime" || !time) words.push_back(std::move(now));
    }
    std::vector<png_text> texts;
    texts.reserve(words.size());
    for (Words& now : words) {
        png_text text{};
        // Texts are in Latin-1, save those that say that they are in UTF-8.
        const bool is_ascii =
            std::ranges::all_of(now.text, [](unsigned char c) { return c < 128; });
        text.compression = is_ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
        text.key = now.keyword.data();
        text.text = now.text.data();
        (is_ascii ? text.text_length : text.itxt_length) = now.text.size();
        texts.push_back(text);
    }
    by_libpng([&] {
        png_set_write_fn(png_, this, take, nullptr);
        png_set_IHDR(png_, info_, png_uint_32(width), png_uint_32(height), bits,
                     has_alpha ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                     PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_set_sRGB_gAMA_and_cHRM(png_, info_, PNG_sRGB_INTENT_ABSOLUTE);
        // Rendered frames have flat backgrounds: filters take time and save little.
        png_set_filter(png_, PNG_FILTER_TYPE_BASE, PNG_NO_FILTERS);
        png_set_compression_level(png_, 6);
        if (time) png_set_tIME(png_, info_, &*time);
        png_set_text(png_, info_, texts.data(), int(texts.size()));
        png_write_info(png_, info_);
        if (bits == 16 && std::endian::native == std::endian::little) png_set_swap(png_);
    });
}

PngWriter::~PngWriter() { png_destroy_write_struct(&png_, &info_); }

void PngWriter::write_rows(const void* samples, std::size_t bytes, int rows) {
    by_libpng([&] {
        for (int row = 0; row < rows; ++row)
            png_write_row(png_, static_cast<png_const_bytep>(samples) +
                                    std::size_t(row) * (bytes / std::size_t(rows)));
    });
}

std::vector<std::byte> PngWriter::finish() && {
    by_libpng([&] { png_write_end(png_, nullptr); });
    return std::move(bytes_);
}

} // namespace isomotion::image::files
