// One way to OpenGL, examined: what it is, what it can and what its arithmetic is.
#pragma once

#include <chrono>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "gpu/context.h"

namespace isomotion::app {

// In this process, which a driver may end. An object with "works"; then "backend", "vendor",
// "renderer", "opengl", "glsl", "limits", "compute" and "arithmetic", or else "reason".
nlohmann::ordered_json examine_here(gpu::Backend backend);

// Each in a process of its own, all at once: one that crashes, or has no answer in time, doesn't
// work, and the reason tells the signal or the time. In the order given.
std::vector<nlohmann::ordered_json> examine_apart(const std::vector<gpu::Backend>& backends,
                                                  std::chrono::seconds longest);

} // namespace isomotion::app
