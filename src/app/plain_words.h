// Handles input of new users that is not a valid command line.
#pragma once

#include <string>
#include <vector>

#include "app/command_tree.h"

namespace isomotion::app {

// The text that `isomotion` prints without arguments.
std::string first_words();

// Converts "help", "help render" and "render help" to the command line that they mean, and puts a
// formula that begins with a minus where it is no option; returns others unchanged. `words` are the
// arguments after the program's name.
std::vector<std::string> understood(std::vector<std::string> words, const CommandTree& tree);

// Why the first word is not a command, and what to write instead; empty if it is a command or an
// option.
std::string why_no_command(const std::vector<std::string>& words, const CommandTree& tree);

// Why a command did not accept these words, and what to write instead.
std::string why_left_over(const std::vector<std::string>& words, const CommandText& command);

} // namespace isomotion::app
