// Reads scenes of POV-Ray: .pov files with objects that have formulas.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace isomotion::scene {

// The scene in TOML. Each key is in the line of the object that it comes from, so later mistakes in
// it are reported with the line of the .pov file. Throws SceneError, "file:line: word: what is
// wrong", also for unsupported statements, unless they affect only how a surface looks.
//
// Each object is a tree (pov_solids.h), of which pov_formula.h makes one formula.
//
// POV-Ray's y is up and its axes are left-handed. This function exchanges y and z in the formula
// and in every vector, so that the picture stays the same. Declared numbers become parameters; the
// clock goes from 0 to 1 in a second. A light's colour is multiplied by 0.6, POV-Ray's default
// diffuse part, unless a finish states another.
std::string pov_as_toml(std::string_view text, const std::filesystem::path& file);

} // namespace isomotion::scene
