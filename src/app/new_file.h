// Writes files for the user to edit, never over existing ones.
#pragma once

#include <filesystem>
#include <string_view>

namespace isomotion::app {

// Throws std::invalid_argument if a file of this name exists, FileError if it cannot be written.
void write_new_file(const std::filesystem::path& file, std::string_view text);

} // namespace isomotion::app
