#include "scene/key_documents.h"

#include <regex>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "scene/renamed_keys.h"

namespace isomotion::scene {
namespace {

using Json = nlohmann::ordered_json;

// What keys of several sections take.
constexpr const char* definitions = R"({
  "ease": {
    "enum": ["linear", "smooth", "hold", "cubic"],
    "description": "How values go from key to key."
  },
  "animated": {
    "description": "A number, an expression of t (seconds) in quotes, or keys of time and value.",
    "anyOf": [
      {"type": "number"},
      {"type": "string"},
      {
        "type": "object",
        "properties": {
          "keys": {
            "type": "array",
            "minItems": 1,
            "items": {"type": "array", "minItems": 2, "maxItems": 2, "items": {"type": "number"}}
          },
          "ease": {"$ref": "#/definitions/ease"}
        },
        "additionalProperties": false,
        "required": ["keys"]
      }
    ]
  },
  "animatedVector": {
    "description": "[x, y, z] of animated values, or keys of time and [x, y, z].",
    "anyOf": [
      {
        "type": "array",
        "minItems": 3,
        "maxItems": 3,
        "items": {"$ref": "#/definitions/animated"}
      },
      {
        "type": "object",
        "properties": {
          "keys": {
            "type": "array",
            "minItems": 1,
            "items": {
              "type": "array",
              "minItems": 2,
              "maxItems": 2,
              "items": [
                {"type": "number"},
                {"type": "array", "minItems": 3, "maxItems": 3, "items": {"type": "number"}}
              ]
            }
          },
          "ease": {"$ref": "#/definitions/ease"}
        },
        "additionalProperties": false,
        "required": ["keys"]
      }
    ]
  },
  "color": {
    "$ref": "#/definitions/animatedVector",
    "description": "Red, green, blue; linear."
  },
  "stillColor": {
    "type": "array",
    "minItems": 3,
    "maxItems": 3,
    "items": {"type": "number"},
    "description": "Red, green, blue; linear."
  },
  "field": {
    "anyOf": [
      {"type": "number"},
      {"type": "string"},
      {"type": "array", "items": {"type": "number"}}
    ]
  },
  "parameter": {
    "anyOf": [
      {"$ref": "#/definitions/animated"},
      {
        "type": "object",
        "properties": {
          "default": {"$ref": "#/definitions/animated"},
          "min": {"type": "number"},
          "max": {"type": "number"}
        },
        "additionalProperties": false,
        "required": ["default"]
      }
    ]
  }
})";

constexpr std::string_view table_head = "| key | what it is | default |\n";

// The sections that one of several surfaces has of its own.
constexpr std::string_view of_each_surface[] = {"parameters", "arrays", "isolation", "material"};

Json reference(std::string_view to) { return {{"$ref", fmt::format("#/{}", to)}}; }

template<class Number> Json schema_of_range(const char* type, const KeyDescription& key) {
    Json schema = {{"type", type}};
    if (key.least) schema["minimum"] = Number(*key.least);
    if (key.most) schema["maximum"] = Number(*key.most);
    return schema;
}

Json schema_of(const KeyDescription& key) {
    Json schema;
    switch (key.type) {
    case KeyType::animated:
        schema = reference("definitions/animated");
        break;
    case KeyType::animated_vector:
        schema = reference("definitions/animatedVector");
        break;
    case KeyType::color:
        schema = reference("definitions/color");
        break;
    case KeyType::number:
        schema = schema_of_range<double>("number", key);
        break;
    case KeyType::integer:
        schema = schema_of_range<std::int64_t>("integer", key);
        break;
    case KeyType::truth:
        schema = {{"type", "boolean"}};
        break;
    case KeyType::word:
        schema = {{"enum", key.words}};
        break;
    case KeyType::other:
        schema = Json::parse(key.schema);
        break;
    }
    std::string description = plain_text(key.what);
    if (!key.otherwise.empty())
        description += fmt::format(". Default: {}", plain_text(key.otherwise));
    schema["description"] = description;
    return schema;
}

// Adds the key under its former name, too, if it has one.
void add_property(Json& properties, const std::string& section, const std::string& path,
                  const std::string& name, Json schema) {
    // A key of two models has one row for each.
    if (properties.contains(name)) {
        const auto words = [](const Json& of) { return of.at("description").get<std::string>(); };
        schema["description"] = words(properties[name]) + ". " + words(schema);
    }
    properties[name] = std::move(schema);
    const RenamedKey* renamed = renamed_key(section, name);
    if (!renamed) return;
    Json former = reference(path + "/properties/" + name);
    former["description"] = fmt::format("Former name of {}.", name);
    properties[std::string(renamed->before)] = std::move(former);
}

