// Opens the context that a command draws with.
#pragma once

#include <memory>
#include <string>

#include "gpu/context.h"

namespace isomotion::app {

// Throws std::invalid_argument for an unknown back end, and gpu::Unavailable. A driver that crashes
// as it is loaded, as Mesa does with GALLIUM_DRIVER=nope, ends the program in words, with exit code
// 3.
std::unique_ptr<gpu::Context> open_context(const std::string& backend);

} // namespace isomotion::app
