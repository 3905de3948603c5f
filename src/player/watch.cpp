#include "player/watch.h"

#include <algorithm>

#include <sys/stat.h>

#include "scene/data_folder.h"
#include "scene/document.h"

namespace isomotion::player {
namespace fs = std::filesystem;
namespace {

// Tables that arrays take their elements from; a scene keeps the elements only.
std::vector<fs::path> tables_of(const fs::path& scene) {
    std::vector<fs::path> tables;
    try {
        const toml::table document = scene::read_document(scene);
        const toml::table* arrays = document["arrays"].as_table();
        if (!arrays) return {};
        for (const auto& [name, node] : *arrays) {
            const toml::node* file = node.is_table() ? node.as_table()->get("file") : nullptr;
            const auto text = file ? file->value_exact<std::string>() : std::nullopt;
            if (text) tables.push_back(scene::beside(*file, *text));
        }
    } catch (const scene::SceneError&) {
        // Changed since it was loaded: the next reading finds what it names then.
    }
    return tables;
}

} // namespace

FileWatch::FileWatch(const std::vector<fs::path>& files) { watch(files); }

void FileWatch::watch(const std::vector<fs::path>& files) {
    std::map<fs::path, Watched> wanted;
    for (const fs::path& file : files) {
        const auto known = files_.find(file);
        if (known != files_.end()) {
            wanted.insert(*known);
        } else {
            const auto now = stamp(file);
            wanted.insert({file, {now, now}});
        }
    }
    files_ = std::move(wanted);
}

std::vector<fs::path> FileWatch::changed() {
    std::vector<fs::path> changed;
    for (auto& [file, watched] : files_) {
        const auto now = stamp(file);
        if (now && now == watched.seen && now != watched.told) {
            watched.told = now;
            changed.push_back(file);
        }
        watched.seen = now;
    }
    return changed;
}

std::optional<FileWatch::Stamp> FileWatch::stamp(const fs::path& file) {
    struct stat found = {};
    if (::stat(file.c_str(), &found) != 0 || !S_ISREG(found.st_mode)) return std::nullopt;
    return Stamp{std::uint64_t(found.st_dev), std::uint64_t(found.st_ino),
                 std::int64_t(found.st_size), std::int64_t(found.st_mtim.tv_sec),
                 std::int64_t(found.st_mtim.tv_nsec)};
}

std::vector<fs::path> files_of(const scene::Scene& scene) {
    std::vector<fs::path> files{scene.file};
    if (!scene.surface.name.empty()) files.push_back(scene::surface_file(scene.surface.name));
    if (scene.environment) files.push_back(scene.environment->map);
    for (fs::path& table : tables_of(scene.file)) files.push_back(std::move(table));
    return files;
}

std::vector<fs::path> shader_files() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(scene::data_folder() / "shaders")) {
        if (entry.is_regular_file()) files.push_back(entry.path());
    }
    std::ranges::sort(files);
    return files;
}

} // namespace isomotion::player
