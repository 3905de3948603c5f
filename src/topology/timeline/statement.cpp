#include "topology/timeline/statement.h"

#include <algorithm>
#include <array>
#include <cctype>
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

// Simplifies words that a sentence may have: "No merges." is "no merges", "the end" is "end", "2
// seconds" is "2 s".
void simplify(std::vector<std::string>& words) {
    std::string* last = words.empty() ? nullptr : &words.back();
    if (last && last->size() > 1 && last->ends_with('.') && !last->ends_with(".."))
        last->pop_back();
    for (std::size_t k = 1; k < words.size(); ++k) {
        const bool is_seconds = words[k] == "seconds" || words[k] == "second" || words[k] == "sec";
        if (is_seconds && std::isdigit(static_cast<unsigned char>(words[k - 1][0]))) words[k] = "s";
    }
    for (std::size_t k = 0; k + 1 < words.size(); ++k) {
        if (words[k] == "the" && (words[k + 1] == "end" || words[k + 1] == "start"))
            words.erase(words.begin() + std::ptrdiff_t(k));
    }
}

// "40+-2" is three words, and "1.28s" two. Capitals are as small letters.
std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words;
    std::string word;
    const auto end_word = [&] {
        if (word.empty()) return;
        const bool has_unit = word.size() > 1 && word.back() == 's' &&
                              word.find_first_not_of("0123456789.") == word.size() - 1;
        if (has_unit) word.pop_back();
        words.push_back(std::move(word));
        if (has_unit) words.emplace_back("s");
        word.clear();
    };
    for (std::size_t k = 0; k < text.size(); ++k) {
        const std::string_view rest = text.substr(k);
        const std::string_view sign = rest.starts_with("+-")    ? "+-"
                                      : rest.starts_with("+/-") ? "+/-"
                                      : rest.starts_with("±")   ? "±"
                                                                : "";
        if (!sign.empty()) {
            end_word();
            words.emplace_back("+-");
            k += sign.size() - 1;
        } else if (text[k] == ' ' || text[k] == '\t') {
            end_word();
        } else {
            word += text[k] >= 'A' && text[k] <= 'Z' ? char(text[k] - 'A' + 'a') : text[k];
        }
    }
    end_word();
    simplify(words);
    return words;
}

