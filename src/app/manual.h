// isomotion(1), written from the command line itself.
#pragma once

#include <string>

#include "app/command_tree.h"

namespace isomotion::app {

// In roff's man macros.
std::string manual_page(const CommandTree& tree, const std::string& version);

} // namespace isomotion::app
