#include "scene/data_folder.h"

#include <algorithm>
#include <cstdlib>
#include <mutex>

#include <fmt/format.h>

#include "scene/error.h"

namespace isomotion::scene {
namespace fs = std::filesystem;
namespace {

// `error` says why where that is not known.
bool holds_data(const fs::path& folder, std::error_code& error) {
    for (const char* part : {"shaders", "animations"}) {
        if (!fs::is_directory(folder / part, error)) return false;
    }
    return true;
}

bool holds_data(const fs::path& folder) {
    std::error_code ignored;
    return holds_data(folder, ignored);
}

// Set before main(), by programs of others, and read by any thread.
class NamedFolder {
public:
    fs::path get() const {
        const std::lock_guard lock(mutex_);
        return folder_;
    }
    void set(const fs::path& folder) {
        const std::lock_guard lock(mutex_);
        folder_ = folder;
    }

private:
    mutable std::mutex mutex_;
    fs::path folder_;
};

NamedFolder& named_folder() {
    static NamedFolder folder;
    return folder;
}

std::vector<std::string> toml_names(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
        if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

} // namespace

fs::path data_folder() {
    if (const char* given = std::getenv("ISOMOTION_DATA")) {
        std::error_code error;
        if (holds_data(given, error)) return given;
        if (error && error != std::errc::no_such_file_or_directory)
            throw SceneError(fmt::format("ISOMOTION_DATA={}: {}", given, error.message()));
        throw SceneError(fmt::format("ISOMOTION_DATA={}: this folder has no shaders/ and "
                                     "animations/ in it; name the one that has, or unset it",
                                     given));
    }
    if (fs::path named = named_folder().get(); holds_data(named)) return named;
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    for (fs::path up = program.parent_path(); !error && up.has_relative_path();
         up = up.parent_path()) {
        if (holds_data(up / "share" / "isomotion")) return up / "share" / "isomotion";
        if (holds_data(up)) return up;
    }
    if (holds_data(ISOMOTION_INSTALLED_DATA)) return ISOMOTION_INSTALLED_DATA;
    throw SceneError(fmt::format("the program's shaders/ and animations/ are not to be found above "
                                 "{}; set ISOMOTION_DATA to the folder that holds them",
                                 program.string()));
}

void set_data_folder(const fs::path& folder) { named_folder().set(folder); }

std::vector<std::string> animation_names() { return toml_names(data_folder() / "animations"); }
std::vector<std::string> surface_names() {
    return toml_names(data_folder() / "animations" / "surfaces");
}
std::vector<std::string> look_names() { return toml_names(data_folder() / "animations" / "looks"); }

fs::path animation_file(const std::string& name) {
    return data_folder() / "animations" / (name + ".toml");
}
fs::path surface_file(const std::string& name) {
    return data_folder() / "animations" / "surfaces" / (name + ".toml");
}
fs::path look_file(const std::string& name) {
    return data_folder() / "animations" / "looks" / (name + ".toml");
}
fs::path media_file(const std::string& name) { return data_folder() / "media" / name; }

} // namespace isomotion::scene
