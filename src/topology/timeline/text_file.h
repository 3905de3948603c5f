// A file that the user names, as text.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "topology/timeline/document.h"

namespace isomotion::topology {

// Throws DocumentError where there is none.
inline std::string read_text(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream || std::filesystem::is_directory(file)) {
        throw DocumentError(file.string() + ": no such file, or it cannot be read");
    }
    return {std::istreambuf_iterator<char>(stream), {}};
}

} // namespace isomotion::topology
