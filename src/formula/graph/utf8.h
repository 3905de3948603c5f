// Characters of UTF-8 text.
#pragma once

namespace isomotion::formula {

// Whether a byte is part of a character that began before it.
constexpr bool continues_character(char c) {
    return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

} // namespace isomotion::formula
