#include "image/codecs.h"

#include <fmt/format.h>

#include "image/decode.h"
#include "image/encoders.h"
#include "image/module.h"

namespace isomotion::image {

const Codecs& codecs() {
    static const auto& functions =
        module_functions<Codecs>("isomotion_codecs.so", ISOMOTION_CODECS_ENTRY);
    return functions;
}

const Encoders& encoders() {
    static const auto& functions =
        module_functions<Encoders>("isomotion_encoders.so", ISOMOTION_ENCODERS_ENTRY);
    return functions;
}

std::vector<std::byte> encode(const Frame& frame, Format format) {
    check(frame);
    return encoders().encode(frame, format, nullptr);
}

Encoded encode_with_hash(const Frame& frame, Format format) {
    check(frame);
    PixelHash hash(frame.width, frame.height);
    std::vector<std::byte> bytes = encoders().encode(frame, format, &hash);
    return {std::move(bytes), hash.text()};
}

Frame decode(const std::filesystem::path& file) { return codecs().decode(file); }

std::string pixel_hash(const std::filesystem::path& file) { return codecs().pixel_hash(file); }

int read_environment(const std::filesystem::path& file, const EnvironmentSink& sink,
                     const base::Confines& within, std::string_view stated_at) {
    try {
        return codecs().read_environment(file, sink, within);
    } catch (const ImageError& error) {
        if (stated_at.empty()) throw;
        throw ImageError(fmt::format("{}: {}", stated_at, error.what()));
    }
}

EnvironmentMap read_environment(const std::filesystem::path& file) {
    EnvironmentMap map;
    EnvironmentSink sink;
    sink.begin = [&](int width, int height) {
        map.width = width;
        map.height = height;
        map.texels.reserve(4 * std::size_t(width) * std::size_t(height));
    };
    sink.rows = [&](int, std::span<const float> texels) {
        map.texels.insert(map.texels.end(), texels.begin(), texels.end());
    };
    map.mended = read_environment(file, sink, {});
    return map;
}

} // namespace isomotion::image
