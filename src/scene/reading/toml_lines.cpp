#include "scene/reading/toml_lines.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

namespace isomotion::scene {
void TomlLines::put(std::size_t line, const std::string& key, const std::string& value) {
    if (line >= lines_.size() || !lines_[line].empty()) line = lines_.size();
    lines_.resize(std::max(lines_.size(), line + 1));
    lines_[line] = fmt::format("{} = {}", key, value);
}

std::string TomlLines::text() const { return fmt::format("{}\n", fmt::join(lines_, "\n")); }

std::string toml_text(const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c;
    }
    return quoted + '"';
}

std::string toml_text(const glm::dvec3& v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); }

bool names_word(std::string_view text, std::string_view name) {
    const auto is_of_word = [](char c, bool first) {
        return std::isalpha(static_cast<unsigned char>(c)) || c == '_' ||
               (!first && std::isdigit(static_cast<unsigned char>(c)));
    };
    for (std::size_t at = text.find(name); at != text.npos; at = text.find(name, at + 1)) {
        const std::size_t end = at + name.size();
        if (at > 0 && is_of_word(text[at - 1], true)) continue;
        if (end < text.size() && is_of_word(text[end], false)) continue;
        return true;
    }
    return false;
}

} // namespace isomotion::scene
