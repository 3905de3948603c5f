#include "scene/reading/scene_text.h"

#include <sstream>
#include <string_view>

namespace isomotion::scene {
namespace {

constexpr std::string_view sections[] = {
    "title",  "time",     "surface", "parameters", "arrays",    "isolation",   "camera",
    "lights", "material", "ground",  "fog",        "occlusion", "environment", "output"};

std::string text_of(const toml::table& table) {
    std::ostringstream text;
    text.precision(17);
    text << toml::toml_formatter(table, toml::toml_formatter::default_flags &
                                            ~toml::format_flags::indentation);
    return text.str();
}

} // namespace

std::string scene_text(const toml::table& root) {
    std::string text;
    toml::table rest = root;
    const auto add = [&](const toml::table& part) {
        if (!text.empty()) text += text.find('[') == text.npos ? "\n" : "\n\n";
        text += text_of(part);
    };
    for (const std::string_view section : sections) {
        const toml::node* node = root.get(section);
        if (!node) continue;
        toml::table part;
        part.insert(section, *node);
        rest.erase(section);
        add(part);
    }
    if (!rest.empty()) add(rest);
    return text + "\n";
}

} // namespace isomotion::scene
