// What bash, zsh and fish complete after `isomotion`, written from the command line itself.
#pragma once

#include <string>
#include <vector>

#include "app/command_tree.h"

namespace isomotion::app {

// Scripts for the shells' completion folders. `scenes` are the names that an argument `scene` may
// be besides a file.
std::string bash_completion(const CommandTree& tree, const std::vector<std::string>& scenes);
std::string zsh_completion(const CommandTree& tree, const std::vector<std::string>& scenes);
std::string fish_completion(const CommandTree& tree, const std::vector<std::string>& scenes);

} // namespace isomotion::app
