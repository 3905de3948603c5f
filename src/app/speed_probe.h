// Measures a machine's drawing speed, to tell users what to expect.
#pragma once

#include <chrono>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "gpu/context.h"

namespace isomotion::app {

// Draws a few frames of an animation of the gallery in this process. Returns "scene", "size"
// (pixels of both sides) and "frame_ms" (milliseconds per frame, from upload to read-back), or
// "reason".
nlohmann::ordered_json measure_speed_here(gpu::Backend backend);

// The same in a process of its own, with a time limit.
nlohmann::ordered_json measure_speed_apart(gpu::Backend backend, std::chrono::seconds longest);

// One sentence from doctor's report: "software renderer, 2 cores: blobby75 renders 15 frames a
// second at 256x256, and plays at about 180 pixels". Empty if nothing was measured.
std::string expectation(const nlohmann::ordered_json& report);

} // namespace isomotion::app
