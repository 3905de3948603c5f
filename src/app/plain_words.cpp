#include "app/plain_words.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/nearest_name.h"
#include "base/printable.h"
#include "farm/shell.h"
#include "scene/data_folder.h"

namespace isomotion::app {
namespace {

const CommandText* find(const CommandTree& tree, const std::string& name) {
    const auto found = std::ranges::find(tree.commands, name, &CommandText::name);
    return found == tree.commands.end() ? nullptr : &*found;
}

// Signs that no file's name and no option needs.
bool looks_like_formula(const std::string& word) {
    return word.find_first_of("^*+=()|<>%") != word.npos;
}

bool looks_like_scene(const std::string& word) {
    const auto extension = std::filesystem::path(word).extension();
    if (extension == ".toml" || extension == ".jsurf" || extension == ".pov" ||
        extension == ".js" || extension == ".json" || looks_like_formula(word))
        return true;
    return std::ranges::count(scene::animation_names(), word) > 0;
}

// "-x^2 - y^2 + 1": no option of one letter has a name that a formula begins with.
bool is_formula_with_minus(const std::string& word) {
    return word.size() > 1 && word[0] == '-' && word[1] != '-' && word[1] != 'o' &&
           word[1] != 'h' && looks_like_formula(word);
}

// A formula that begins with a minus goes behind all options, where -- says that it is none.
std::vector<std::string> with_formula_last(std::vector<std::string> words) {
    const auto formula = std::ranges::find_if(words, is_formula_with_minus);
    if (formula == words.end() || formula == words.begin()) return words;
    if (std::prev(formula)->starts_with('-')) return words; // an option's value
    if (std::ranges::count(words, "--") > 0) return words;
    std::string last = std::move(*formula);
    words.erase(formula);
    words.emplace_back("--");
    words.push_back(std::move(last));
    return words;
}

std::string line_in_quotes(const std::string& word) {
    const std::string one_line = base::printable_line(word);
    return farm::shell_word(one_line);
}

} // namespace

std::string first_words() {
    return "isomotion renders implicit surfaces that move: you give a formula F(x, y, z) = 0, or "
           "a\n"
           "scene file with one, and it draws every frame from the formula alone, without a mesh.\n"
           "\n"
           "  isomotion play blobby75                                   an animation, in a window\n"
           "  isomotion render 'x^4 + y^4 + z^4 = 1' -o cube.png        a formula, as a picture\n"
           "  isomotion new ring                                        a scene file to start "
           "from\n"
           "\n"
           "isomotion --help lists all commands, isomotion COMMAND --help tells of one;\n"
           "isomotion list names the animations that come with the program.\n";
}

std::vector<std::string> understood(std::vector<std::string> words, const CommandTree& tree) {
    if (words.empty()) return words;
    if (words.front() == "help") {
        words.erase(words.begin());
        words.resize(std::min<std::size_t>(words.size(), 1));
        words.emplace_back("--help");
    } else if (words.size() == 2 && words.back() == "help" && find(tree, words.front())) {
        words.back() = "--help";
    }
    return with_formula_last(std::move(words));
}

std::string why_no_command(const std::vector<std::string>& words, const CommandTree& tree) {
    if (words.empty() || words.front().starts_with('-') || find(tree, words.front())) return "";
    const std::string& word = words.front();
    if (word == "describe") return ""; // hidden
    if (looks_like_scene(word)) {
        return fmt::format("{0} is a scene; name a command before it:\n"
                           "    isomotion play {0}      in a window\n"
                           "    isomotion render {0}    into files\n"
                           "isomotion --help lists all commands\n",
                           line_in_quotes(word));
    }
    std::vector<std::string> names;
    for (const CommandText& command : tree.commands) names.push_back(command.name);
    const std::string near = base::nearest_name(word, names);
    return fmt::format("there is no command '{}'; {}\nisomotion --help tells of each\n",
                       base::printable_line(word),
                       near.empty() ? fmt::format("known: {}", fmt::join(names, ", "))
                                    : fmt::format("did you mean '{}'?", near));
}

std::string why_left_over(const std::vector<std::string>& words, const CommandText& command) {
    std::string text;
    std::vector<std::string> names;
    for (const OptionText& option : command.options) {
        if (!option.positional) names.insert(names.end(), option.names.begin(), option.names.end());
    }
    names.emplace_back("--help");
    const bool is_formula = std::ranges::any_of(words, [](const auto& word) {
        return !word.starts_with("--") && looks_like_formula(word);
    });
    for (const std::string& word : words) {
        if (!word.starts_with("--") || word == "--") continue;
        const std::string name = word.substr(0, word.find('='));
        const std::string near = base::nearest_name(name, names);
        text += fmt::format(
            "{}: isomotion {} has no such option; {}\n", base::printable_line(name), command.name,
            near.empty() ? fmt::format("isomotion {} --help lists those it has", command.name)
                         : fmt::format("did you mean '{}'?", near));
    }
    if (!text.empty()) return text;
    const std::string first = base::printable_line(words.empty() ? "" : words.front());
    if (is_formula) {
        return fmt::format(
            "'{0}': write a formula in quotes, and -- before one that begins with -:\n"
            "    isomotion {1} 'x^2 + y^2 + z^2 = 1'\n"
            "    isomotion {1} -- '-x^2 - y^2 + z^2 = 1'\n"
            "isomotion {1} --help tells of the rest\n",
            first, command.name);
    }
    return fmt::format(
        "'{0}' is one word too many for isomotion {1}; isomotion {1} --help tells what "
        "it takes\n",
        first, command.name);
}

} // namespace isomotion::app