// The number that a word says in digits or, up to twelve, in letters.
std::optional<int> whole(std::string_view word) {
    constexpr std::array<std::string_view, 13> names{"zero", "one",    "two",   "three", "four",
                                                     "five", "six",    "seven", "eight", "nine",
                                                     "ten",  "eleven", "twelve"};
    const auto named = std::ranges::find(names, word);
    if (named != names.end()) return int(named - names.begin());
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

// A frame, infinite where it is an end of what was searched.
struct Moment {
    double frame = 0;
    double half = 0; // of the last digit that was written, in frames
};

class Parser {
public:
    Parser(std::string_view text, animation::FrameRate fps, std::optional<double> tolerance)
        : words_(words_of(text))
        , fps_(fps)
        , tolerance_(tolerance) {
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
        place();
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
        const bool is_exact = take("exactly");
        if (is_exact && !whole(peek()))
            refuse(fmt::format("'exactly' needs a whole number: exactly 3 merges"));
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

    void place() {
        if (take("inside")) {
            result_.is_inside = true;
        } else if (take("on")) {
            if (!take("the") || !take("bounds")) refuse("write \"2 births on the bounds\"");
            result_.is_inside = false;
        }
    }

    // "frame", or "time": what numbers count. A number alone counts what is said after it.
    enum class Unit { frames, seconds, told_after };
    Unit unit(bool is_between) {
        if (take("frame") || (is_between && take("frames"))) return Unit::frames;
        if (take("time") || (is_between && take("times"))) return Unit::seconds;
        const bool is_number =
            !peek().empty() && std::isdigit(static_cast<unsigned char>(peek()[0]));
        if (is_number || peek() == "start" || peek() == "end") return Unit::told_after;
        refuse(fmt::format("'{}' is not what a time begins with; write \"{}\"", peek(),
                           is_between ? "between frames 5 and 9" : "at frame 12\" or \"at 1.28 s"));
    }

    std::optional<Moment> moment(std::string_view word, Unit unit) const {
        if (word == "start") return Moment{-formula::infinity};
        if (word == "end") return Moment{formula::infinity};
        const auto number = written(word);
        if (!number) return {};
        const double frame = to_frame(number->value, unit);
        const double half = 0.5 * std::pow(10, -number->decimals);
        return Moment{frame, to_frame(number->value + half, unit) - frame};
    }
    double to_frame(double number, Unit unit) const {
        const double frame = unit == Unit::frames ? number : frame_at(fps_, number);
        if (!std::isfinite(frame)) refuse(fmt::format("{:g} s is no time of an animation", number));
        return frame;
    }
    Moment take_moment(Unit unit) {
        const auto found = moment(peek(), unit);
        if (!found) {
            refuse(done() ? std::string("ends where a number should be: \"at frame 12\"")
                          : fmt::format("'{}' is no number: write 12, 40.2 or end", peek()));
        }
        const std::string word = words_[next_++];
        if (std::isfinite(found->frame)) take_seconds(word, unit);
        return *found;
    }

    void take_seconds(const std::string& number, Unit unit) {
        if (unit == Unit::frames || take("s") || unit == Unit::seconds) return;
        refuse(fmt::format("{0} of what? Write \"frame {0}\" or \"{0} s\"", number));
    }

    void span(double from, double to) {
        if (from > to) refuse(fmt::format("ends before it begins: {} to {}", from, to));
        result_.asked = {from, to};
        // An event at the very end is in it, however its time was rounded.
        constexpr double slack = 1e-6;
        result_.frames = {from - slack, to + slack};
    }

    void when() {
        if (take("at")) {
            at();
        } else if (take("between")) {
            both_ends("and", "write \"between frames 5 and 9\"");
        } else if (take("from")) {
            both_ends("to", "write \"from frame 5 to 9\"");
        } else if (take("before")) {
            result_.frames = result_.asked = {-formula::infinity, take_moment(unit(false)).frame};
        } else if (take("after")) {
            result_.frames = result_.asked = {take_moment(unit(false)).frame, formula::infinity};
        } else {
            refuse(fmt::format("'{}' is not when; write \"at frame 12\", \"at frame 12..13\", "
                               "\"between frames 5 and 9\", \"before frame 7\", \"after frame 90\"",
                               peek()));
        }
        if (!done()) refuse(fmt::format("goes on after its end, at '{}'", peek()));
        if (result_.asked.lo == formula::infinity || result_.asked.hi == -formula::infinity) {
            refuse("no time is after the end or before the start");
        }
    }
    void both_ends(std::string_view middle, const char* rule) {
        const Unit what = unit(true);
        const double from = take_moment(what).frame;
        if (!take(middle)) refuse(rule);
        const bool says_what =
            peek() == "frame" || peek() == "frames" || peek() == "time" || peek() == "times";
        span(from, take_moment(says_what ? unit(true) : what).frame);
    }
    void at() {
        if (take("frames")) {
            --next_;
            words_[next_] = "frame"; // "at frames 12..13" is as clear
        }
        const Unit what = unit(false);
        const std::string word = peek();
        const std::size_t dots = word.find("..");
        if (dots == std::string::npos) return at_one(take_moment(what), what);
        const auto from = moment(std::string_view(word).substr(0, dots), what);
        const auto to = moment(std::string_view(word).substr(dots + 2), what);
        if (!from || !to) refuse(fmt::format("'{}' is no range: write 12..13", word));
        ++next_;
        take_seconds(word, what);
        span(from->frame, to->frame);
    }
    void at_one(const Moment& moment, Unit unit) {
        if (!std::isfinite(moment.frame)) {
            refuse(fmt::format("an event hardly is at the very {0}; write a span that {1} there: "
                               "\"at frame {2}\"",
                               moment.frame < 0 ? "start" : "end",
                               moment.frame < 0 ? "begins" : "ends",
                               moment.frame < 0 ? "start..2" : "119..end"));
        }
        const double off = take("+-") ? tolerance_here(unit) : tolerance_.value_or(moment.half);
        span(moment.frame - off, moment.frame + off);
    }
    // Reads a tolerance and returns it in frames: "+- 2 frames", "+- 0.1 s", or "+- 2", which
    // counts what "at" counts.
    double tolerance_here(Unit unit) {
        const auto number = written(peek());
        if (!number || number->value < 0) {
            refuse("'+-' needs a number in digits, without an exponent: \"at frame 40 +- 2\", "
                   "\"at 1 s +- 0.001 s\"");
        }
        ++next_;
        const bool in_frames = take("frames") || take("frame");
        const bool in_seconds = !in_frames && (take("s") || unit != Unit::frames);
        const double rate = double(fps_.numerator) / double(fps_.denominator);
        return in_seconds ? number->value * rate : number->value;
    }

    std::vector<std::string> words_;
    std::size_t next_ = 0;
    animation::FrameRate fps_;
    std::optional<double> tolerance_;
    Statement result_;
};

} // namespace

Statement parse_statement(std::string_view text, animation::FrameRate fps,
                          std::optional<double> tolerance) {
    return Parser(text, fps, tolerance).parse();
}

} // namespace isomotion::topology
