#include "scene/reading/named_file.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <fmt/format.h>

#include "base/printable.h"
#include "scene/data_folder.h"

namespace isomotion::scene {
namespace fs = std::filesystem;
base::Confines confines(const base::FileDescriptor& folder, Reach reach) {
    if (reach == Reach::anywhere) return {};
    std::vector<fs::path> places;
    const auto add = [&](const base::FileDescriptor& open) {
        if (const auto place = base::place_of(open)) places.push_back(*place);
    };
    add(folder);
    if (folder && places.empty()) {
        return {{},
                "cannot be told to lie in the scene's folder, as there is no /proc; allow all "
                "files with --allow-outside"};
    }
    try {
        for (const char* own : {"animations", "media"}) add(base::open_folder(data_folder() / own));
    } catch (const SceneError&) { // no such folder: told where something of it is needed
    }
    return {std::move(places), "lies outside the scene's folder; move it there, or allow such "
                               "files with --allow-outside"};
}

base::Confines confines_of(const toml::node& node, const base::Confines& scene) {
    return node.source().path ? scene : base::Confines();
}

fs::path beside(const toml::node& node, const std::string& name) {
    const auto& document = node.source().path;
    if (!document) return name;
    return fs::path(*document).parent_path() / name;
}

fs::path named_file(const toml::node& node, const std::string& key,
                    std::span<const fs::path> places, const base::Confines& within) {
    const fs::path* endless = nullptr;
    for (const fs::path& file : places) {
        // A zero would end the name for the system and not for us.
        if (file.native().find('\0') != std::string::npos) continue;
        // Not opened for reading yet: that may set a device going.
        const base::FileDescriptor found(::open(file.c_str(), O_PATH | O_CLOEXEC));
        struct stat is = {};
        if (!found || ::fstat(found.number(), &is) != 0 || S_ISDIR(is.st_mode)) continue;
        if (!S_ISREG(is.st_mode)) {
            endless = &file;
            continue;
        }
        if (within.hold(found)) return file;
        fail(node, key,
             fmt::format("{} {}", base::printable_line(file.string()), within.refusal()));
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
