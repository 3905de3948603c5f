#include "scene/reading/surface_list.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "base/printable.h"
#include "scene/reading/document.h"
#include "scene/surfaces.h"

namespace isomotion::scene {
namespace {

constexpr std::size_t longest_name = 64;

std::string number_of(std::size_t index) { return std::to_string(index + 1); }

std::string read_name(const toml::table& table, std::size_t index) {
    const toml::node* node = table.get("name");
    if (!node) return number_of(index);
    const std::string key = fmt::format("surfaces.{}.name", index + 1);
    const auto text = node->value_exact<std::string>();
    const bool is_right = text && !text->empty() && text->size() <= longest_name &&
                          base::is_one_printable_line(*text);
    if (!is_right)
        fail(*node, key,
             fmt::format("must be a text of one line and at most {} bytes", longest_name));
    return *text;
}

std::set<std::string> keys_of(const toml::table* table) {
    std::set<std::string> keys;
    if (!table) return keys;
    for (const auto& [key, value] : *table) keys.insert(std::string(key.str()));
    return keys;
}

} // namespace

toml::table& listed(toml::table& document, std::size_t index) {
    return *document.get("surfaces")->as_array()->get(index)->as_table();
}

bool lists_surfaces(const toml::table& document) { return document.contains("surfaces"); }

std::vector<std::string> listed_names(toml::table& document, MistakeList& mistakes) {
    const toml::node& node = *document.get("surfaces");
    const toml::array* list = node.as_array();
    if (!list || !list->is_array_of_tables())
        fail(node, "surfaces", "must be tables: [[surfaces]] above the keys of each");
    if (list->size() > std::size_t(most_surfaces))
        fail(node, "surfaces",
             fmt::format("has {} surfaces; at most {} are possible", list->size(), most_surfaces));
    if (const toml::node* one = document.get("surface"))
        fail(*one, "surface", "is beside [[surfaces]]; list it there, or leave the list out");
    std::vector<std::string> names;
    for (std::size_t k = 0; k < list->size(); ++k) {
        std::string name = number_of(k);
        mistakes.attempt([&] {
            const std::string given = read_name(listed(document, k), k);
            if (std::ranges::count(names, given) > 0)
                fail(*list->get(k), fmt::format("surfaces.{}.name", k + 1),
                     fmt::format("'{}' is the name of another surface", given));
            name = given;
        });
        names.push_back(name);
    }
    return names;
}

toml::table* listed_surface(toml::table& document, const std::string& name) {
    toml::array* list = document["surfaces"].as_array();
    if (!list || !list->is_array_of_tables()) return nullptr;
    for (std::size_t k = 0; k < list->size(); ++k) {
        toml::table* table = list->get(k)->as_table();
        const auto own = (*table)["name"].value_exact<std::string>();
        if (own.value_or(number_of(k)) == name || number_of(k) == name) return table;
    }
    return nullptr;
}

std::set<std::string> shared_parameters(const toml::table& document) {
    return keys_of(document["parameters"].as_table());
}

std::set<std::string> own_parameters(toml::table& document, std::size_t index) {
    return keys_of(listed(document, index)["parameters"].as_table());
}

bool put_own_parameter(toml::table& document, const std::string& name, const toml::node& value) {
    toml::array* list = document["surfaces"].as_array();
    if (!list || !list->is_array_of_tables()) return false;
    bool is_somewhere = false;
    for (toml::node& surface : *list) {
        toml::table* own = (*surface.as_table())["parameters"].as_table();
        if (!own || !own->contains(name)) continue;
        own->insert_or_assign(name, value);
        is_somewhere = true;
    }
    return is_somewhere && !shared_parameters(document).contains(name);
}

} // namespace isomotion::scene
