#include "image/codecs.h"

#include <stdexcept>

#include <dlfcn.h>
#include <fmt/format.h>

#include "base/loading.h"
#include "image/decode.h"

namespace isomotion::image {
namespace {

constexpr const char* module_file = "isomotion_codecs.so";

// The entry has the version in its name: a program built against other headers finds none.
//
// The loader finds it by the run path of the program, which CMake gives to those that link this
// library. It is never closed: what it throws and the threads of OpenImageIO live on.
const Codecs* loaded() {
    void* const library = ::dlopen(module_file, RTLD_NOW | RTLD_LOCAL);
    void* const entry = library ? ::dlsym(library, ISOMOTION_CODECS_ENTRY) : nullptr;
    if (!entry) {
        const std::string words = ::dlerror();
        const bool is_missing = words.starts_with(module_file) &&
                                words.find("cannot open shared object file") != words.npos;
        throw std::runtime_error(
            fmt::format("pictures cannot be read or written: {}{}", base::why_not_loaded(words),
                        is_missing ? "; it comes with isomotion, in lib/isomotion" : ""));
    }
    return reinterpret_cast<const Codecs* (*)()>(entry)();
}

} // namespace

const Codecs& codecs() {
    static const Codecs* const functions = loaded();
    return *functions;
}

std::vector<std::byte> encode(const Frame& frame, Format format) {
    check(frame);
    return codecs().encode(frame, format, nullptr);
}

Encoded encode_with_hash(const Frame& frame, Format format) {
    check(frame);
    PixelHash hash(frame.width, frame.height);
    std::vector<std::byte> bytes = codecs().encode(frame, format, &hash);
    return {std::move(bytes), hash.text()};
}

Frame decode(const std::filesystem::path& file) { return codecs().decode(file); }

std::string pixel_hash(const std::filesystem::path& file) { return codecs().pixel_hash(file); }

int read_environment(const std::filesystem::path& file, const EnvironmentSink& sink,
                     const base::Confines& within) {
    return codecs().read_environment(file, sink, within);
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
