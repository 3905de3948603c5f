// Files that a user goes on with: never written over.
#pragma once

#include <filesystem>
#include <string_view>

namespace isomotion::app {

// Throws std::invalid_argument where there is something of this name, FileError where it cannot be
// written.
void write_new_file(const std::filesystem::path& file, std::string_view text);

} // namespace isomotion::app
