#include "scene/environment.h"

#include <fmt/format.h>

#include "scene/data_folder.h"

namespace isomotion::scene {
namespace fs = std::filesystem;
namespace {

fs::path find_map(const toml::node& node, const std::string& name) {
    std::error_code ignored;
    const fs::path own = beside(node, name), media = media_file(name);
    for (const fs::path& file : {own, media}) {
        if (fs::is_regular_file(file, ignored)) return file;
    }
    fail(node, "environment.map",
         fmt::format("there is no file {}, nor {}", own.string(), media.string()));
}

// One of [output] and [environment] is behind the surface, not both.
bool read_background(Section& section, Section& document) {
    const auto output = document.section("output");
    const bool other = output && output->has("background");
    const bool own = section.boolean("background").value_or(!other);
    if (own && other) {
        fail(*section.find("background"), "environment.background",
             "the scene has output.background already; keep one");
    }
    return own;
}

} // namespace

std::optional<Environment> read_environment(Section& document, TrackTable& tracks) {
    auto section = document.section("environment");
    if (!section) return std::nullopt;
    Environment environment;
    const auto name = section->text("map");
    if (!name) {
        fail(section->table(), "environment",
             "needs map = \"FILE\", a latitude-longitude map such as \"studio.exr\"");
    }
    environment.map = find_map(*section->find("map"), *name);
    const auto number = [&](const std::string& key, double value) {
        const auto source = section->track(key);
        return tracks.add("environment." + key, source ? *source : animation::TrackSource(value),
                          section->find(key));
    };
    environment.rotation = number("rotation", 0);
    environment.intensity = number("intensity", 1);
    environment.background = read_background(*section, document);
    section->refuse_rest();
    return environment;
}

} // namespace isomotion::scene
