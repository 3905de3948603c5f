// Scenes of POV-Ray: .pov files with one surface given by a formula.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace isomotion::scene {

// The scene in TOML, each key in the line of the object that it comes from, so that mistakes found
// in it later are told with the line of the .pov file. Throws SceneError, "file:line: word: what is
// wrong", for what is not read, too, unless it is only how a surface looks.
//
// POV-Ray's y is up and its axes are left-handed: its y and z change places here, in the formula
// as in every vector, and the picture stays the same. Declared numbers become parameters, the
// clock goes from 0 to 1 in a second. A light's colour is multiplied by 0.6, POV-Ray's diffuse
// part, unless a finish says another.
std::string pov_as_toml(std::string_view text, const std::filesystem::path& file);

} // namespace isomotion::scene
