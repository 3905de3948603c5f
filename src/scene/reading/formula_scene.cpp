#include "scene/reading/formula_scene.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <vector>

#include "base/printable.h"
#include "formula/graph/spelling.h"
#include "formula/graph/vocabulary.h"
#include "scene/reading/formula_words.h"

namespace isomotion::scene {
namespace {

// The title of a window and a page; for a long formula, its beginning.
std::string title_of(std::string_view formula) {
    constexpr std::size_t longest = 200; // bytes
    std::string title;
    for (const char c : formula) {
        const bool is_space = std::isspace(static_cast<unsigned char>(c));
        if (!is_space)
            title += c;
        else if (!title.empty() && title.back() != ' ')
            title += ' ';
    }
    if (title.ends_with(' ')) title.pop_back();
    if (title.size() > longest) {
        std::size_t end = longest;
        // Whole characters.
        while (end > 0 && (static_cast<unsigned char>(title[end]) & 0xc0) == 0x80) --end;
        title = title.substr(0, end) + "...";
    }
    return base::printable_line(title);
}

// Whether something without an operator is still a formula: "2x", "x y z", "sin x", "3", "x - y".
// Files and animations have names of other words.
bool is_made_of_known_words(std::string_view name) {
    constexpr std::string_view signs = " .-/,{}[];²³·−½¼¾";
    const bool is_plain = std::ranges::all_of(name, [&](unsigned char c) {
        return std::isalnum(c) || c == '_' || signs.find(char(c)) != signs.npos;
    });
    const bool has_digit =
        std::ranges::any_of(name, [](unsigned char c) { return std::isdigit(c); });
    const auto is_coordinate = [](std::string_view word) {
        const std::string plain = formula::plain_spelling(word);
        return std::ranges::all_of(plain, [](const char& c) {
            return std::ranges::count(formula::coordinate_names, std::string_view(&c, 1)) > 0;
        });
    };
    const std::vector<Word> words = words_of(name);
    const bool are_known = std::ranges::all_of(words, [&](const Word& word) {
        return word.text.size() == 1 || formula::is_reserved(formula::plain_spelling(word.text)) ||
               is_coordinate(word.text);
    });
    const bool has_place = std::ranges::any_of(words, is_coordinate, &Word::text);
    return is_plain && are_known && (has_place || (words.empty() && has_digit));
}

// NAME=EXPRESSION with the time in it.
bool moves_something(std::string_view setting) {
    const std::size_t equals = setting.find('=');
    return equals != setting.npos && names_time(setting.substr(equals + 1));
}

} // namespace

bool is_formula(const std::string& name) {
    const auto extension = std::filesystem::path(name).extension();
    constexpr std::array<std::string_view, 5> files{".toml", ".jsurf", ".pov", ".js", ".json"};
    if (std::ranges::count(files, extension.string()) > 0) return false;
    constexpr std::array<std::string_view, 5> signs{"≤", "≥", "≠", "√", "\\"};
    const auto is_in_name = [&](std::string_view sign) { return name.find(sign) != name.npos; };
    return name.find_first_of("=^*+()|<>%") != name.npos ||
           std::ranges::any_of(signs, is_in_name) || is_made_of_known_words(name);
}

toml::table scene_of_formula(const std::string& formula, std::span<const std::string> settings) {
    toml::table root{{"title", title_of(formula)}};
    if (names_time(formula) || std::ranges::any_of(settings, moves_something)) {
        toml::table time{{"fps", 30}};
        const auto tells_seconds = [](const std::string& setting) {
            return setting.starts_with("time.seconds=");
        };
        if (std::ranges::none_of(settings, tells_seconds)) time.insert("frames", 120);
        root.insert("time", time);
    }
    root.insert("surface", toml::table{{"formula", formula}});
    return root;
}

} // namespace isomotion::scene
