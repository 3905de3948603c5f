// Describes all keys of a scene file, for documents and editors.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace isomotion::scene {

// What a key takes.
enum class KeyType { animated, animated_vector, color, number, integer, truth, word, other };

struct KeyDescription {
    explicit KeyDescription(std::string its_name, KeyType its_type = KeyType::other)
        : name(std::move(its_name))
        , type(its_type) {}

    std::string name;
    KeyType type;
    std::optional<double> least, most; // of a still number
    std::vector<std::string> words;    // of a word
    std::string schema;                // of another type: its JSON schema
    bool is_needed = false;
    std::string what, otherwise; // Markdown of one line; `otherwise` is its default
};

// A table of a scene file, or a list of tables.
struct SectionDescription {
    std::string name; // dotted, "material.contours"; empty for keys above all sections
    int most = 0;     // of a list: how many tables
    std::string what = {}, otherwise = {};
    std::vector<KeyDescription> keys = {};
};

// In the order in which documents tell them.
std::vector<SectionDescription> key_sections();

} // namespace isomotion::scene
