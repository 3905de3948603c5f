#include "topology/timeline/statement.h"

#include <algorithm>
#include <charconv>
#include <climits>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "base/nearest_name.h"
#include "formula/graph/vocabulary.h"
#include "topology/timeline/words.h"

namespace isomotion::topology {
namespace {

[[noreturn]] void refuse(const std::string& message) { throw std::invalid_argument(message); }

std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words;
    std::string word;
    for (const char c : text) {
        if (c != ' ' && c != '\t') {
            word += c;
        } else if (!word.empty()) {
            words.push_back(std::move(word));
            word.clear();
        }
    }
    if (!word.empty()) words.push_back(std::move(word));
    return words;
}

std::optional<int> whole(std::string_view word) {
    int number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc{} || end != word.data() + word.size() || number < 0) return {};
    return number;
}

// How many decimals there are in what was written, or nothing if it is no number.
struct Written {
    double value = 0;
    int decimals = 0;
};
std::optional<Written> written(std::string_view word) {
    if (word.empty() || word.front() == '.') return {}; // "12...13" has a dot too many
    Written number;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number.value,
                                              std::chars_format::fixed);
    if (error != std::errc{} || end != word.data() + word.size()) return {};
    if (!std::isfinite(number.value)) return {};
    const std::size_t point = word.find('.');
    if (point != word.npos) number.decimals = int(word.size() - point - 1);
    return number;
}

struct Named {
    std::string words;
    std::optional<Kind> kind;
};

// "merge", "merges", "tunnel closes", "tunnels close", "event", "events".
const std::vector<Named>& names() {
    static const std::vector<Named> known = [] {
        std::vector<Named> all{{"event", {}}, {"events", {}}};
        for (int k = int(Kind::birth); k < int(Kind::none); ++k) {
            all.push_back({std::string(name(Kind(k))), Kind(k)});
            if (const std::string many = plural(Kind(k)); many != all.back().words) {
                all.push_back({many, Kind(k)});
            }
        }
        return all;
    }();
    return known;
}

class Parser {
public:
    Parser(std::string_view text, animation::FrameRate fps)
        : words_(words_of(text))
        , fps_(fps) {
        result_.text = text;
    }

    Statement parse() {
        if (words_.empty()) refuse("is empty; write what happens: \"merge at frame 12..13\"");
        if (take("nothing")) {
            if (!take("else") || !done()) refuse("did you mean \"nothing else\"?");
            result_.is_nothing_else = true;
            return std::move(result_);
        }
        number();
        events();
        if (!done()) when();
        return std::move(result_);
    }

private:
    bool done() const { return next_ == words_.size(); }
    std::string peek() const { return done() ? "" : words_[next_]; }
    bool take(std::string_view word) {
        if (done() || words_[next_] != word) return false;
        ++next_;
        return true;
    }

    int count(const std::string& after) {
        const auto number = whole(peek());
        if (!number) refuse(fmt::format("'{}' needs a whole number: {} 3 merges", after, after));
        ++next_;
        return *number;
    }
    void number() {
        if (take("a") || take("an")) return;
        if (take("no")) {
            result_.least = result_.most = 0;
        } else if (take("at")) {
            if (take("least")) {
                result_.least = count("at least");
                result_.most = INT_MAX;
            } else if (take("most")) {
                result_.most = count("at most");
                result_.least = 0;
            } else {
                refuse("what happens comes before when: \"merge at frame 12\"; or \"at least 3\"");
            }
        } else if (const std::size_t dots = peek().find(".."); dots != std::string::npos) {
            const std::string word = peek();
            const auto least = whole(std::string_view(word).substr(0, dots));
            const auto most = whole(std::string_view(word).substr(dots + 2));
            if (!least || !most || *least > *most) {
                refuse(fmt::format("'{}' is no range of numbers; write 2..4", word));
            }
            result_.least = *least;
            result_.most = *most;
            ++next_;
        } else if (const auto number = whole(peek())) {
            result_.least = result_.most = *number;
            ++next_;
        }
    }

