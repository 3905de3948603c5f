// Reads JSON with the line of each value, as messages about scripts of MathMod name it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace isomotion::scene::mathmod {

struct JsonValue {
    enum class Kind { text, number, list, object, other };

    Kind kind = Kind::other;
    std::string text;              // of a text or a number
    std::vector<JsonValue> items;  // of a list; the values of an object
    std::vector<std::string> keys; // of an object, one for each item
    std::size_t line = 0;          // from 0

    // The value of a key; null if there is none. Of equal keys the last counts.
    const JsonValue* find(std::string_view key) const;
};

// Where a value stands, for messages.
struct JsonPlace {
    const std::filesystem::path* file;
    std::size_t line = 0; // from 0
    std::string key;

    [[noreturn]] void fail(std::string_view message) const;
};

// Line ends and tabs within texts, which JSON forbids and scripts have, are read as blanks.
JsonValue read_json(std::string_view text, const std::filesystem::path& file);

} // namespace isomotion::scene::mathmod
