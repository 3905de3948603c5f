// Files that a scene names: tables of elements, an environment map.
//
// Scenes come from strangers, too. A scene may name files of its own folder, of those below, and of
// the program; no others, by whatever path ("..", absolute, a symbolic link), unless the user
// allows it. A file that --set names was named by the user.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "scene/reading/document.h"
#include "scene/reading/reach.h"

namespace isomotion::scene {

// The path of a file that `node` names: relative to its document; from the command line relative to
// the current folder.
std::filesystem::path beside(const toml::node& node, const std::string& name);

// The first of `places` that is a file. Throws SceneError at `key` if none is, or if `reach`
// forbids that one.
std::filesystem::path named_file(const toml::node& node, const std::string& key,
                                 std::span<const std::filesystem::path> places, Reach reach);

} // namespace isomotion::scene
