// Files that a scene names: a surface's arrays, a map of the surroundings.
//
// Scenes come from strangers, too. One may name files of its own folder and of those below, and the
// program's own: no other, by whatever way ("..", an absolute path, a symbolic link), unless the
// user allows it. What --set names, the user has named.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "scene/reading/document.h"
#include "scene/reading/reach.h"

namespace isomotion::scene {

// Where a file that `node` names may be: from where its document is; on the command line from the
// current folder.
std::filesystem::path beside(const toml::node& node, const std::string& name);

// The first of `places` that is a file. Throws SceneError at `key` if none is, and if that one lies
// beyond `reach`.
std::filesystem::path named_file(const toml::node& node, const std::string& key,
                                 std::span<const std::filesystem::path> places, Reach reach);

} // namespace isomotion::scene
