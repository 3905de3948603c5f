#include "formula/graph/parse_hints.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/nearest_name.h"
#include "formula/graph/spelling.h"
#include "formula/graph/utf8.h"

namespace isomotion::formula {
namespace {

// "x*y" for "xy", where x and y are known; else empty.
std::string as_product(std::string_view word, const std::vector<std::string>& known) {
    constexpr std::size_t longest = 4;
    std::string product;
    for (const char c : word) {
        const std::string letter(1, c);
        const bool is_again = product.find(c) != product.npos;
        if (is_again || std::ranges::count(known, letter) == 0) return "";
        product += (product.empty() ? "" : "*") + letter;
    }
    return word.size() > 1 && word.size() <= longest ? product : "";
}

bool is_digit(std::string_view text, std::size_t at) {
    return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at]));
}

std::string_view hint_for_sign(std::string_view sign) {
    const bool compares = sign == "<" || sign == ">" || sign == "≤" || sign == "≥";
    if (compares) return ": a comparison has a value on either side: a < b, a <= b";
    if (sign == "{") return ": write if(condition, a, b), or a condition: a and x > 0";
    if (sign == "!" || sign == "≠") return ": put the comparison in parentheses, (a != b)";
    if (sign == "‖") return ": write length(x, y, z)";
    // Letters of other alphabets.
    const bool is_greek = sign.size() == 2 && (sign.front() == '\xce' || sign.front() == '\xcf');
    if (is_greek) return ": names are of Latin letters, digits and _";
    return sign == "%" ? ": write mod(a, b) for the rest of a/b" : "";
}

} // namespace

std::string hint_for_unknown(std::string_view name, const std::vector<std::string>& known) {
    const std::string product = as_product(name, known);
    if (!product.empty()) return fmt::format("; a product is written '{}'", product);
    if (const std::string_view advice = advice_for(name); !advice.empty())
        return fmt::format("; {}", advice);
    const std::string near = base::nearest_name(name, known);
    return near.empty() ? fmt::format("; known: {}", fmt::join(known, ", "))
                        : fmt::format("; did you mean '{}'?", near);
}

std::string hint_for_call(std::string_view name, const std::vector<std::string>& known) {
    if (const std::string_view advice = advice_for(name); !advice.empty())
        return fmt::format("; {}", advice);
    const std::string near = base::nearest_name(name, known);
    return near.empty() ? "" : fmt::format("; did you mean '{}'?", near);
}

std::string message_for_unexpected(std::string_view text, std::size_t at) {
    if (at == text.size()) return "the formula ends too early";
    const char here = text[at];
    if (here == '=' && text.find_first_not_of(" \t\n\r") == at)
        return "a value is expected before '='";
    if (here == '=') return "unexpected '=': an expression has a value, and equals nothing";
    if (is_digit(text, at) || here == '|')
        return fmt::format("expected an operator before '{}'", here);
    if (here == ')' || here == ']') return fmt::format("this '{}' closes nothing", here);
    if (here == ';') return "unexpected ';': it stands behind definitions: name = expression;";
    if (here == ',' && at > 0 && is_digit(text, at - 1) && is_digit(text, at + 1))
        return "unexpected ',': numbers are written with a point, as 1.5";
    std::size_t length = 1; // a whole UTF-8 character
    while (at + length < text.size() && continues_character(text[at + length])) ++length;
    const std::string_view sign = text.substr(at, length);
    return fmt::format("unexpected '{}'{}", sign, hint_for_sign(sign));
}

} // namespace isomotion::formula
