// Quotes words for /bin/sh (POSIX), which reads back the same words: with spaces, quotes, `$`,
// newlines, any bytes that a file's name may hold.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace isomotion::farm {

// Never contains a newline, so that a command stays one line for xargs and similar programs, and a
// script has no CR LF, which sbatch refuses. $nl replaces each newline.
std::string shell_word(std::string_view word);

// The definition of $nl, ending in a space; empty if no word needs it. There is no other way to
// write a newline on one line: $(...) drops newlines at its end.
std::string newline_definition(std::span<const std::string> words);

// The words in one line, each quoted, preceded by the definition that they need.
std::string command_line(std::span<const std::string> words);

} // namespace isomotion::farm
