// Keeps messages short, however long the texts of strangers are that they repeat.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace isomotion::base {

// The longest part of a stranger's text that a message repeats, in bytes.
inline constexpr std::size_t most_repeated = 200;

// The text, or its beginning and its end about "..." where it has more than `most` bytes. No
// character of UTF-8 is cut.
std::string shortened(std::string_view text, std::size_t most = most_repeated);

// printable() for a message, of which each line tells something whatever it repeats: what stands in
// quotes is shortened, and so is a line that is long all the same.
std::string printable_message(std::string_view text);

} // namespace isomotion::base
