// Reads scripts of MathMod: .js and .json files with surfaces given by equations, "Iso3D".
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace isomotion::scene {

// Whether a scene's text is JSON, which no scene file begins as.
bool is_json(std::string_view text);

// A name such as "collection.js#Torus": a file and one of its models.
struct ModelName {
    std::string file, model;
};
std::optional<ModelName> model_name(const std::string& name);

// The scene in TOML. What is in it stands in the line that it comes from, so later mistakes are
// reported with the line of the script. Throws SceneError, "file:line: key: what is wrong".
//
// `model` names one of several scripts in a file; it may be empty if there is only one. Each
// component is a surface, its limits are the bounds. Sliders become parameters. Colours and
// grids are passed over. MathMod draws what its marching cubes find, walls at jumps included.
std::string mathmod_as_toml(std::string_view text, const std::filesystem::path& file,
                            const std::string& model);

} // namespace isomotion::scene
