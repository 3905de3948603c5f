// A place in a text that is read from its beginning to its end.
#pragma once

#include <algorithm>
#include <cctype>
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

protected:
    std::string_view text_;
    std::size_t at_;
};

} // namespace isomotion::formula
