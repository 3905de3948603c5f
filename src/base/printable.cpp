#include "base/printable.h"

#include <cstdint>

namespace isomotion::base {
namespace {

struct Character {
    std::size_t bytes = 1;
    std::uint32_t code = 0;
    bool is_valid = false;
};

// The first character of UTF-8; of what is none, the first byte.
Character first_character(std::string_view text) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
    const unsigned lead = byte(0);
    if (lead < 0x80) return {1, lead, true};
    const std::size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() < bytes) return {};
    std::uint32_t code = lead & (0x7Fu >> bytes);
    for (std::size_t k = 1; k < bytes; ++k) {
        if ((byte(k) & 0xC0u) != 0x80u) return {};
        code = code << 6 | (byte(k) & 0x3Fu);
    }
    constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool is_surrogate = 0xD800 <= code && code <= 0xDFFF;
    if (code < least[bytes] || code > 0x10FFFF || is_surrogate) return {};
    return {bytes, code, true};
}

bool is_shown(const Character& character) {
    const std::uint32_t c = character.code;
    const bool is_control = c < 0x20 || (0x7F <= c && c < 0xA0) || c == 0x2028 || c == 0x2029;
    const bool turns = c == 0x61C || c == 0x200E || c == 0x200F || (0x202A <= c && c <= 0x202E) ||
                       (0x2066 <= c && c <= 0x2069);
    return character.is_valid && !is_control && !turns;
}

std::string shown(std::string_view text, bool keeps_lines) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const Character character = first_character(text);
        const std::string_view bytes = text.substr(0, character.bytes);
        const bool ends = bytes == "\n" || bytes == "\t";
        if (keeps_lines && text.starts_with("\r\n")) { // the line end alone
        } else if ((keeps_lines && ends) || is_shown(character)) {
            result += bytes;
        } else {
            result += "\xEF\xBF\xBD";
        }
        text.remove_prefix(character.bytes);
    }
    return result;
}

} // namespace

std::string printable(std::string_view text) { return shown(text, true); }
std::string printable_line(std::string_view text) { return shown(text, false); }

bool is_one_printable_line(std::string_view text) {
    while (!text.empty()) {
        const Character character = first_character(text);
        if (!is_shown(character)) return false;
        text.remove_prefix(character.bytes);
    }
    return true;
}

} // namespace isomotion::base