    void events() {
        if (done()) refuse("says no event; write \"3 merges\"");
        const std::string one = peek();
        const std::string two = next_ + 1 < words_.size() ? one + " " + words_[next_ + 1] : one;
        std::vector<std::string> candidates;
        for (const Named& known : names()) {
            candidates.push_back(known.words);
            if (known.words != two && known.words != one) continue;
            result_.kind = known.kind;
            next_ += known.words == one ? 1 : 2;
            return;
        }
        const bool is_pair = one.starts_with("tunnel") || one.starts_with("void");
        const std::string wrong = is_pair ? two : one;
        const std::string nearest = base::nearest_name(wrong, candidates);
        refuse(fmt::format("there is no event '{}'; {}", wrong,
                           nearest.empty() ? fmt::format("known: {}", known_kinds())
                                           : fmt::format("did you mean '{}'?", nearest)));
    }
    static std::string known_kinds() {
        std::string all = "event";
        for (int k = int(Kind::birth); k < int(Kind::none); ++k) {
            all += fmt::format(", {}", name(Kind(k)));
        }
        return all;
    }

    // "frame", or "time": what numbers count.
    void unit(bool is_between) {
        if (take(is_between ? "frames" : "frame")) return;
        if (take(is_between ? "times" : "time")) {
            in_seconds_ = true;
            return;
        }
        refuse(fmt::format("'{}' is not what a time begins with; write \"{}\"", peek(),
                           is_between ? "between frames 5 and 9" : "at frame 12"));
    }
    Written when_number() {
        const auto number = written(peek());
        if (!number) {
            refuse(done() ? std::string("ends where a number should be: \"at frame 12\"")
                          : fmt::format("'{}' is no number: write 12 or 40.2", peek()));
        }
        ++next_;
        return *number;
    }
    double to_frame(double number) const {
        const double frame = in_seconds_ ? frame_at(fps_, number) : number;
        if (!std::isfinite(frame)) refuse(fmt::format("{:g} s is no time of an animation", number));
        return frame;
    }
    void span(double from, double to) {
        if (from > to) refuse(fmt::format("ends before it begins: {} to {}", from, to));
        result_.asked = {to_frame(from), to_frame(to)};
        // An event at the very end is in it, however its time was rounded.
        constexpr double slack = 1e-6;
        result_.frames = {result_.asked.lo - slack, result_.asked.hi + slack};
    }

    void when() {
        if (take("at")) {
            at();
        } else if (take("between")) {
            unit(true);
            const double from = when_number().value;
            if (!take("and")) refuse("write \"between frames 5 and 9\"");
            span(from, when_number().value);
        } else if (take("before")) {
            unit(false);
            result_.frames = result_.asked = {-formula::infinity, to_frame(when_number().value)};
        } else if (take("after")) {
            unit(false);
            result_.frames = result_.asked = {to_frame(when_number().value), formula::infinity};
        } else {
            refuse(fmt::format("'{}' is not when; write \"at frame 12\", \"at frame 12..13\", "
                               "\"between frames 5 and 9\", \"before frame 7\", \"after frame 90\"",
                               peek()));
        }
        if (in_seconds_) take("s");
        if (!done()) refuse(fmt::format("goes on after its end, at '{}'", peek()));
    }
    void at() {
        if (take("frames")) {
            --next_;
            words_[next_] = "frame"; // "at frames 12..13" is as clear
        }
        unit(false);
        const std::string word = peek();
        const std::size_t dots = word.find("..");
        if (dots == std::string::npos) {
            const Written number = when_number();
            const double half = 0.5 * std::pow(10, -number.decimals);
            span(number.value - half, number.value + half);
            return;
        }
        const auto from = written(std::string_view(word).substr(0, dots));
        const auto to = written(std::string_view(word).substr(dots + 2));
        if (!from || !to) refuse(fmt::format("'{}' is no range: write 12..13", word));
        ++next_;
        span(from->value, to->value);
    }

    std::vector<std::string> words_;
    std::size_t next_ = 0;
    animation::FrameRate fps_;
    bool in_seconds_ = false;
    Statement result_;
};

} // namespace

Statement parse_statement(std::string_view text, animation::FrameRate fps) {
    return Parser(text, fps).parse();
}

} // namespace isomotion::topology
