// Opens what a command draws with.
#pragma once

#include <memory>
#include <string>

#include "isomotion/isomotion.h"

namespace isomotion::app {

// Throws std::invalid_argument for an unknown back end.
void check_backend(const std::string& backend);

// Throws as check_backend(), and gpu::Unavailable. A crash before the first picture is drawn ends
// the program in words, with exit code 3: Mesa's drivers crash as they are loaded
// (GALLIUM_DRIVER=nope), and as they compile (without memory).
Device open_device(const std::string& backend);

// Says these words of a crash while it lives.
std::shared_ptr<void> words_on_crash();

} // namespace isomotion::app
