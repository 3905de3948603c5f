// isomotion(1), generated from the command line.
#pragma once

#include <string>

#include "app/command_tree.h"

namespace isomotion::app {

// The manual page in roff's man macros.
std::string manual_page(const CommandTree& tree, const std::string& version);

} // namespace isomotion::app
