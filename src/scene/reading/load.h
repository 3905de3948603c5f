// Scene file (TOML) -> Scene.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/error.h"
#include "scene/reading/reach.h"
#include "scene/scene.h"

namespace isomotion::scene {

// "name=value" from the command line. `name` is a parameter or a dotted key of the scene file
// ("camera.fov"); `value` is a number or an expression. "camera={...}" replaces the scene's whole
// camera.
using Override = std::string;

// `scene` is a path to a scene file (.toml, Surfer's .jsurf, POV-Ray's .pov, MathMod's .js or
// .json, of several models in it one as "collection.js#Torus"), the name of an
// animation of the gallery, or a formula: "x^2 + y^2 + z^2 = 1 + 0.3*sin(9*x + t)", which moves if
// it or an override names t. Throws SceneError with all mistakes that reading finds, each in a line
// of its own.
Scene load(const std::string& scene, const std::vector<Override>& overrides = {},
           Reach reach = Reach::own_folder);

// Loads a scene's text as if it were the content of `file`.
Scene load_text(std::string_view text, const std::filesystem::path& file,
                const std::vector<Override>& overrides = {}, Reach reach = Reach::own_folder);

// The text of a scene file (TOML) for this scene with these settings, including bounds that had to
// be found. Comments of a scene file are lost. Files that the scene names are looked for relative
// to the place where the text is saved. Throws SceneError.
std::string scene_file_text(const std::string& scene, const std::vector<Override>& overrides = {},
                            Reach reach = Reach::own_folder);

// The title of a scene or of a surface of the catalogue.
std::string title(const std::filesystem::path& file);

} // namespace isomotion::scene
