// What a new user types that is no command line yet.
#pragma once

#include <string>
#include <vector>

#include "app/command_tree.h"

namespace isomotion::app {

// What `isomotion` alone says.
std::string first_words();

// The command line that is meant by "help", "help render" and "render help"; others stay as they
// are. Words are those after the program's name.
std::vector<std::string> understood(std::vector<std::string> words, const CommandTree& tree);

// Why the first word is no command, and what to write instead; empty where it is one, or an option.
std::string why_no_command(const std::vector<std::string>& words, const CommandTree& tree);

// Why these words were left over by a command, and what to write instead.
std::string why_left_over(const std::vector<std::string>& words, const CommandText& command);

} // namespace isomotion::app
