// Probes an OpenGL back end: its driver, its features and its arithmetic.
#pragma once

#include <chrono>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "gpu/context.h"

namespace isomotion::app {

// Probes in this process, which a driver may end. Returns an object with "works"; then "backend",
// "vendor", "renderer", "opengl", "glsl", "limits", "compute" and "arithmetic", otherwise "reason".
nlohmann::ordered_json probe_here(gpu::Backend backend);

// Probes each in a process of its own, all at once. A process that crashes or does not answer in
// time counts as not working; the reason names the signal or the time. Results come in the order
// given.
std::vector<nlohmann::ordered_json> probe_apart(const std::vector<gpu::Backend>& backends,
                                                std::chrono::seconds longest);

} // namespace isomotion::app
