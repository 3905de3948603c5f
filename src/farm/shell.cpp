#include "farm/shell.h"

#include <algorithm>

namespace isomotion::farm {
namespace {

// Not `~` and `#`, which mean something at a word's beginning, nor bytes of other alphabets.
constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                   "_-+./,:=@%";

} // namespace

std::string shell_word(std::string_view word) {
    if (!word.empty() && word.find_first_not_of(plain) == word.npos) return std::string(word);
    std::string text = "'";
    for (const char c : word) {
        switch (c) {
        case '\'':
            text += "'\\''";
            break;
        case '\n':
            text += "'\"$nl\"'";
            break;
        default:
            text += c;
        }
    }
    return text + "'";
}

std::string newline_definition(std::span<const std::string> words) {
    const bool needed = std::ranges::any_of(
        words, [](const std::string& word) { return word.find('\n') != word.npos; });
    return needed ? "nl=$(printf '\\n_'); nl=${nl%_}; " : "";
}

std::string command_line(std::span<const std::string> words) {
    std::string line = newline_definition(words);
    for (const std::string& word : words) {
        if (&word != words.data()) line += ' ';
        line += shell_word(word);
    }
    return line;
}

} // namespace isomotion::farm
