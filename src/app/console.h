// What the program says: results on standard output, which must not be lost in silence, and
// messages on standard error, which must never end anything.
#pragma once

#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace isomotion::app {

// Opens what is closed of the descriptors 0, 1 and 2, so that no file of the program's becomes one
// of them and gets what is meant for a person. What is written to an output that was closed fails.
void keep_standard_descriptors();

// The environment's variable that says so to a process whose standard input is held open by the one
// that started it: where that one ends, however it does, this one is asked to end, as by SIGTERM.
inline constexpr const char* ends_with_input = "ISOMOTION_ENDS_WITH_INPUT";
void end_with_input();

// Prints a part of the result. One that cannot be written keeps nothing else from being done:
// finish_output() tells of it in the end.
void write_result(std::string_view text);
template<class... Parts> void print_result(fmt::format_string<Parts...> format, Parts&&... parts) {
    write_result(fmt::format(format, std::forward<Parts>(parts)...));
}

// Writes to standard error as it is: for what moves the cursor and holds no text of others.
void control_terminal(std::string_view text);

// Writes a message to standard error, or drops it where that cannot be written. Nothing in it is
// obeyed by a terminal, whoever wrote the words.
void write_message(std::string_view text);
template<class... Parts> void message(fmt::format_string<Parts...> format, Parts&&... parts) {
    write_message(fmt::format(format, std::forward<Parts>(parts)...));
}

// Whether all that was printed has left the program; tells why not.
bool finish_output();

} // namespace isomotion::app
