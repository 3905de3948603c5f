#include "scene/particles/gunzip.h"

#include <algorithm>

#include <fmt/format.h>
#include <zlib.h>

namespace isomotion::scene {
namespace {

// Ends with its scope.
struct Inflater {
    z_stream stream{};

    Inflater() { ready = ::inflateInit2(&stream, 15 + 16) == Z_OK; }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;
    ~Inflater() {
        if (ready) ::inflateEnd(&stream);
    }

    bool ready = false;
};

} // namespace

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

std::string gunzip(const ParticleRequest& request, std::string_view packed, std::size_t most) {
    Inflater inflater;
    if (!inflater.ready) fail_of_file(request, "cannot be unpacked: zlib has no memory");
    z_stream& stream = inflater.stream;
    // zlib's interface takes no constant bytes, and writes none of them; its lengths have 32 bits.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    std::size_t given = 0;
    std::string bytes;
    for (;;) {
        if (stream.avail_in == 0) {
            constexpr std::size_t piece = 1 << 30;
            stream.avail_in = uInt(std::min(piece, packed.size() - given));
            given += stream.avail_in;
        }
        const std::size_t before = bytes.size();
        const std::size_t room =
            std::min(most + 1 - before, std::max<std::size_t>(before, 1 << 16));
        bytes.resize(before + room);
        stream.next_out = reinterpret_cast<Bytef*>(bytes.data() + before);
        stream.avail_out = uInt(std::min<std::size_t>(room, 1 << 30));
        const uInt out = stream.avail_out;
        const int result = ::inflate(&stream, Z_NO_FLUSH);
        bytes.resize(before + (out - stream.avail_out));
        const std::size_t at = given - stream.avail_in;
        if (bytes.size() > most) {
            bytes.resize(most);
            if (request.count_alone) return bytes;
            fail_of_file(request, fmt::format("holds more than {} bytes once it is unpacked; there "
                                              "may be so many left of all tables of a scene",
                                              most));
        }
        if (result == Z_STREAM_END) {
            if (!is_gzip(packed.substr(at))) return bytes; // zeros may follow
            if (::inflateReset(&stream) != Z_OK) fail_at_byte(request, at, "cannot be unpacked");
            continue;
        }
        const bool ends = at == packed.size() && stream.avail_out > 0;
        if (request.count_alone && ends) return bytes;
        if (ends) fail_at_byte(request, at, "the packed data end too early");
        if (result != Z_OK && result != Z_BUF_ERROR)
            fail_at_byte(request, at, "the packed data are damaged");
    }
}

} // namespace isomotion::scene