Json table_of(const SectionDescription& section, const std::string& path) {
    Json table = {{"type", "object"}};
    if (!section.what.empty()) table["description"] = plain_text(section.what);
    Json needed = Json::array();
    table["properties"] = Json::object();
    const std::string place = section.name == "arrays.NAME" ? "arrays.*" : section.name;
    for (const KeyDescription& key : section.keys) {
        add_property(table["properties"], place, path, key.name, schema_of(key));
        if (key.is_needed) needed.push_back(key.name);
    }
    table["additionalProperties"] = false;
    if (!needed.empty()) table["required"] = needed;
    return table;
}

// One of several surfaces has all keys of the one, and sections of its own.
void add_keys_of_surface(Json& listed, const Json& properties) {
    Json& own = listed["properties"];
    for (const auto& [name, schema] : properties.at("surface").at("properties").items())
        own[name] = reference("properties/surface/properties/" + name);
    for (const std::string_view section : of_each_surface)
        own[std::string(section)] = reference(fmt::format("properties/{}", section));
}

} // namespace

std::string plain_text(const std::string& markdown) {
    static const std::regex link(R"(\[([^\]]+)\]\([^)]+\))"), mark(R"(`|\\(?=\|)|\*(?=\w)|(\w)\*)");
    return std::regex_replace(std::regex_replace(markdown, link, "$1"), mark, "$1");
}

std::string schema_text(const std::vector<SectionDescription>& sections) {
    Json all = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                {"title", "isomotion scene"},
                {"description", "A scene file of isomotion: a surface F(x, y, z; parameters) = 0 "
                                "and how everything moves."},
                {"definitions", Json::parse(definitions)},
                {"type", "object"},
                {"additionalProperties", false},
                {"oneOf", Json::array({{{"required", {"surface"}}}, {{"required", {"surfaces"}}}})},
                {"properties", Json::object()}};
    Json& properties = all["properties"];
    for (const SectionDescription& section : sections) {
        const std::size_t dot = section.name.find('.');
        if (section.name.empty()) {
            for (const KeyDescription& key : section.keys) properties[key.name] = schema_of(key);
        } else if (section.name == "parameters") {
            properties["parameters"] = {
                {"type", "object"},
                {"description", "Names of the formula and their values."},
                {"additionalProperties", reference("definitions/parameter")}};
        } else if (section.name == "arrays.NAME") {
            all["definitions"]["array"] = table_of(section, "definitions/array");
            all["definitions"]["array"]["additionalProperties"] = reference("definitions/field");
            properties["arrays"] = {{"type", "object"},
                                    {"additionalProperties", reference("definitions/array")}};
        } else if (section.most > 0) {
            Json table = table_of(section, fmt::format("properties/{}/items", section.name));
            if (section.name == "surfaces") add_keys_of_surface(table, properties);
            properties[section.name] = {
                {"type", "array"}, {"minItems", 1}, {"maxItems", section.most}, {"items", table}};
        } else if (dot == std::string::npos) {
            properties[section.name] = table_of(section, "properties/" + section.name);
        } else {
            const std::string above = section.name.substr(0, dot),
                              name = section.name.substr(dot + 1);
            const std::string path = "properties/" + above;
            add_property(properties[above]["properties"], above, path, name,
                         table_of(section, path + "/properties/" + name));
        }
    }
    return all.dump(2) + "\n";
}

std::string key_table(const std::vector<SectionDescription>& sections) {
    std::string text = std::string(table_head) + "|---|---|---|\n";
    const auto add = [&](const std::string& key, const std::string& what,
                         const std::string& otherwise) {
        const auto cell = [](const std::string& words) { return words.empty() ? "" : words + " "; };
        text += fmt::format("| {} | {}| {}|\n", key, cell(what), cell(otherwise));
    };
    for (const SectionDescription& section : sections) {
        if (section.most > 0) {
            add(fmt::format("**`[[{}]]`**", section.name),
                fmt::format("up to {}{}{}", section.most, section.what.empty() ? "" : "; ",
                            section.what),
                section.otherwise);
        } else if (!section.name.empty()) {
            add(fmt::format("**`[{}]`**", section.name), section.what, section.otherwise);
        }
        for (const KeyDescription& key : section.keys) {
            add(fmt::format("`{}`", key.name), key.what,
                key.is_needed ? "must be given" : key.otherwise);
        }
    }
    return text;
}

std::string with_key_table(const std::string& page,
                           const std::vector<SectionDescription>& sections) {
    const std::size_t begin = page.find(table_head);
    const std::size_t end = page.find("\n\n", begin);
    if (begin == page.npos || end == page.npos)
        throw std::invalid_argument("the page has no table of keys");
    return page.substr(0, begin) + key_table(sections) + page.substr(end + 1);
}

} // namespace isomotion::scene
