#include "scene/particles/vtu_data.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>

#include <fmt/format.h>
#include <zlib.h>

namespace isomotion::scene {
namespace {

constexpr std::uint8_t no_digit = 255;

constexpr std::array<std::uint8_t, 256> digits_of_base64 = [] {
    std::array<std::uint8_t, 256> digits{};
    digits.fill(no_digit);
    constexpr std::string_view all =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t k = 0; k < all.size(); ++k)
        digits[static_cast<unsigned char>(all[k])] = std::uint8_t(k);
    return digits;
}();

// Bytes one after the other, written as they are or in base 64. There a group that is filled up
// with = ends one part, a header, and the next begins.
class Coded {
public:
    Coded(const ParticleRequest& request, std::string_view text, std::size_t at, bool is_base64)
        : request_(request)
        , text_(text)
        , at_(at)
        , is_base64_(is_base64) {}

    // Whether so many bytes may follow.
    std::size_t left() const { return text_.size() - std::min(at_, text_.size()); }

    std::string take(std::size_t count) {
        std::string bytes;
        if (count > left() + 3) ends(count);
        bytes.reserve(count + 3);
        if (!is_base64_) {
            if (count > left()) ends(count);
            bytes = text_.substr(at_, count);
            at_ += count;
            return bytes;
        }
        bytes = std::move(over_);
        over_.clear();
        while (bytes.size() < count) group(bytes, count);
        over_ = bytes.substr(count);
        bytes.resize(count);
        return bytes;
    }

    [[noreturn]] void fail(const std::string& message) const {
        fail_at_byte(request_, at_, message);
    }

private:
    [[noreturn]] void ends(std::size_t count) const {
        fail(fmt::format("the array ends before the {} bytes that belong here", count));
    }

    void group(std::string& bytes, std::size_t count) {
        std::uint32_t four = 0;
        int digits = 0, filled = 0;
        for (; digits + filled < 4; ++at_) {
            if (at_ >= text_.size()) ends(count);
            const char c = text_[at_];
            if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
            if (c == '=' && digits >= 2) {
                ++filled;
                four <<= 6;
                continue;
            }
            const std::uint8_t digit = digits_of_base64[static_cast<unsigned char>(c)];
            if (digit == no_digit || filled > 0) {
                if (c == '<') ends(count);
                fail("is no base 64");
            }
            four = four << 6 | digit;
            ++digits;
        }
        for (int k = 0; k < 3 - filled; ++k) bytes += char(four >> (16 - 8 * k) & 255);
    }

    const ParticleRequest& request_;
    std::string_view text_;
    std::size_t at_;
    bool is_base64_;
    std::string over_; // decoded, not yet taken
};

std::vector<std::uint64_t> headers(Coded& coded, const VtuCoding& coding, std::size_t count) {
    const std::size_t size = coding.has_long_headers ? 8 : 4;
    const std::string bytes = coded.take(count * size);
    const bool swaps = coding.big_endian != (std::endian::native == std::endian::big);
    std::vector<std::uint64_t> values;
    values.reserve(count);
    for (std::size_t k = 0; k < count; ++k) {
        char one[8];
        std::memcpy(one, bytes.data() + k * size, size);
        if (swaps) std::reverse(one, one + size);
        std::uint64_t value = 0;
        if (size == 8) {
            std::memcpy(&value, one, 8);
        } else {
            std::uint32_t four = 0;
            std::memcpy(&four, one, 4);
            value = four;
        }
        values.push_back(value);
    }
    return values;
}

std::string unpacked(Coded& coded, const VtuCoding& coding, std::size_t size) {
    const auto first = headers(coded, coding, 3);
    const std::uint64_t blocks = first[0], each = first[1], last = first[2];
    constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
    if (blocks > size || each > most || last > each)
        coded.fail("the header of the blocks is wrong");
    const std::uint64_t all = blocks == 0 ? 0 : (blocks - 1) * each + (last > 0 ? last : each);
    if (all != size) {
        coded.fail(
            fmt::format("the blocks say that they hold {} bytes; {} belong here", all, size));
    }
    if (blocks > coded.left()) coded.fail("has more blocks than bytes");
    const auto packed = headers(coded, coding, std::size_t(blocks));
    std::string bytes(size, '\0');
    for (std::size_t k = 0, at = 0; k < blocks; ++k) {
        const std::size_t here = std::min(std::size_t(each), size - at);
        const std::string block = coded.take(std::size_t(packed[k]));
        uLongf length = here;
        const int result = ::uncompress(reinterpret_cast<Bytef*>(bytes.data() + at), &length,
                                        reinterpret_cast<const Bytef*>(block.data()), block.size());
        if (result != Z_OK || length != here)
            coded.fail(fmt::format("block {} is not what zlib packed {} bytes into", k + 1, here));
        at += here;
    }
    return bytes;
}

} // namespace

std::string vtu_data(const ParticleRequest& request, std::string_view text, std::size_t at,
                     const VtuCoding& coding, std::size_t size) {
    Coded coded(request, text, at, coding.is_base64);
    if (coding.is_packed) return unpacked(coded, coding, size);
    if (const std::uint64_t said = headers(coded, coding, 1)[0]; said != size)
        coded.fail(fmt::format("the array says that it has {} bytes; {} belong here", said, size));
    return coded.take(size);
}

} // namespace isomotion::scene
