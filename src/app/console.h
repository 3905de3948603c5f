// Output of the program: results on standard output, whose loss must be reported, and messages on
// standard error, whose loss must have no effect.
#pragma once

#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace isomotion::app {

// Opens those of the descriptors 0, 1 and 2 that are closed. Otherwise a file that the program
// opens could get such a number and receive text meant for a person. Writing to an output that was
// closed fails.
void keep_standard_descriptors();

// Environment variable for a process whose parent holds its standard input open. When the parent
// ends, in any way, the process is asked to end, as by SIGTERM.
inline constexpr const char* ends_with_input = "ISOMOTION_ENDS_WITH_INPUT";
void end_with_input();

// Prints a part of the result. A failed write doesn't stop the program; finish_output() reports it
// at the end.
void write_result(std::string_view text);
template<class... Parts> void print_result(fmt::format_string<Parts...> format, Parts&&... parts) {
    write_result(fmt::format(format, std::forward<Parts>(parts)...));
}

// Writes to standard error unchanged: for cursor control, never for text of strangers.
void control_terminal(std::string_view text);

// Writes a message to standard error, or drops it if that fails. Control characters in it have no
// effect on a terminal, whoever wrote the text, and long texts are shortened in it.
void write_message(std::string_view text);
template<class... Parts> void message(fmt::format_string<Parts...> format, Parts&&... parts) {
    write_message(fmt::format(format, std::forward<Parts>(parts)...));
}

inline void warn(std::string_view text) { message("warning: {}\n", text); }

// Whether all output has left the program; reports the reason if not.
bool finish_output();

} // namespace isomotion::app
