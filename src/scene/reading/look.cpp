#include "scene/reading/look.h"

#include <algorithm>
#include <initializer_list>

#include <fmt/format.h>

#include "base/nearest_name.h"
#include "scene/data_folder.h"
#include "scene/reading/document.h"

namespace isomotion::scene {
namespace {

constexpr std::string_view no_look = "none";

toml::table read_look_file(const toml::node& at, const std::string& name) {
    const std::vector<std::string> known = look_names();
    if (std::ranges::count(known, name)) return read_document(look_file(name));
    const std::string near = base::nearest_name(name, known);
    fail(at, "look",
         fmt::format("there is no look '{}'; {}known: {}, none", name,
                     near.empty() ? "" : fmt::format("did you mean '{}'? ", near),
                     fmt::join(known, ", ")));
}

bool has(Section& document, const char* name, const char* key) {
    const auto section = document.section(name);
    return section && section->has(key);
}

void take_out(toml::table& look, std::string_view section,
              std::initializer_list<std::string_view> keys) {
    if (toml::table* table = look[section].as_table()) {
        for (const std::string_view key : keys) table->erase(key);
    }
}

// Leaves out of a look what would contradict the scene.
void leave_out(toml::table& look, Section& document) {
    if (has(document, "material", "model"))
        take_out(look, "material", {"model", "shininess", "specular", "roughness", "metallic"});
    if (document.has("environment") || has(document, "output", "background")) {
        take_out(look, "output", {"background"});
        look.erase("environment");
    }
}

} // namespace

NamedLook look_below(Section& document, const toml::node* named, toml::table& look) {
    if (!named) return {};
    const auto name = named->value_exact<std::string>();
    if (!name) fail(*named, "look", "must be a text in quotes, as \"studio\"");
    if (*name == no_look) return {};
    look = read_look_file(*named, *name);
    look.erase("title");
    leave_out(look, document);
    NamedLook put{*name};
    for (const auto& [section, value] : look) {
        const std::string key(section.str());
        const toml::table* table = value.as_table();
        if (!document.has(key)) {
            if (!table || !table->empty()) put.keys.push_back(key);
            continue;
        }
        const auto own = table ? document.section(key) : std::nullopt;
        if (!own) continue;
        for (const auto& [part, setting] : *table) {
            if (!own->has(std::string(part.str())))
                put.keys.push_back(key + "." + std::string(part.str()));
        }
    }
    return put;
}

void put_under(toml::table& document, toml::table look) {
    MistakeList none;
    for (auto& [section, value] : look) {
        const std::string key(section.str());
        toml::table* own = document[key].as_table();
        toml::table* from = value.as_table();
        if (!document.contains(key) && !(from && from->empty())) {
            document.insert(key, std::move(value));
        } else if (own && from) {
            for (auto& [part, setting] : *from) {
                const bool is_said = Section(*own, key, none).has(std::string(part.str()));
                if (!is_said) own->insert(part, std::move(setting));
            }
        }
    }
}

} // namespace isomotion::scene
