// 128 bits that change when the bytes they were taken from do.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace isomotion::base {

// FNV-1a on 128 bits: no defence against an adversary, but a stale frame is none.
class Fingerprint {
public:
    Fingerprint& add(std::span<const std::byte> bytes);
    Fingerprint& add(std::string_view text);
    template<class T> Fingerprint& add_values(std::span<const T> values) {
        return add(std::as_bytes(values));
    }
    // Eight bytes at a step, for much data: another text than add() gives.
    Fingerprint& add_words(std::span<const std::byte> bytes);
    // A part that comes in pieces: how many bytes it has, then all of them.
    Fingerprint& begin(std::uint64_t length);
    Fingerprint& append(std::span<const std::byte> piece);
    std::string text() const; // 32 hexadecimal digits

private:
    unsigned __int128 hash_ =
        (static_cast<unsigned __int128>(0x6c62272e07bb0142u) << 64) | 0x62b821756295c58du;
};

} // namespace isomotion::base
