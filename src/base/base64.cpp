#include "base/base64.h"

namespace isomotion::base {

std::string base64(std::span<const std::byte> bytes) {
    constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t k = 0; k < bytes.size(); k += 3) {
        unsigned word = 0;
        for (std::size_t j = 0; j < 3; ++j) {
            word = word << 8 | (k + j < bytes.size() ? unsigned(bytes[k + j]) : 0);
        }
        for (std::size_t j = 0; j < 4; ++j) {
            text += k + j > bytes.size() ? '=' : digits[word >> (18 - 6 * j) & 63];
        }
    }
    return text;
}

} // namespace isomotion::base
