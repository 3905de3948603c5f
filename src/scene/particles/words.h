// Words and lines of a text, from front to back.
#pragma once

#include <string_view>

#include "scene/particles/particle_table.h"

namespace isomotion::scene {

class Words {
public:
    // Starts at the byte `at`; lines are counted from the beginning of the text.
    Words(const ParticleRequest& request, std::string_view text, std::size_t at = 0)
        : request_(request)
        , text_(text)
        , at_(at) {}

    // The next word of the text; empty at its end.
    std::string_view next();
    // If the next word is this one, reads it and returns true.
    bool meets(std::string_view word);
    // The next word; fails at the end: "the file ends before `what`".
    std::string_view need(std::string_view what);
    // The remainder of the line, with its blanks, or without blanks around it; none at the end of
    // the text.
    std::optional<std::string_view> line_as_it_is();
    std::optional<std::string_view> rest_of_line();
    // Raw bytes.
    std::string_view take(std::size_t count, std::string_view what);

    double number(std::string_view column) { return number(need(column), column); }
    double number(std::string_view word, std::string_view column) const;
    // A count, 0 or more.
    std::size_t count(std::string_view what);

    // The line of the word or remainder read last. Raw bytes have no line.
    int line() const { return line_; }
    std::size_t at() const { return at_; }
    std::size_t left() const { return text_.size() - at_; }
    [[noreturn]] void fail(const std::string& message) const {
        fail_at_line(request_, line_, message);
    }

private:
    void begin_at(std::size_t begin);

    const ParticleRequest& request_;
    std::string_view text_;
    std::size_t at_;
    std::size_t counted_ = 0; // lines are counted up to here
    int line_ = 1;
};

// The number that a word states, or the reason why it isn't one, as "'2 m' is not a number".
struct Number {
    double value = 0;
    std::string wrong;
};
Number number_of(std::string_view word);

std::string_view trimmed(std::string_view text);

} // namespace isomotion::scene
