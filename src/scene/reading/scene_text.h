// Writes a scene's document as the text of a scene file.
#pragma once

#include <string>

#include <toml++/toml.h>

namespace isomotion::scene {

// `root` is a document that was read without a mistake. Sections come in the order of
// docs/scene-file.md. Reading the text gives the same document.
std::string scene_text(const toml::table& root);

} // namespace isomotion::scene
