#include "scene/reading/formula_scene.h"

#include <filesystem>
#include <regex>

namespace isomotion::scene {

bool is_formula(const std::string& name) {
    const auto extension = std::filesystem::path(name).extension();
    return name.find_first_of("=^*+()|") != name.npos && extension != ".toml" &&
           extension != ".jsurf";
}

toml::table scene_of_formula(const std::string& formula) {
    const std::string timed = std::regex_replace(formula, std::regex(R"(\bt\b)"), "time");
    toml::table root{{"title", formula}, {"surface", toml::table{{"formula", timed}}}};
    if (timed != formula) {
        root.insert("parameters", toml::table{{"time", "t"}});
        root.insert("time", toml::table{{"frames", 120}, {"fps", 30}});
    }
    return root;
}

} // namespace isomotion::scene
