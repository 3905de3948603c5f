#include "scene/reading/scene_text.h"

#include <algorithm>
#include <sstream>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace isomotion::scene {
namespace {

constexpr std::string_view sections[] = {
    "title",     "time",    "surface",   "surfaces",    "parameters", "arrays",
    "isolation", "camera",  "lights",    "sections",    "material",   "ground",
    "fog",       "ambient", "occlusion", "environment", "output"};

std::string quoted(const std::string& text) {
    std::string all = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            all += fmt::format("\\{}", c);
        } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
            all += fmt::format("\\u{:04x}", c);
        } else {
            all += c;
        }
    }
    return all + '"';
}

std::string key_text(std::string_view key) {
    const bool is_bare = !key.empty() && std::ranges::all_of(key, [](char c) {
        return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') ||
               c == '_' || c == '-';
    });
    return is_bare ? std::string(key) : quoted(std::string(key));
}

// The shortest text of the number; 1.0 stays a floating one.
std::string number_text(double number) {
    const std::string text = fmt::format("{}", number);
    return text.find_first_not_of("-0123456789") == text.npos ? text + ".0" : text;
}

std::string value_text(const toml::node& node) {
    std::vector<std::string> parts;
    if (const toml::table* table = node.as_table()) {
        for (const auto& [key, value] : *table)
            parts.push_back(fmt::format("{} = {}", key_text(key.str()), value_text(value)));
        return parts.empty() ? "{}" : fmt::format("{{ {} }}", fmt::join(parts, ", "));
    }
    if (const toml::array* array = node.as_array()) {
        for (const toml::node& value : *array) parts.push_back(value_text(value));
        return fmt::format("[{}]", fmt::join(parts, ", "));
    }
    if (const auto text = node.value_exact<std::string>()) return quoted(*text);
    if (const auto number = node.value_exact<double>()) return number_text(*number);
    std::ostringstream other;
    node.visit([&](const auto& value) { other << value; });
    return other.str();
}

std::string entries(const toml::table& table) {
    std::string text;
    for (const auto& [key, value] : table)
        text += fmt::format("{} = {}\n", key_text(key.str()), value_text(value));
    return text;
}

// A key of the document with all that is in it.
std::string part_text(const std::string& key, const toml::node& node) {
    std::string text;
    const toml::table* table = node.as_table();
    const toml::array* array = node.as_array();
    if (table && key == "arrays") {
        for (const auto& [name, fields] : *table) {
            if (!fields.is_table()) return fmt::format("{} = {}\n", key, value_text(node));
            text += fmt::format("{}[arrays.{}]\n{}", text.empty() ? "" : "\n", key_text(name.str()),
                                entries(*fields.as_table()));
        }
    } else if (table) {
        text = fmt::format("[{}]\n{}", key_text(key), entries(*table));
    } else if (array && array->is_array_of_tables()) {
        for (const toml::node& one : *array) {
            text += fmt::format("{}[[{}]]\n{}", text.empty() ? "" : "\n", key_text(key),
                                entries(*one.as_table()));
        }
    } else {
        text = fmt::format("{} = {}\n", key_text(key), value_text(node));
    }
    return text;
}

} // namespace

std::string scene_text(const toml::table& root) {
    std::vector<std::string> parts;
    for (const std::string_view section : sections) {
        if (const toml::node* node = root.get(section))
            parts.push_back(part_text(std::string(section), *node));
    }
    return fmt::format("{}", fmt::join(parts, "\n"));
}

} // namespace isomotion::scene
