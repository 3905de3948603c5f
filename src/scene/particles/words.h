// Words and lines of a text, from front to back.
#pragma once

#include <string_view>

#include "scene/particles/particle_table.h"

namespace isomotion::scene {

class Words {
public:
    // From the byte `at` on; lines are those of the whole text.
    Words(const ParticleRequest& request, std::string_view text, std::size_t at = 0)
        : request_(request)
        , text_(text)
        , at_(at) {}

    // The next word of the text; empty at its end.
    std::string_view next();
    // Whether the next word is this one, which then is read.
    bool meets(std::string_view word);
    // Fails at the end: "the file ends before `what`".
    std::string_view need(std::string_view what);
    // What is left of the line, without blanks around it; none at the end of the text.
    std::optional<std::string_view> rest_of_line();
    // Bytes as they are.
    std::string_view take(std::size_t count, std::string_view what);

    double number(std::string_view column) { return number(need(column), column); }
    double number(std::string_view word, std::string_view column) const;
    // A count of things.
    std::size_t count(std::string_view what);

    // The line of the word, or of the rest, that was read last. Bytes that were taken have none.
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
    std::size_t counted_ = 0; // up to there lines are
    int line_ = 1;
};

// The number that a word is, or why it is none, as "'2 m' is not a number".
struct Number {
    double value = 0;
    std::string wrong;
};
Number number_of(std::string_view word);

std::string_view trimmed(std::string_view text);

} // namespace isomotion::scene
