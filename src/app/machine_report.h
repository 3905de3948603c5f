// Reports what the program needs from a machine besides OpenGL.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace isomotion::app {

// One object each for "files", "processors", "disk", "ffmpeg" and "sbatch", with "reason" if
// something is wrong. Writes a file in the current folder and removes it.
nlohmann::ordered_json machine_report();

} // namespace isomotion::app
