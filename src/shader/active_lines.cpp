#include "shader/active_lines.h"

#include <algorithm>
#include <charconv>
#include <vector>

#include <fmt/format.h>

#include "base/input_error.h"
#include "shader/shader_code.h"

namespace isomotion::shader {
namespace {

std::string_view without_blanks(std::string_view text) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    return text;
}

// Whether the text begins so; then that is gone.
bool skip(std::string_view& text, std::string_view head) {
    text = without_blanks(text);
    if (!text.starts_with(head)) return false;
    text.remove_prefix(head.size());
    return true;
}

// A name or a number; empty if there is none.
std::string_view take_word(std::string_view& text) {
    text = without_blanks(text);
    std::size_t length = 0;
    while (length < text.size() && is_of_a_word(text[length])) ++length;
    const std::string_view word = text.substr(0, length);
    text.remove_prefix(length);
    return word;
}

// Whether a macro is the compiler's.
bool is_of_compilers(std::string_view name) {
    return name.starts_with("GL_") || name.starts_with("__");
}

// A condition's value, by its grammar: any of all of terms.
class Condition {
public:
    Condition(std::string_view text, Features& features)
        : rest_(text)
        , features_(features) {}

    bool holds() {
        const bool value = any();
        if (!without_blanks(rest_).empty()) fail(fmt::format("unexpected '{}'", rest_));
        return value;
    }

    Feature feature() {
        const std::string_view name = take_word(rest_);
        const auto known = feature_of(name);
        if (!known) {
            const std::string nearest = nearest_feature(name);
            fail(fmt::format("'{}' is no feature{}", name,
                             nearest.empty() ? "" : ", nearest " + nearest));
        }
        return *known;
    }

private:
    bool any() {
        bool value = all();
        while (skip(rest_, "||")) value = all() || value;
        return value;
    }

    bool all() {
        bool value = term();
        while (skip(rest_, "&&")) value = term() && value;
        return value;
    }

    bool term() {
        if (skip(rest_, "!")) return !term();
        if (skip(rest_, "(")) return closed(any());
        if (skip(rest_, "defined(")) return closed(features_.has(feature()));
        const int left = features_.value(feature());
        if (skip(rest_, "==")) return left == number();
        if (skip(rest_, "!=")) return left != number();
        if (skip(rest_, "<=")) return left <= number();
        if (skip(rest_, ">=")) return left >= number();
        if (skip(rest_, "<")) return left < number();
        if (skip(rest_, ">")) return left > number();
        return left != 0;
    }

    bool closed(bool value) {
        if (!skip(rest_, ")")) fail("')' is missing");
        return value;
    }

    int number() {
        const std::string_view word = take_word(rest_);
        int value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc() || end != word.data() + word.size())
            fail(fmt::format("'{}' is no whole number", word));
        return value;
    }

    [[noreturn]] static void fail(const std::string& message) { throw base::InputError(message); }

    std::string_view rest_;
    Features& features_;
};

// Whether a condition asks for macros of compilers.
bool asks_compilers(std::string_view condition) {
    while (!condition.empty()) {
        const std::string_view word = take_word(condition);
        if (is_of_compilers(word)) return true;
        if (word.empty() && !condition.empty()) condition.remove_prefix(1);
    }
    return false;
}

class ActiveLines {
public:
    explicit ActiveLines(Features& features)
        : features_(features) {}

    void add(std::string_view line) {
        std::string_view rest = line;
        const bool is_directive = skip(rest, "#");
        const std::string_view directive = take_word(rest);
        if (!is_directive || !decides(directive, rest.substr(0, rest.find("//")))) keep(line);
    }

    std::string finished() && {
        if (!open_.empty()) throw base::InputError("#endif is missing");
        return std::move(text_);
    }

private:
    // From an #if on.
    struct Level {
        bool is_of_compilers, is_active, was_active, is_last = false;
    };

    bool is_active() const { return open_.empty() || open_.back().is_active; }

    void keep(std::string_view line) {
        if (is_active()) text_.append(line).append("\n");
    }

    // Whether a directive is a condition on features, which it then follows.
    bool decides(std::string_view directive, std::string_view condition) {
        if (directive == "if" || directive == "ifdef" || directive == "ifndef") {
            begin(directive, condition);
            return !open_.back().is_of_compilers;
        }
        if (directive != "elif" && directive != "else" && directive != "endif") return false;
        if (open_.empty()) throw base::InputError(fmt::format("#{} without #if", directive));
        Level& level = open_.back();
        if (directive == "endif") return end();
        if (level.is_last) throw base::InputError(fmt::format("#{} after #else", directive));
        level.is_last = directive == "else";
        if (level.is_of_compilers) return false;
        const bool may_hold = !level.was_active && is_outside_active();
        level.is_active = level.is_last ? may_hold : answer(condition, may_hold);
        level.was_active |= level.is_active;
        return true;
    }

    // Whether a condition holds that `counts`; any other is only read.
    bool answer(std::string_view condition, bool counts) {
        Features unasked;
        return Condition(condition, counts ? features_ : unasked).holds() && counts;
    }

    void begin(std::string_view directive, std::string_view condition) {
        const bool is_theirs = asks_compilers(condition);
        const bool counts = is_active();
        const bool holds = is_theirs           ? counts
                           : directive == "if" ? answer(condition, counts)
                           : directive == "ifdef"
                               ? answer(fmt::format("defined({})", condition), counts)
                               : answer(fmt::format("!defined({})", condition), counts);
        open_.push_back({is_theirs, holds, holds});
    }

    bool end() {
        const Level closed = open_.back();
        open_.pop_back();
        if (closed.is_of_compilers) keep("#endif");
        return true;
    }

    bool is_outside_active() const { return open_.size() < 2 || open_[open_.size() - 2].is_active; }

    Features& features_;
    std::vector<Level> open_;
    std::string text_;
};

} // namespace

std::string active_lines(std::string_view file, std::string_view text, Features& features) {
    ActiveLines lines(features);
    int number = 0;
    try {
        while (!text.empty()) {
            const std::string_view line = text.substr(0, text.find('\n'));
            ++number;
            lines.add(line);
            text.remove_prefix(std::min(line.size() + 1, text.size()));
        }
        return std::move(lines).finished();
    } catch (const base::InputError& error) {
        throw base::InputError(fmt::format("shaders/{}:{}: {}", file, number, error.what()));
    }
}

} // namespace isomotion::shader
