#include "formula/graph/text_cursor.h"

#include <algorithm>
#include <array>

namespace isomotion::formula {

void TextCursor::skip_space() {
    // Blanks that browsers and typesetters write, and a sign of multiplication that is not seen.
    constexpr std::array<std::string_view, 9> blanks{"\u00a0", "\u2009", "\u202f", "\u2062", "\\,",
                                                     "\\;",    "\\:",    "\\!",    "\\ "};
    constexpr std::array<std::string_view, 4> commands{"\\left", "\\right", "\\quad",
                                                       "\\displaystyle"};
    const auto accepts = [this](std::string_view blank) { return accept(blank); };
    const auto accepts_command = [this](std::string_view name) { return accept_command(name); };
    do {
        at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
        const bool may_go_on = peek() == '\\' || static_cast<unsigned char>(peek()) >= 0x80;
        if (!may_go_on) return;
    } while (std::ranges::any_of(blanks, accepts) ||
             std::ranges::any_of(commands, accepts_command));
}

std::string_view TextCursor::name_at(std::size_t at) const {
    if (at >= text_.size() || !is_name_start(text_[at])) return {};
    std::size_t end = at + 1;
    while (end < text_.size() && is_name_part(text_[end])) ++end;
    return text_.substr(at, end - at);
}

std::string_view TextCursor::accept_word(std::size_t& place) {
    constexpr std::array<std::string_view, 7> modules{"np.",   "numpy.",         "math.",   "Math.",
                                                      "std::", "\\operatorname", "\\mathrm"};
    std::size_t at = at_;
    for (const std::string_view module : modules) {
        if (rest().starts_with(module)) at += module.size();
    }
    const bool is_braced = at > at_ && at < text_.size() && text_[at] == '{';
    if (is_braced || (at == at_ && begins_command())) ++at;
    const std::string_view word = name_at(at);
    const std::size_t end = at + word.size();
    if (word.empty() || (is_braced && (end >= text_.size() || text_[end] != '}'))) return {};
    place = at;
    at_ = end + std::size_t(is_braced);
    return word;
}

bool TextCursor::accept_times() {
    if (rest().starts_with("**")) return false;
    return accept('*') || accept("·") || accept("⋅") || accept("×") || accept("∗") ||
           accept(".*") || accept_command("\\cdot") || accept_command("\\times");
}

std::optional<int> TextCursor::accept_raised_number() {
    constexpr std::array<std::string_view, 10> digits{"⁰", "¹", "²", "³", "⁴",
                                                      "⁵", "⁶", "⁷", "⁸", "⁹"};
    constexpr int most = 1'000'000;
    const std::size_t begin = at_;
    const bool is_negative = accept("⁻");
    std::optional<int> number;
    const auto next_digit = [&] {
        return std::ranges::find_if(digits, [&](std::string_view d) { return accept(d); });
    };
    for (auto digit = next_digit(); digit != digits.end(); digit = next_digit())
        number = std::min(10 * number.value_or(0) + int(digit - digits.begin()), most);
    if (!number) at_ = begin;
    return number && is_negative ? -*number : number;
}

std::optional<double> TextCursor::accept_fraction() {
    if (accept("½")) return 0.5;
    if (accept("¼")) return 0.25;
    if (accept("¾")) return 0.75;
    if (accept("⅓")) return 1.0 / 3;
    if (accept("⅔")) return 2.0 / 3;
    return std::nullopt;
}

std::optional<Comparison> TextCursor::accept_comparison(bool enclosed) {
    skip_space();
    if (accept("<=") || accept("≤") || accept_command("\\le") || accept_command("\\leq"))
        return Comparison::at_most;
    if (accept(">=") || accept("≥") || accept_command("\\ge") || accept_command("\\geq"))
        return Comparison::at_least;
    if (enclosed &&
        (accept("!=") || accept("≠") || accept_command("\\ne") || accept_command("\\neq")))
        return Comparison::other;
    if (enclosed && accept("==")) return Comparison::same;
    if (accept('<') || accept_command("\\lt")) return Comparison::less;
    if (accept('>') || accept_command("\\gt")) return Comparison::greater;
    return std::nullopt;
}

std::optional<char> TextCursor::accept_opening() {
    if (accept('(')) return ')';
    if (accept('[')) return ']';
    return std::nullopt;
}

TextCursor::Group TextCursor::group_ahead() const {
    if (peek() != '(' && peek() != '[') return {};
    int depth = 0, parts = 1;
    for (std::size_t at = at_; at < text_.size(); ++at) {
        const char c = text_[at];
        if (c == '(' || c == '[') ++depth;
        if (c == ',' && depth == 1) ++parts;
        if ((c == ')' || c == ']') && --depth == 0) return {parts, at + 1};
    }
    return {};
}

} // namespace isomotion::formula
