// Makes text of strangers safe for a terminal.
#pragma once

#include <string>
#include <string_view>

namespace isomotion::base {

// The text with U+FFFD for each character that a terminal would interpret instead of showing:
// control characters (escape sequences begin with one), characters that change the direction of
// writing, and bytes that aren't UTF-8. Line ends, without carriage returns, and tabs stay.
std::string printable(std::string_view text);

// The same with U+FFFD also for line ends and tabs, so the result is always one line.
std::string printable_line(std::string_view text);

// True if the text is a single line of printable characters.
bool is_one_printable_line(std::string_view text);

} // namespace isomotion::base
