#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

struct XXH3_state_s;

namespace isomotion::base {

/// Detects changes of bytes: XXH3 with 128 bits, at the speed of memory. It detects accidents, but
/// not somebody who constructs two files with one hash.
class ContentHash {
public:
    ContentHash();

    ContentHash& add(std::span<const std::byte> bytes);
    /// Includes the length, so that adjacent texts can't run into each other.
    ContentHash& add(std::string_view text);
    template<class T> ContentHash& add_values(std::span<const T> values) {
        return add(std::as_bytes(values));
    }

    /// The hash of everything added so far: 32 hexadecimal digits as the program xxh128sum prints
    /// them.
    std::string text() const;

private:
    struct Free {
        void operator()(XXH3_state_s* state) const;
    };
    std::unique_ptr<XXH3_state_s, Free> state_;
};

std::string content_hash(std::span<const std::byte> bytes);

} // namespace isomotion::base
