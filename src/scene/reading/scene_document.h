// Finds the document that a scene is read from, and parses it, in whichever program's words it is.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "base/confines.h"
#include "scene/reading/reach.h"

namespace isomotion::scene {

// A document with where it stands, before it is read.
struct SceneDocument {
    toml::table root;
    std::string text; // that it was parsed from
    std::filesystem::path file;
    base::Confines within;
};

// `name`: as load() takes it. Throws SceneError.
SceneDocument find_document(const std::string& name, const std::vector<std::string>& overrides,
                            Reach reach);
// `model`: of several in a file of MathMod.
toml::table parse_scene(std::string_view text, const std::filesystem::path& file,
                        const std::string& model = "");

// Whether the argument is a formula, and no file of that name.
bool is_formula_alone(const std::string& name);
// Whether the file is Surfer's, POV-Ray's or MathMod's.
bool is_of_another_program(const std::filesystem::path& file);

} // namespace isomotion::scene
