#include "player/model/file_watch.h"

#include <algorithm>

#include "scene/data_folder.h"
#include "scene/reading/named_file.h"

namespace isomotion::player {
namespace fs = std::filesystem;
namespace {

std::optional<std::string> text_in(const toml::table& document, const char* section,
                                   const char* key) {
    return document[section][key].value_exact<std::string>();
}

// The tables of arrays, which a loaded scene does not name.
void add_tables(const toml::table& document, std::vector<fs::path>& files) {
    const toml::table* arrays = document["arrays"].as_table();
    if (!arrays) return;
    for (const auto& [name, node] : *arrays) {
        const toml::node* file = node.is_table() ? node.as_table()->get("file") : nullptr;
        const auto text = file ? file->value_exact<std::string>() : std::nullopt;
        if (text) files.push_back(scene::beside(*file, *text));
    }
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
            const auto now = base::stamp_of(file);
            wanted.insert({file, {now, now}});
        }
    }
    files_ = std::move(wanted);
}

std::vector<fs::path> FileWatch::changed() {
    std::vector<fs::path> changed;
    for (auto& [file, watched] : files_) {
        const auto now = base::stamp_of(file);
        if (now && now == watched.seen && now != watched.told) {
            watched.told = now;
            changed.push_back(file);
        }
        watched.seen = now;
    }
    return changed;
}

std::vector<fs::path> files_of(const scene::Scene& scene) {
    std::vector<fs::path> files{scene.file};
    for (const scene::Surface& surface : scene.surfaces) {
        if (!surface.name.empty()) files.push_back(scene::surface_file(surface.name));
    }
    if (scene.environment) files.push_back(scene.environment->map);
    for (fs::path& file : files_named(scene.file)) {
        if (std::ranges::find(files, file) == files.end()) files.push_back(std::move(file));
    }
    return files;
}

std::vector<fs::path> files_named(const fs::path& scene) {
    std::vector<fs::path> files{scene};
    try {
        const toml::table document = scene::read_document(scene);
        if (const auto name = text_in(document, "surface", "use")) {
            files.push_back(scene::surface_file(*name));
        }
        if (const auto map = text_in(document, "environment", "map")) {
            const fs::path own = scene::beside(*document["environment"]["map"].node(), *map);
            std::error_code ignored;
            files.push_back(own);
            if (!fs::is_regular_file(own, ignored)) files.push_back(scene::media_file(*map));
        }
        add_tables(document, files);
    } catch (const scene::SceneError&) {
        // No TOML yet: the next reading finds what it names then.
    }
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
