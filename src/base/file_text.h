// Reads a whole file that a user named.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "base/confines.h"

namespace isomotion::base {

// Throws InputError ("drops.csv: ...") for a file that is missing, not regular (reading a folder, a
// pipe or a device may never end), larger than `most` bytes, unreadable or outside its confines.
std::string file_text(const std::filesystem::path& file, std::size_t most,
                      const Confines& within = {});
// The file of this name in an open folder.
std::string file_text(const FileDescriptor& folder, const std::filesystem::path& file,
                      std::size_t most);

} // namespace isomotion::base
