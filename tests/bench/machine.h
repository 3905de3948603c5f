// Who measured, and when: what every table of times begins with.
#pragma once

#include <string>

#include "gpu/context.h"

namespace isomotion::bench {

// "Intel(R) Xeon(R) (2 threads), llvmpipe (LLVM 15.0.6, 256 bits) 4.5 (Core Profile) ..."
std::string machine(const gpu::ContextInfo& info);

std::string today(); // 2026-01-31, UTC

} // namespace isomotion::bench
