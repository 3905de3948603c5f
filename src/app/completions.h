// Completions of `isomotion` for bash, zsh and fish, generated from the command line.
#pragma once

#include <string>
#include <vector>

#include "app/command_tree.h"

namespace isomotion::app {

// Scripts for the shells' completion folders. `scenes`: names that an argument `scene` accepts
// besides files.
std::string bash_completion(const CommandTree& tree, const std::vector<std::string>& scenes);
std::string zsh_completion(const CommandTree& tree, const std::vector<std::string>& scenes);
std::string fish_completion(const CommandTree& tree, const std::vector<std::string>& scenes);

} // namespace isomotion::app
