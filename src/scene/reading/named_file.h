// Files that a scene names: tables of elements, an environment map.
//
// Scenes come from strangers, too. A scene may name files of its own folder, of those below, and of
// the program; no others, by whatever path ("..", absolute, a symbolic link), unless the user
// allows it. A file that --set names was named by the user.
//
// A name is looked at when the scene is read, so that a mistake is told with its line. What lies
// under it may be changed afterwards: base::RegularFile asks again, of the file that it has opened.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "base/confines.h"
#include "scene/reading/document.h"
#include "scene/reading/reach.h"

namespace isomotion::scene {

// The path of a file that `node` names: relative to its document; from the command line relative to
// the current folder.
std::filesystem::path beside(const toml::node& node, const std::string& name);

// Where the files may lie that the scene in this open folder names.
base::Confines confines(const base::FileDescriptor& folder, Reach reach);
// The same for what `node` names: anywhere, if it comes from the command line.
base::Confines confines_of(const toml::node& node, const base::Confines& scene);

// The first of `places` that is a file. Throws SceneError at `key` if none is, or if that one lies
// outside its confines.
std::filesystem::path named_file(const toml::node& node, const std::string& key,
                                 std::span<const std::filesystem::path> places,
                                 const base::Confines& within);

} // namespace isomotion::scene
