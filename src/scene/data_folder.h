// Finds the program's own files: shaders/, animations/, media/, installed or in the source tree.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace isomotion::scene {

// The folder that holds shaders/ and animations/. Tried in this order: $ISOMOTION_DATA; the folder
// that set_data_folder() named; <prefix>/share/isomotion beside the program; the nearest folder
// above the program that has both (a source tree with its build inside); the folder where the build
// was to be installed. Throws SceneError that names the places tried.
std::filesystem::path data_folder();
void set_data_folder(const std::filesystem::path& folder);

// Sorted names (without .toml) of the gallery's animations, of the catalogue's surfaces, and of the
// looks that scenes can name.
std::vector<std::string> animation_names();
std::vector<std::string> surface_names();
std::vector<std::string> look_names();

std::filesystem::path animation_file(const std::string& name);
std::filesystem::path surface_file(const std::string& name);
std::filesystem::path look_file(const std::string& name);
// `name` with its extension.
std::filesystem::path media_file(const std::string& name);

} // namespace isomotion::scene
