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

void refuse_unknown_keys(const toml::table& surface, std::size_t index) {
    MistakeList mistakes;
    Section section(surface, fmt::format("surfaces[{}]", index + 1), mistakes);
    for (const char* known :
         {"name", "formula", "use", "bounds", "jumps", "transform", "placement"})
        section.find(known);
    for (const char* known : own_sections) section.find(known);
    section.refuse_rest();
    mistakes.throw_if_any();
}

std::string read_name(const toml::table& table, std::size_t index) {
    const toml::node* node = table.get("name");
    if (!node) return number_of(index);
    const std::string key = fmt::format("surfaces[{}].name", index + 1);
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

const toml::table& listed(const toml::table& document, std::size_t index) {
    return *document.get("surfaces")->as_array()->get(index)->as_table();
}

// What `own` has goes before; tables of `levels` levels are joined key by key.
void put_over(toml::table& shared, toml::table& own, int levels) {
    for (auto& [name, value] : own) {
        toml::table* below = shared[name.str()].as_table();
        if (levels > 1 && below && value.is_table()) {
            put_over(*below, *value.as_table(), levels - 1);
        } else {
            shared.insert_or_assign(name, std::move(value));
        }
    }
}

} // namespace

bool lists_surfaces(const toml::table& document) { return document.contains("surfaces"); }

std::vector<std::string> listed_names(const toml::table& document) {
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
        refuse_unknown_keys(listed(document, k), k);
        names.push_back(read_name(listed(document, k), k));
        if (std::ranges::count(names, names.back()) > 1)
            fail(*list->get(k), fmt::format("surfaces[{}].name", k + 1),
                 fmt::format("'{}' is the name of another surface", names.back()));
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

void keep_surface(toml::table& document, std::size_t index) {
    // Moved nodes keep their place in the file.
    toml::table own = std::move(*document["surfaces"].as_array()->get(index)->as_table());
    document.erase("surfaces");
    own.erase("name");
    for (const char* key : own_sections) {
        toml::node* part = own.get(key);
        if (!part) continue;
        toml::table* shared = document[key].as_table();
        if (shared && part->is_table()) {
            put_over(*shared, *part->as_table(), std::string_view(key) == "arrays" ? 2 : 1);
        } else {
            document.insert_or_assign(key, std::move(*part));
        }
        own.erase(key);
    }
    document.insert_or_assign("surface", std::move(own));
}

std::set<std::string> shared_parameters(const toml::table& document) {
    return keys_of(document["parameters"].as_table());
}

std::set<std::string> own_parameters(const toml::table& document, std::size_t index) {
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
