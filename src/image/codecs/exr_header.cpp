#include "exr_header.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/printable.h"
#include "first_look.h"

namespace isomotion::image::oiio {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t most_attributes = 2000; // of all parts together
constexpr std::size_t most_bytes = std::size_t(16) << 20;

constexpr std::array fixed_sizes = {
    std::pair{"box2i"sv, 16u},
    std::pair{"box2f"sv, 16u},
    std::pair{"chromaticities"sv, 32u},
    std::pair{"compression"sv, 1u},
    std::pair{"deepImageState"sv, 1u},
    std::pair{"double"sv, 8u},
    std::pair{"envmap"sv, 1u},
    std::pair{"float"sv, 4u},
    std::pair{"int"sv, 4u},
    std::pair{"keycode"sv, 28u},
    std::pair{"lineOrder"sv, 1u},
    std::pair{"m33f"sv, 36u},
    std::pair{"m33d"sv, 72u},
    std::pair{"m44f"sv, 64u},
    std::pair{"m44d"sv, 128u},
    std::pair{"rational"sv, 8u},
    std::pair{"tiledesc"sv, 9u},
    std::pair{"timecode"sv, 8u},
    std::pair{"v2i"sv, 8u},
    std::pair{"v2f"sv, 8u},
    std::pair{"v2d"sv, 16u},
    std::pair{"v3i"sv, 12u},
    std::pair{"v3f"sv, 12u},
    std::pair{"v3d"sv, 24u},
};

// A part of the file, taken from its beginning.
class Rest {
public:
    explicit Rest(std::span<const std::byte> bytes)
        : bytes_(bytes) {}

    std::size_t size() const { return bytes_.size(); }
    std::span<const std::byte> bytes() const { return bytes_; }
    bool is_at_zero() const { return !bytes_.empty() && bytes_[0] == std::byte{0}; }
    // Only of what is there.
    void skip(std::size_t count) { bytes_ = bytes_.subspan(count); }

    // A name up to its zero; none if it is longer than the format allows.
    std::optional<std::string_view> word() {
        constexpr std::size_t longest = 255;
        const auto text_and_end = bytes_.first(std::min(bytes_.size(), longest + 1));
        const auto end = std::ranges::find(text_and_end, std::byte{0});
        if (end == text_and_end.end()) return std::nullopt;
        const std::string_view text(reinterpret_cast<const char*>(bytes_.data()),
                                    std::size_t(end - text_and_end.begin()));
        skip(text.size() + 1);
        return text;
    }
    std::optional<std::uint32_t> number() {
        if (bytes_.size() < 4) return std::nullopt;
        const std::uint32_t value = little_endian(bytes_, 0);
        skip(4);
        return value;
    }

private:
    std::span<const std::byte> bytes_;
};

// The bytes that a reader takes for a value of this type, whatever size is stated.
std::uint64_t size_of(std::string_view type, std::span<const std::byte> value,
                      std::uint64_t stated) {
    const auto fixed =
        std::ranges::find(fixed_sizes, type, [](const auto& row) { return row.first; });
    if (fixed != fixed_sizes.end()) return fixed->second;
    if (type == "preview" && value.size() >= 8)
        return 8 + std::uint64_t(4) * little_endian(value, 0) * little_endian(value, 4);
    if (type == "chlist") {
        constexpr std::size_t of_channel = 16; // behind its name
        Rest rest(value);
        while (!rest.is_at_zero()) {
            if (!rest.word() || rest.size() < of_channel) return 0;
            rest.skip(of_channel);
        }
        return value.size() - rest.size() + 1;
    }
    return stated;
}

} // namespace

std::string fault_of_exr_headers(std::span<const std::byte> exr) {
    constexpr std::uint32_t has_parts = 0x1000;
    Rest rest(exr);
    rest.number(); // the signature
    const auto version = rest.number();
    const std::string broken = "not a whole picture: its header is broken or cut short";
    if (!version) return broken;
    const std::size_t begin = rest.size();
    for (std::size_t count = 0; !rest.is_at_zero(); ++count) {
        if (count == most_attributes)
            return fmt::format(
                "more than {} attributes in its header, which is the most that is read",
                most_attributes);
        const auto name = rest.word(), type = rest.word();
        const auto size = rest.number();
        if (!name || !type || !size) return broken;
        const std::string what = fmt::format("not a whole picture: its header's attribute '{}'",
                                             base::printable_line(std::string(*name)));
        if (*size > rest.size())
            return fmt::format("{} says {} bytes, and the file has {} more", what, *size,
                               rest.size());
        if (size_of(*type, rest.bytes().first(*size), *size) != *size)
            return fmt::format("{} says {} bytes, which is no size of its type", what, *size);
        rest.skip(*size);
        if (begin - rest.size() > most_bytes)
            return fmt::format("a header of more than {} MB, which is the most that is read",
                               most_bytes >> 20);
        // A zero ends a part's header; behind the last part's there is another.
        if (rest.is_at_zero() && (*version & has_parts)) rest.skip(1);
    }
    return {};
}

} // namespace isomotion::image::oiio
