#include "scene/reading/named_file.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/printable.h"
#include "scene/data_folder.h"

namespace isomotion::scene {
namespace fs = std::filesystem;
namespace {

// Both without symbolic links and dots.
bool lies_in(const fs::path& file, const fs::path& folder) {
    const auto [in_folder, in_file] =
        std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
    return in_folder == folder.end();
}

bool is_within(const fs::path& file, const fs::path& folder) {
    std::error_code error;
    const fs::path real_folder = fs::canonical(folder.empty() ? "." : folder, error);
    if (error) return false;
    const fs::path real_file = fs::canonical(file, error);
    return !error && lies_in(real_file, real_folder);
}

bool is_near(const fs::path& file, const fs::path& document) {
    if (is_within(file, document.parent_path())) return true;
    const fs::path own = data_folder();
    return is_within(file, own / "animations") || is_within(file, own / "media");
}

} // namespace

fs::path beside(const toml::node& node, const std::string& name) {
    const auto& document = node.source().path;
    if (!document) return name;
    return fs::path(*document).parent_path() / name;
}

fs::path named_file(const toml::node& node, const std::string& key,
                    std::span<const fs::path> places, Reach reach) {
    const fs::path* endless = nullptr;
    for (const fs::path& file : places) {
        // A zero would end the name for the system and not for us.
        std::error_code ignored;
        if (file.native().find('\0') != std::string::npos) continue;
        const fs::file_status found = fs::status(file, ignored);
        if (!fs::is_regular_file(found)) {
            if (fs::exists(found) && !fs::is_directory(found)) endless = &file;
            continue;
        }
        const auto& document = node.source().path;
        if (document && reach == Reach::own_folder && !is_near(file, *document)) {
            fail(node, key,
                 fmt::format("{} lies outside the scene's folder; move it there, or allow such "
                             "files with --allow-outside",
                             base::printable_line(file.string())));
        }
        return file;
    }
    if (endless) {
        fail(node, key,
             fmt::format("{} is a pipe or a device, not a regular file",
                         base::printable_line(endless->string())));
    }
    std::vector<std::string> names;
    for (const fs::path& file : places) names.push_back(base::printable_line(file.string()));
    fail(node, key, fmt::format("there is no file {}", fmt::join(names, ", nor ")));
}

} // namespace isomotion::scene
