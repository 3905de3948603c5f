// Text of others, for a terminal.
#pragma once

#include <string>
#include <string_view>

namespace isomotion::base {

// The text with U+FFFD in place of each character that would not be shown but obeyed: control
// characters (escape sequences begin with one), those that turn the direction of writing, and bytes
// that are no UTF-8. Line ends stay, without a carriage return, and tabs.
std::string printable(std::string_view text);

// The same with U+FFFD for line ends and tabs too: one line, whatever the text.
std::string printable_line(std::string_view text);

// True if the text is one line of such as are shown.
bool is_one_printable_line(std::string_view text);

} // namespace isomotion::base
