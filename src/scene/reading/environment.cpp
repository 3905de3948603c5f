#include "scene/reading/environment.h"

#include "scene/data_folder.h"
#include "scene/reading/named_file.h"

namespace isomotion::scene {
namespace {

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

std::optional<Environment> read_environment(Section& document, TrackTable& tracks,
                                            const base::Confines& within) {
    auto section = document.section("environment");
    if (!section) return std::nullopt;
    Environment environment;
    const auto name = section->text("map");
    if (!name) {
        fail(section->table(), "environment",
             "needs map = \"FILE\", a latitude-longitude map such as \"studio.exr\"");
    }
    const toml::node& map = *section->find("map");
    environment.within = confines_of(map, within);
    environment.map =
        named_file(map, "environment.map", std::array{beside(map, *name), media_file(*name)},
                   environment.within);
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
