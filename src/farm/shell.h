// Words as text for /bin/sh (POSIX), which reads back the same words: spaces, quotes, `$`,
// newlines, whatever bytes a file's name may hold.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace isomotion::farm {

// Never holds a newline, so that a command stays one line for xargs and the like, and a script has
// no CR LF, which sbatch refuses. In place of it stands $nl.
std::string shell_word(std::string_view word);

// What gives $nl its value, ending in a space; empty if no word needs it. A newline is not to be
// had in one line otherwise: $(...) drops those at its end.
std::string newline_definition(std::span<const std::string> words);

// The words in one line, each quoted; with the definition they need in front.
std::string command_line(std::span<const std::string> words);

} // namespace isomotion::farm
