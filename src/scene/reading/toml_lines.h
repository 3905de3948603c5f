// TOML converted from other programs' scene files, with each key in the line that it comes from.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

namespace isomotion::scene {

// Keys with values, each on its own line.
class TomlLines {
public:
    explicit TomlLines(std::size_t count)
        : lines_(count) {}

    // Counts lines from 0. If the line is taken or beyond the last, the key goes after all others.
    void put(std::size_t line, const std::string& key, const std::string& value);
    std::string text() const;

private:
    std::vector<std::string> lines_;
};

// Values in TOML's notation.
std::string toml_text(const std::string& text);
std::string toml_text(const glm::dvec3& v);

// Whether the name occurs as a whole word: a in "2a*x", not in "tan(x)".
bool names_word(std::string_view text, std::string_view name);

} // namespace isomotion::scene
