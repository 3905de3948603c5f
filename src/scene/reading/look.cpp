#include "scene/reading/look.h"

#include <algorithm>
#include <initializer_list>

#include <fmt/format.h>

#include "base/nearest_name.h"
#include "scene/data_folder.h"
#include "scene/reading/document.h"
#include "scene/renamed_keys.h"

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

bool has(const toml::table& document, std::string_view section, std::string_view key) {
    const toml::table* table = document[section].as_table();
    return table && table->contains(key);
}

void take_out(toml::table& look, std::string_view section,
              std::initializer_list<std::string_view> keys) {
    if (toml::table* table = look[section].as_table()) {
        for (const std::string_view key : keys) table->erase(key);
    }
}

// Leaves out of a look what would contradict the scene.
void leave_out(toml::table& look, const toml::table& document) {
    if (has(document, "material", "model"))
        take_out(look, "material", {"model", "shininess", "specular", "roughness", "metallic"});
    if (document.contains("environment") || has(document, "output", "background")) {
        take_out(look, "output", {"background"});
        look.erase("environment");
    }
}

bool says(const toml::table& table, std::string_view section, const std::string& name) {
    const RenamedKey* key = renamed_key(section, name);
    return table.contains(name) ||
           (key && (table.contains(key->now) || table.contains(key->before)));
}

} // namespace

NamedLook put_look(toml::table& document) {
    const toml::node* node = document.get("look");
    if (!node) return {};
    const auto name = node->value_exact<std::string>();
    if (!name) fail(*node, "look", "must be a text in quotes, as \"studio\"");
    if (*name == no_look) return {};
    toml::table look = read_look_file(*node, *name);
    look.erase("title");
    leave_out(look, document);
    NamedLook put{*name};
    for (auto& [section, value] : look) {
        const std::string key(section.str());
        toml::table* own = document[key].as_table();
        toml::table* from = value.as_table();
        if (!document.contains(key) && !(from && from->empty())) {
            document.insert(key, std::move(value)); // moved nodes keep their place in the file
            put.keys.push_back(key);
        } else if (own && from) {
            for (auto& [name_key, setting] : *from) {
                const std::string part(name_key.str());
                if (says(*own, key, part)) continue;
                own->insert(part, std::move(setting));
                put.keys.push_back(key + "." + part);
            }
        }
    }
    return put;
}

} // namespace isomotion::scene
