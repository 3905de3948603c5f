// A 128-bit fingerprint of bytes.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace isomotion::base {

// FNV-1a with 128 bits: it doesn't resist an adversary, but a stale frame is not one.
class Fingerprint {
public:
    Fingerprint& add(std::span<const std::byte> bytes);
    Fingerprint& add(std::string_view text);
    template<class T> Fingerprint& add_values(std::span<const T> values) {
        return add(std::as_bytes(values));
    }
    // Adds eight bytes per step, for large data. The result differs from that of add().
    Fingerprint& add_words(std::span<const std::byte> bytes);
    // Adds a part in pieces: first its total number of bytes, then the pieces.
    Fingerprint& begin(std::uint64_t length);
    Fingerprint& append(std::span<const std::byte> piece);
    std::string text() const; // 32 hexadecimal digits

private:
    unsigned __int128 hash_ =
        (static_cast<unsigned __int128>(0x6c62272e07bb0142u) << 64) | 0x62b821756295c58du;
};

} // namespace isomotion::base
