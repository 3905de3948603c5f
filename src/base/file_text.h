// A file that a user named, as a whole.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace isomotion::base {

// Throws InputError ("drops.csv: ...") for what is missing, no regular file (a folder, a pipe, a
// device: reading them may never end), larger than `most` bytes or unreadable.
std::string file_text(const std::filesystem::path& file, std::size_t most);

} // namespace isomotion::base
