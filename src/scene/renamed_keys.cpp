#include "scene/renamed_keys.h"

#include <algorithm>

namespace isomotion::scene {
namespace {

constexpr RenamedKey renamed_keys[] = {
    {"surface", "transform", "placement"},  {"material", "colormap", "paint"},
    {"material", "back_color", "inside"},   {"occlusion", "radius", "reach"},
    {"arrays.*", "extrapolate", "outside"},
};

bool is_of(std::string_view section, const RenamedKey& key) {
    if (key.section != "arrays.*") return section == key.section;
    return section.starts_with("arrays.") && section.find('.', 7) == section.npos;
}

} // namespace

const RenamedKey* renamed_key(std::string_view section, std::string_view name) {
    for (const RenamedKey& key : renamed_keys) {
        if ((name == key.now || name == key.before) && is_of(section, key)) return &key;
    }
    return nullptr;
}

std::string first_name(std::string_view track) {
    const std::size_t dot = track.find('.');
    if (dot == track.npos) return std::string(track);
    const std::string_view section = track.substr(0, dot);
    const std::size_t end = std::min(track.find('.', dot + 1), track.size());
    const RenamedKey* key = renamed_key(section, track.substr(dot + 1, end - dot - 1));
    if (!key) return std::string(track);
    return std::string(section) + '.' + std::string(key->before) + std::string(track.substr(end));
}

} // namespace isomotion::scene
