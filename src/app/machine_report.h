// What the program needs of a machine beside OpenGL.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace isomotion::app {

// "files", "processors", "disk", "ffmpeg", "sbatch": an object each, with "reason" where something
// is not as it should be. Writes a file in the current folder and removes it.
nlohmann::ordered_json machine_report();

} // namespace isomotion::app
