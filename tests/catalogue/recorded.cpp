#include "recorded.h"

#include <toml++/toml.h>

namespace isomotion::catalogue {
namespace {

// A key that is missing or of another type ends the program: the tests' own data is broken.
template<class T> T get(const toml::node_view<const toml::node>& node) {
    return node.value<T>().value();
}

glm::dvec3 vector_of(const toml::node_view<const toml::node>& node) {
    return {get<double>(node[0]), get<double>(node[1]), get<double>(node[2])};
}

std::vector<std::string> names_of(const toml::node_view<const toml::node>& node) {
    std::vector<std::string> names;
    if (const toml::array* list = node.as_array()) {
        for (const toml::node& name : *list) names.push_back(name.value<std::string>().value());
    }
    return names;
}

Recorded read(const std::string& name, const toml::table& table) {
    const auto at = [&](const char* key) {
        return toml::node_view<const toml::node>(table.get(key));
    };
    Recorded surface;
    surface.name = name;
    if (at("bounds").is_number()) {
        surface.radius = get<double>(at("bounds"));
    } else {
        surface.min = vector_of(at("bounds")[0]);
        surface.max = vector_of(at("bounds")[1]);
    }
    surface.least = get<double>(at("values")[0]);
    surface.greatest = get<double>(at("values")[1]);
    for (std::size_t k = 0; k < surface.quantiles.size(); ++k) {
        surface.quantiles[k] = get<double>(at("quantiles")[k]);
    }
    surface.sign = get<int>(at("sign"));
    surface.symmetry = names_of(at("symmetry"));
    surface.antisymmetry = names_of(at("antisymmetry"));
    return surface;
}

} // namespace

const std::vector<Recorded>& recorded() {
    static const std::vector<Recorded> surfaces = [] {
        std::vector<Recorded> all;
        for (const auto& [name, node] :
             toml::parse_file(ISOMOTION_SOURCE_DIR "/tests/catalogue/recorded.toml")) {
            all.push_back(read(std::string(name.str()), *node.as_table()));
        }
        return all;
    }();
    return surfaces;
}

} // namespace isomotion::catalogue
