// Finds the program's own files: shaders/, animations/, media/, installed or in the source tree.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace isomotion::scene {

// The folder that holds shaders/ and animations/: $ISOMOTION_DATA, or <prefix>/share/isomotion
// beside the program, or the nearest folder above the program that has both (a source tree with
// its build inside); else, for programs of others that link this library, where the build was to be
// installed. Throws SceneError naming where it looked.
std::filesystem::path data_folder();

// Names (without .toml) of the gallery's animations, of the catalogue's surfaces, and of the looks
// that scenes name, sorted.
std::vector<std::string> animation_names();
std::vector<std::string> surface_names();
std::vector<std::string> look_names();

std::filesystem::path animation_file(const std::string& name);
std::filesystem::path surface_file(const std::string& name);
std::filesystem::path look_file(const std::string& name);
// `name` with its extension.
std::filesystem::path media_file(const std::string& name);

} // namespace isomotion::scene
