#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

struct XXH3_state_s;

namespace isomotion::base {

/// Tells whether bytes are what they were: XXH3 with 128 bits, at the speed of memory. It holds
/// against accidents, not against somebody who wants two files to have one hash.
class ContentHash {
public:
    ContentHash();

    ContentHash& add(std::span<const std::byte> bytes);
    /// With its length, so that neighbouring texts do not run into one another.
    ContentHash& add(std::string_view text);
    template<class T> ContentHash& add_values(std::span<const T> values) {
        return add(std::as_bytes(values));
    }

    /// Of what was added so far, 32 hexadecimal digits as the program xxh128sum prints them.
    std::string text() const;

private:
    struct Free {
        void operator()(XXH3_state_s* state) const;
    };
    std::unique_ptr<XXH3_state_s, Free> state_;
};

std::string content_hash(std::span<const std::byte> bytes);

} // namespace isomotion::base
