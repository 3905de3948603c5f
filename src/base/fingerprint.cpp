#include "base/fingerprint.h"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

namespace isomotion::base {

namespace {

constexpr auto prime = (static_cast<unsigned __int128>(0x1000000u) << 64) | 0x13bu;

} // namespace

Fingerprint& Fingerprint::begin(std::uint64_t length) {
    // The length goes in too, so that parts can't run into one another.
    for (int k = 0; k < 8; ++k, length >>= 8) hash_ = (hash_ ^ (length & 0xFF)) * prime;
    return *this;
}

Fingerprint& Fingerprint::append(std::span<const std::byte> piece) {
    for (const std::byte byte : piece) hash_ = (hash_ ^ static_cast<unsigned char>(byte)) * prime;
    return *this;
}

Fingerprint& Fingerprint::add(std::span<const std::byte> bytes) {
    return begin(bytes.size()).append(bytes);
}

Fingerprint& Fingerprint::add_words(std::span<const std::byte> bytes) {
    begin(bytes.size());
    for (; !bytes.empty(); bytes = bytes.subspan(std::min(bytes.size(), sizeof(std::uint64_t)))) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data(), std::min(bytes.size(), sizeof word));
        hash_ = (hash_ ^ word) * prime;
    }
    return *this;
}

Fingerprint& Fingerprint::add(std::string_view text) {
    return add(std::as_bytes(std::span(text.data(), text.size())));
}

std::string Fingerprint::text() const {
    return fmt::format("{:016x}{:016x}", std::uint64_t(hash_ >> 64), std::uint64_t(hash_));
}

} // namespace isomotion::base
