// Reads a binary file from front to back, never beyond its end.
#pragma once

#include <algorithm>
#include <bit>
#include <cstring>
#include <string_view>

#include <fmt/format.h>

#include "scene/particles/particle_table.h"

namespace isomotion::scene {

class ByteCursor {
public:
    ByteCursor(const ParticleRequest& request, std::string_view bytes, bool big_endian)
        : request_(request)
        , bytes_(bytes)
        , swaps_(big_endian != (std::endian::native == std::endian::big)) {}

    // `what` describes the bytes in messages.
    std::string_view take(std::size_t count, std::string_view what) {
        if (count > left()) {
            fail(fmt::format("the file ends in {}: it has {} bytes, of {} more that belong here",
                             what, bytes_.size(), count));
        }
        const std::string_view taken = bytes_.substr(at_, count);
        at_ += count;
        return taken;
    }
    template<class T> T number(std::string_view what) {
        char bytes[sizeof(T)];
        std::memcpy(bytes, take(sizeof(T), what).data(), sizeof(T));
        if (swaps_) std::reverse(bytes, bytes + sizeof(T));
        T value;
        std::memcpy(&value, bytes, sizeof(T));
        return value;
    }
    // A count, 0 or more.
    std::size_t count(std::string_view what) {
        const auto value = number<std::int32_t>(what);
        if (value < 0) {
            at_ -= sizeof(value);
            fail(fmt::format("{} is {}, below 0", what, value));
        }
        return std::size_t(value);
    }

    std::size_t at() const { return at_; }
    std::size_t left() const { return bytes_.size() - at_; }
    [[noreturn]] void fail(const std::string& message) const {
        fail_at_byte(request_, at_, message);
    }

private:
    const ParticleRequest& request_;
    std::string_view bytes_;
    bool swaps_;
    std::size_t at_ = 0;
};

} // namespace isomotion::scene
