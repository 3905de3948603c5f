#include "scene/reading/formula_words.h"

#include <algorithm>
#include <cctype>

namespace isomotion::scene {
namespace {

// t = ...; or t(u) = ...; where a statement begins.
bool is_defined(std::string_view formula, const Word& word) {
    constexpr const char* blanks = " \t\r\n";
    const std::size_t before = formula.substr(0, word.at).find_last_not_of(blanks);
    if (before != formula.npos && formula[before] != ';') return false;
    std::size_t next = formula.find_first_not_of(blanks, word.at + word.text.size());
    if (next != formula.npos && formula[next] == '(')
        next = formula.find_first_not_of(blanks,
                                         std::min(formula.find(')', next), formula.size() - 1) + 1);
    return next != formula.npos && formula[next] == '=' && formula.find(';', next) != formula.npos;
}

} // namespace

std::vector<Word> words_of(std::string_view formula) {
    const auto is_digit = [&](std::size_t k) {
        return k < formula.size() && std::isdigit(static_cast<unsigned char>(formula[k]));
    };
    const auto is_letter = [&](std::size_t k) {
        return k < formula.size() &&
               (std::isalpha(static_cast<unsigned char>(formula[k])) || formula[k] == '_');
    };
    std::vector<Word> words;
    for (std::size_t k = 0; k < formula.size();) {
        if (is_letter(k)) {
            std::size_t end = k;
            while (is_letter(end) || is_digit(end)) ++end;
            words.push_back({k, formula.substr(k, end - k)});
            k = end;
            continue;
        }
        const bool is_number = is_digit(k);
        ++k;
        if (!is_number) continue;
        while (is_digit(k) || (k < formula.size() && formula[k] == '.')) ++k;
        if (k >= formula.size() || (formula[k] != 'e' && formula[k] != 'E')) continue;
        const bool is_signed =
            k + 1 < formula.size() && (formula[k + 1] == '+' || formula[k + 1] == '-');
        if (is_digit(k + 1 + std::size_t(is_signed))) k += 2;
        while (is_digit(k)) ++k;
    }
    return words;
}

bool names_time(std::string_view formula) {
    const std::vector<Word> words = words_of(formula);
    const auto is_time = [](const Word& word) { return word.text == "t"; };
    return std::ranges::any_of(words, is_time) &&
           std::ranges::none_of(
               words, [&](const Word& word) { return is_time(word) && is_defined(formula, word); });
}

} // namespace isomotion::scene
