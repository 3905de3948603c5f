#pragma once

#include <algorithm>
#include <filesystem>
#include <string>

namespace isomotion::base {

/// The extension with its dot, in lower case: `.png` for `A.PNG`.
inline std::string lower_extension(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    return extension;
}

} // namespace isomotion::base
