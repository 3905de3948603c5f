#include "scene/reading/sections.h"

#include <fmt/format.h>

#include "scene/limits.h"

namespace isomotion::scene {
namespace {

Cut read_cut(const toml::node& at, const std::string& key, TrackTable& tracks) {
    Section section(*at.as_table(), key);
    const auto number = [&](const std::string& name) {
        const toml::node* node = section.find(name);
        return tracks.add(section.dotted(name),
                          node ? *section.track(name) : animation::TrackSource(0.0), node);
    };
    const auto vector = [&](const std::string& name) {
        const toml::node* node = section.find(name);
        const std::string dotted = section.dotted(name);
        return node ? tracks.add(dotted, *section.vector(name), node) : tracks.add(dotted, 0, 0, 0);
    };
    for (const char* known : {"normal", "point", "offset", "sphere", "centre"}) section.find(known);
    const bool has_plane = section.has("normal"), has_ball = section.has("sphere");
    if (has_plane == has_ball) {
        fail(at, key,
             "needs one of normal = [x, y, z], which points to the half-space that is taken away, "
             "and sphere = radius of a ball that is");
    }
    Cut cut;
    cut.is_ball = has_ball;
    if (has_ball) {
        cut.radius = number("sphere");
        cut.centre = vector("centre");
    } else {
        cut.normal = vector("normal");
        cut.point = vector("point");
        cut.offset = number("offset");
    }
    for (const char* name : {"point", "offset"}) {
        if (!has_ball || !section.has(name)) continue;
        fail(*section.find(name), section.dotted(name),
             "is of a half-space, which has a normal; of a ball give centre = [x, y, z]");
    }
    if (has_plane && section.has("centre")) {
        fail(*section.find("centre"), section.dotted("centre"),
             "is of a ball; of a half-space give point = [x, y, z] on its plane");
    }
    section.refuse_rest();
    return cut;
}

} // namespace

std::vector<Cut> read_sections(Section& document, TrackTable& tracks) {
    std::vector<Cut> sections;
    const toml::node* node = document.find("sections");
    if (!node) return sections;
    const toml::array* list = node->as_array();
    if (!list || list->empty() || !list->is_array_of_tables())
        fail(*node, "sections", "must be written as [[sections]], one such table a section");
    constexpr std::size_t most = limits::sections;
    if (list->size() > most) fail(*node, "sections", fmt::format("at most {}", most));
    for (std::size_t k = 0; k < list->size(); ++k)
        sections.push_back(read_cut(*list->get(k), fmt::format("sections[{}]", k), tracks));
    return sections;
}

} // namespace isomotion::scene
