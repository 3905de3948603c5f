// Writes what the tables of keys say as the JSON schema of scene files, for editors, and as the
// tables of docs/scene-file.md.
#pragma once

#include <string>
#include <vector>

#include "scene/key_sections.h"

namespace isomotion::scene {

std::string schema_text(const std::vector<SectionDescription>& sections);
std::string key_table(const std::vector<SectionDescription>& sections); // Markdown
// The page with the table in place of its first one, that of keys.
std::string with_key_table(const std::string& page,
                           const std::vector<SectionDescription>& sections);
// The text of a Markdown line without its links, code marks and escapes.
std::string plain_text(const std::string& markdown);

} // namespace isomotion::scene
