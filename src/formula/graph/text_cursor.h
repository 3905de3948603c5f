// A place in a text that is read from its beginning to its end.
#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string_view>

namespace isomotion::formula {

inline bool is_name_start(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) || c == '_';
}
inline bool is_name_part(char c) {
    return is_name_start(c) || std::isdigit(static_cast<unsigned char>(c));
}

class TextCursor {
public:
    explicit TextCursor(std::string_view text, std::size_t at = 0)
        : text_(text)
        , at_(at) {}

    char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    std::string_view peek_name() const {
        if (!is_name_start(peek())) return {};
        std::size_t end = at_ + 1;
        while (end < text_.size() && is_name_part(text_[end])) ++end;
        return text_.substr(at_, end - at_);
    }
    void skip_space() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }
    bool accept(std::string_view characters) {
        if (!text_.substr(at_).starts_with(characters)) return false;
        at_ += characters.size();
        return true;
    }
    bool accept(char c) {
        if (peek() != c) return false;
        ++at_;
        return true;
    }

    // A whole number of raised digits, as in x² and x⁻¹⁰. Stays where there is none.
    std::optional<int> accept_raised_number() {
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
    // "<", "<=", ">" or ">=".
    std::string_view accept_comparison() {
        skip_space();
        if (accept("<=") || accept("≤")) return "<=";
        if (accept(">=") || accept("≥")) return ">=";
        return accept('<') ? "<" : accept('>') ? ">" : "";
    }

protected:
    std::string_view text_;
    std::size_t at_;
};

} // namespace isomotion::formula
