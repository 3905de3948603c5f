#include "first_look.h"

#include <algorithm>
#include <string_view>

namespace isomotion::image::oiio {
namespace {

using namespace std::string_view_literals;

// Calls take(bytes from its value on) for all attributes of that name and type. They are looked for
// in all of the file: where a header ends is for its reader to say.
template<class Take>
void for_each_attribute(std::span<const std::byte> exr, std::string_view name_and_type,
                        Take&& take) {
    const std::string_view text(reinterpret_cast<const char*>(exr.data()), exr.size());
    for (std::size_t at = text.find(name_and_type); at != text.npos;
         at = text.find(name_and_type, at + 1)) {
        constexpr std::size_t length = 4; // of the value, which readers do not go by
        const std::size_t value = at + name_and_type.size() + length;
        if (value <= exr.size()) take(exr.subspan(value));
    }
}

std::int64_t count_channels(std::span<const std::byte> list) {
    constexpr std::size_t size = 16; // of what is said of one, behind its name
    std::int64_t count = 0;
    while (!list.empty() && list[0] != std::byte{0}) {
        const auto name = std::size_t(std::ranges::find(list, std::byte{0}) - list.begin());
        if (list.size() - name < 1 + size) break;
        list = list.subspan(name + 1 + size);
        ++count;
    }
    return count;
}

// Calls take(type) for each whole chunk of a PNG, as long as it returns true.
template<class Take> void for_each_chunk(std::span<const std::byte> png, Take&& take) {
    constexpr std::size_t signature = 8, overhead = 12; // length, type and checksum of a chunk
    std::size_t at = signature;
    while (at + overhead <= png.size()) {
        std::size_t length = 0;
        for (const std::byte digit : png.subspan(at, 4)) length = length << 8 | std::size_t(digit);
        if (length > png.size() - at - overhead) return;
        if (!take(std::string_view(reinterpret_cast<const char*>(&png[at + 4]), 4))) return;
        at += length + overhead;
    }
}

} // namespace

std::uint32_t little_endian(std::span<const std::byte> bytes, std::size_t at) {
    std::uint32_t number = 0;
    for (std::size_t k = 4; k-- > 0;) number = number << 8 | std::uint32_t(bytes[at + k]);
    return number;
}

bool has_end_chunk(std::span<const std::byte> png) {
    bool has_end = false;
    for_each_chunk(png, [&](std::string_view type) { return !(has_end = type == "IEND"sv); });
    return has_end;
}

std::size_t count_packed_chunks(std::span<const std::byte> png) {
    std::size_t count = 0;
    for_each_chunk(png, [&](std::string_view type) {
        count += type == "zTXt"sv || type == "iTXt"sv || type == "iCCP"sv;
        return type != "IEND"sv;
    });
    return count;
}

int count_scans(std::span<const std::byte> jpeg) {
    const auto byte = [&](std::size_t at) { return std::to_integer<unsigned>(jpeg[at]); };
    int scans = 0;
    for (std::size_t at = 2; at + 1 < jpeg.size();) {
        const unsigned marker = byte(at + 1);
        if (byte(at) != 0xFF || marker == 0 || marker == 0xFF) { // codes of pixels
            ++at;
            continue;
        }
        if (marker == 0xD9) break; // the end of the picture
        scans += marker == 0xDA;
        at += 2;
        const bool is_alone = marker == 0x01 || (0xD0 <= marker && marker <= 0xD8);
        if (is_alone || at + 1 >= jpeg.size()) continue;
        at += std::max(byte(at) << 8 | byte(at + 1), 2u); // the marker's segment
    }
    return scans;
}

ExrSizes exr_sizes(std::span<const std::byte> exr) {
    ExrSizes sizes;
    const auto enlarge = [](std::int64_t& size, std::int64_t found) {
        size = std::max(size, found);
    };
    for_each_attribute(exr, "dataWindow\0box2i\0"sv, [&](std::span<const std::byte> box) {
        if (box.size() < 16) return;
        const auto number = [&](std::size_t k) {
            return std::int64_t(std::int32_t(little_endian(box, 4 * k)));
        };
        enlarge(sizes.width, number(2) - number(0) + 1);
        enlarge(sizes.height, number(3) - number(1) + 1);
    });
    for_each_attribute(exr, "tiles\0tiledesc\0"sv, [&](std::span<const std::byte> tiles) {
        if (tiles.size() < 8) return;
        enlarge(sizes.tile_width, little_endian(tiles, 0));
        enlarge(sizes.tile_height, little_endian(tiles, 4));
    });
    for_each_attribute(exr, "channels\0chlist\0"sv, [&](std::span<const std::byte> list) {
        enlarge(sizes.channels, count_channels(list));
    });
    return sizes;
}

} // namespace isomotion::image::oiio
