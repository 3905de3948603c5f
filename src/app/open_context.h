// Opens what a command draws with.
#pragma once

#include <memory>
#include <string>

#include "gpu/context.h"
#include "isomotion/isomotion.h"

namespace isomotion::app {

// Throws std::invalid_argument for an unknown back end, and gpu::Unavailable. A crash before the
// first picture is drawn ends the program in words, with exit code 3: Mesa's drivers crash as they
// are loaded (GALLIUM_DRIVER=nope), and as they compile (without memory).
std::unique_ptr<gpu::Context> open_context(const std::string& backend);

// The same, as a device of the public header.
Device open_device(const std::string& backend);

// Says these words of a crash while it lives.
std::shared_ptr<void> words_on_crash();

} // namespace isomotion::app
