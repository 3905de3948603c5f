// Finds files that a scene names: tables of elements, an environment map.
//
// Scenes may come from strangers. A scene may name files in its own folder, in those below it, and
// among the program's files. It may name no others by any path ("..", absolute, a symbolic link),
// unless the user allows it. A file that --set names counts as named by the user.
//
// A name is checked when the scene is read, so that a mistake is reported with its line. The file
// may be replaced afterwards, so base::RegularFile checks again, on the file that it has opened.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "base/confines.h"
#include "scene/reading/document.h"
#include "scene/reading/reach.h"

namespace isomotion::scene {

// The path of a file that `node` names: relative to its document, or to the current folder if it
// comes from the command line.
std::filesystem::path beside(const toml::node& node, const std::string& name);

// The folders in which files may lie that the scene in this open folder names.
base::Confines confines(const base::FileDescriptor& folder, Reach reach);
// The same for a name in `node`: anywhere, if it comes from the command line.
base::Confines confines_of(const toml::node& node, const base::Confines& scene);

// The first of `places` that is a file. Throws SceneError at `key` if none is, or if the first one
// lies outside its confines.
std::filesystem::path named_file(const toml::node& node, const std::string& key,
                                 std::span<const std::filesystem::path> places,
                                 const base::Confines& within);

} // namespace isomotion::scene
