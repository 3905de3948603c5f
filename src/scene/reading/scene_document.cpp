#include "scene/reading/scene_document.h"

#include <cerrno>
#include <system_error>

#include <fmt/format.h>

#include "base/extension.h"
#include "base/file_text.h"
#include "base/nearest_name.h"
#include "scene/data_folder.h"
#include "scene/limits.h"
#include "scene/reading/document.h"
#include "scene/reading/formula_scene.h"
#include "scene/reading/mathmod.h"
#include "scene/reading/named_file.h"
#include "scene/reading/pov.h"
#include "scene/reading/surfer.h"

namespace isomotion::scene {
namespace fs = std::filesystem;
namespace {

fs::path locate(const std::string& scene) {
    std::error_code error;
    const fs::file_type type = fs::status(scene, error).type();
    if (type == fs::file_type::directory)
        throw SceneError(scene + ": is a folder; name a scene file (.toml)");
    if (type == fs::file_type::none)
        throw SceneError(fmt::format("{}: cannot be read: {}", scene, error.message()));
    if (type != fs::file_type::not_found) return scene;
    const fs::path extension = fs::path(scene).extension();
    const bool looks_like_path =
        scene.find('/') != scene.npos || extension == ".toml" || is_of_another_program(scene);
    fs::path installed = animation_file(scene);
    if (!looks_like_path && fs::exists(installed, error)) return installed;
    for (const char* missing : {".toml", ".jsurf", ".pov", ".js", ".json"}) {
        const fs::path meant = fs::path(scene).replace_extension(missing);
        if (meant == fs::path(scene) || !fs::exists(meant, error)) continue;
        throw SceneError(
            fmt::format("{}: no such file; did you mean '{}'?", scene, meant.string()));
    }
    if (looks_like_path) throw SceneError(scene + ": no such file");
    const auto known = animation_names();
    const std::string near = base::nearest_name(scene, known);
    // "r - 1" could be either.
    if (near.empty() && scene.find('-') != scene.npos) {
        throw SceneError(fmt::format("{0}: no such file, and no animation of this name; a formula "
                                     "of one side has a 0 on the other: '{0} = 0'",
                                     scene));
    }
    throw SceneError(
        near.empty() ? fmt::format("{}: no such file, and no animation of this name; isomotion "
                                   "list names the {} that there are",
                                   scene, known.size())
                     : fmt::format("{}: no such file, and no animation of this name; did you mean "
                                   "'{}'?",
                                   scene, near));
}

bool is_there(const fs::path& file) {
    std::error_code error;
    const fs::file_type type = fs::status(file, error).type();
    return type != fs::file_type::not_found && type != fs::file_type::none; // too long for a file
}

// Somebody's gallery may have a file "x^2+y^2=1.toml".
bool is_animation(const std::string& name) {
    return name.find('/') == name.npos && is_there(animation_file(name));
}

} // namespace

bool is_of_another_program(const fs::path& file) {
    const std::string extension = base::lower_extension(file);
    return extension == ".jsurf" || extension == ".pov" || extension == ".js" ||
           extension == ".json";
}

bool is_formula_alone(const std::string& name) {
    return is_formula(name) && !model_name(name) && !is_there(name) && !is_animation(name);
}

toml::table parse_scene(std::string_view text, const fs::path& file, const std::string& model) {
    const std::string extension = base::lower_extension(file);
    if (extension == ".jsurf") return parse_document(surfer_as_toml(text, file), file);
    if (extension == ".pov") return parse_document(pov_as_toml(text, file), file);
    if (is_json(text) || extension == ".js" || extension == ".json")
        return parse_document(mathmod_as_toml(text, file, model), file);
    return parse_document(text, file);
}

SceneDocument find_document(const std::string& name, const std::vector<std::string>& overrides,
                            Reach reach) {
    if (is_formula_alone(name)) {
        return {scene_of_formula(name, overrides), "", "formula.toml",
                confines(base::open_folder(fs::path()), reach)};
    }
    const auto named = is_there(name) ? std::nullopt : model_name(name);
    const fs::path file = locate(named ? named->file : name);
    // The scene and what it may name lie in one folder, wherever that folder's name leads later.
    const base::FileDescriptor folder = base::open_folder(file.parent_path());
    if (!folder) {
        throw SceneError(fmt::format("{}: its folder cannot be opened: {}", file.string(),
                                     std::generic_category().message(errno)));
    }
    const std::string text = base::file_text(folder, file, limits::scene_bytes);
    return {parse_scene(text, file, named ? named->model : ""), text, file,
            confines(folder, reach)};
}

} // namespace isomotion::scene
