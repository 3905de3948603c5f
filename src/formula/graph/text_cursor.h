// A place in a formula's text, which is read from its beginning to its end: signs and words as
// people write them, in plain text, LaTeX, Python, C, MATLAB or Mathematica.
#pragma once

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

enum class Comparison : unsigned char { less, at_most, greater, at_least, same, other };

class TextCursor {
public:
    explicit TextCursor(std::string_view text, std::size_t at = 0)
        : text_(text)
        , at_(at) {}

    char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    std::string_view rest() const { return text_.substr(at_); }
    std::string_view peek_name() const { return name_at(at_); }

    // Passes what stands for nothing: blanks of all kinds, and LaTeX's \left, \right and \,.
    void skip_space();

    bool accept(std::string_view characters) {
        if (!rest().starts_with(characters)) return false;
        at_ += characters.size();
        return true;
    }
    bool accept(char c) {
        if (peek() != c) return false;
        ++at_;
        return true;
    }

    // A name, without what stands before it: sin of \sin, np.sin, Math.sin and std::sin. `place`
    // becomes its own. Empty, and nothing is passed, where there is none.
    std::string_view accept_word(std::size_t& place);
    // Whether a word begins here, a backslash before it included.
    bool begins_word() const { return is_name_start(peek()) || begins_command(); }

    bool accept_minus() { return accept('-') || accept("−"); }
    bool accept_times();
    bool accept_over() { return accept('/') || accept("./") || accept("÷") || accept("\\div"); }
    bool accept_power() { return accept('^') || accept("**") || accept(".^"); }
    // A whole number of raised digits, as in x² and x⁻¹⁰. Stays where there is none.
    std::optional<int> accept_raised_number();
    // A character that is a fraction, as ½.
    std::optional<double> accept_fraction();
    // `enclosed`: within parentheses, where == and != compare. Elsewhere == makes an equation.
    std::optional<Comparison> accept_comparison(bool enclosed);
    // Whether a sign of comparison stands here.
    bool compares_here(bool enclosed) const {
        return TextCursor(text_, at_).accept_comparison(enclosed).has_value();
    }
    bool accept_equals() { return accept("==") || accept('='); }
    // What opens a list of arguments or a part of a formula: the character that closes it.
    std::optional<char> accept_opening();

    // What stands in the parentheses that begin here: how many parts, with commas between them, and
    // the place behind it. No parts where none begin.
    struct Group {
        int parts = 0;
        std::size_t end = 0;
    };
    Group group_ahead() const;

protected:
    std::string_view name_at(std::size_t at) const;
    bool begins_command() const {
        return peek() == '\\' && at_ + 1 < text_.size() && is_name_start(text_[at_ + 1]);
    }
    // Whether LaTeX's command `name`, with its backslash, stands here.
    bool is_command(std::string_view name) const {
        return rest().starts_with(name) && name_at(at_ + 1).size() + 1 == name.size();
    }
    bool accept_command(std::string_view name) { return is_command(name) && accept(name); }

    std::string_view text_;
    std::size_t at_;
};

} // namespace isomotion::formula
