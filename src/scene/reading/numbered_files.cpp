#include "scene/reading/numbered_files.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/input_error.h"
#include "base/printable.h"
#include "scene/limits.h"
#include "scene/reading/named_file.h"
#include "sequence/names/sequence_name.h"

namespace isomotion::scene {
namespace fs = std::filesystem;
namespace {

sequence::SequenceName parsed(const toml::node& node, const std::string& key,
                              const fs::path& name) {
    try {
        return sequence::SequenceName::parse(name.string());
    } catch (const base::InputError& error) {
        fail(node, key, error.what());
    }
}

} // namespace

std::vector<NumberedFile> numbered_files(const toml::node& node, const std::string& key,
                                         const fs::path& name, const base::Confines& within) {
    std::error_code error;
    const std::string last = name.filename().string();
    // A zero would end the name for the system and not for us.
    if (last.find_first_of("#%") == last.npos || name.native().find('\0') != std::string::npos)
        return {};
    if (fs::exists(name, error)) return {};
    const sequence::SequenceName pattern = parsed(node, key, name);
    if (!pattern.holds_many()) return {};
    const fs::path folder = pattern.folder().empty() ? fs::path(".") : pattern.folder();

    std::vector<NumberedFile> files;
    for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
        const auto number = pattern.frame_of(entry->path().filename().string());
        if (!number || *number < 0 || *number > limits::frames) continue;
        std::error_code ignored;
        // What lies in the folder itself is as near as the folder is.
        if (files.empty() || entry->is_symlink(ignored) || !entry->is_regular_file(ignored))
            named_file(node, key, std::array{pattern.path(*number)}, within);
        files.push_back({*number, pattern.path(*number)});
    }
    if (error)
        fail(node, key, fmt::format("{} cannot be read: {}", folder.string(), error.message()));
    if (files.empty()) {
        fail(node, key,
             fmt::format("there is no file {}, with a number in place of {}",
                         base::printable_line(name.string()),
                         pattern.pattern().find('#') == std::string::npos ? "its place" : "####"));
    }
    std::ranges::sort(files, {}, &NumberedFile::number);
    int step = limits::frames;
    for (std::size_t k = 1; k < files.size(); ++k)
        step = std::min(step, files[k].number - files[k - 1].number);
    for (std::size_t k = 1; k < files.size(); ++k) {
        if (files[k].number - files[k - 1].number == step) continue;
        fail(node, key,
             fmt::format("there is no file {}, between {} and {}",
                         pattern.path(files[k - 1].number + step).string(),
                         files[k - 1].file.filename().string(), files[k].file.filename().string()));
    }
    return files;
}

} // namespace isomotion::scene
