#include "scene/reading/environment.h"

#include "scene/data_folder.h"
#include "scene/key_tables.h"
#include "scene/reading/named_file.h"
#include "scene/reading/read_keys.h"

namespace isomotion::scene {
namespace {

// One of [output] and [environment] is behind the surface, not both.
void settle_background(Environment& environment, Section& section, Section& document) {
    const auto output = document.section("output");
    if (!output || !output->has("background")) return;
    if (section.has("background") && environment.background)
        section.tell("background", "the scene has output.background already; keep one");
    environment.background = false;
}

} // namespace

std::optional<Environment> read_environment(Section& document, TrackTable& tracks,
                                            const base::Confines& within) {
    auto section = document.section("environment");
    if (!section) return std::nullopt;
    Environment environment;
    if (!section->has("map")) {
        section->tell("needs map = \"FILE\", a latitude-longitude map such as \"studio.exr\"");
        section->find("map");
    } else if (const auto name = section->text("map")) {
        const toml::node& map = *section->find("map");
        section->attempt("map", [&] {
            environment.within = confines_of(map, within);
            environment.stated_at = position(map) + ": environment.map";
            environment.map =
                named_file(map, "environment.map",
                           std::array{beside(map, *name), media_file(*name)}, environment.within);
        });
    }
    read_keys(keys::environment_keys, *section, environment, tracks);
    settle_background(environment, *section, document);
    section->refuse_rest();
    return environment;
}

} // namespace isomotion::scene
