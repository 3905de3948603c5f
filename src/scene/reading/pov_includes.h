// #include of POV-Ray's scene files.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "scene/reading/pov_words.h"

namespace isomotion::scene {

// Whether the file comes with POV-Ray: what it declares is known, if it is read.
bool is_povs_own_file(std::string_view name);

// The words of a file with those of the files in its folder that it includes, in place of the
// #include. These have its line, so mistakes in them are told there. A file that comes with
// POV-Ray, or that is not there, is left to the reader.
std::vector<PovWord> pov_words_with_includes(std::string_view text,
                                             const std::filesystem::path& file);

} // namespace isomotion::scene
