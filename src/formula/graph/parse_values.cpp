#include "formula/graph/formula_parser.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>

#include "formula/graph/conditions.h"
#include "formula/graph/spelling.h"

namespace isomotion::formula {

NodeId FormulaParser::value() {
    const NodeId first = disjunction();
    skip_space();
    if (!accept('?')) return first;
    const Depth depth(*this);
    const NodeId then = value();
    expect(':', "between the two values of a choice");
    return choose(graph_, first, then, value());
}

NodeId FormulaParser::disjunction() {
    std::vector<NodeId> all{conjunction()};
    while (accept_connective("or") || accept("||") || accept("∨")) all.push_back(conjunction());
    if (!is_enclosed_ && all.size() > 1) joins_conditions_ = true;
    return is_any(graph_, all);
}

NodeId FormulaParser::conjunction() {
    std::vector<NodeId> all{negation()};
    while (accept_connective("and") || accept("&&") || accept('&') || accept("∧"))
        all.push_back(negation());
    if (!is_enclosed_ && all.size() > 1) joins_conditions_ = true;
    return are_all(graph_, all);
}

NodeId FormulaParser::negation() {
    skip_space();
    const std::size_t place = at_;
    const bool is_sign = !rest().starts_with("!=") && (accept('!') || accept("¬"));
    if (!is_sign && !accept_connective("not")) return comparison();
    const Depth depth(*this);
    skip_space();
    const bool is_again = peek() == '!' || rest().starts_with("¬");
    const NodeId of = is_sign && !is_again ? expression() : negation();
    if (is_sign && compares_here(is_enclosed_))
        fail(place, "this may be two things: write !(a < b), or (!a) < b");
    return choose(graph_, of, graph_.constant(0), graph_.constant(1));
}

NodeId FormulaParser::comparison() {
    NodeId left = expression();
    const bool outside = is_compared_;
    std::optional<NodeId> all;
    while (const auto sign = accept_comparison(is_enclosed_)) {
        is_compared_ = true;
        const NodeId right = expression();
        const NodeId now = compared(*sign, left, right);
        all = all ? choose(graph_, *all, now, graph_.constant(0)) : now;
        left = right;
    }
    is_compared_ = outside;
    return all.value_or(left);
}

NodeId FormulaParser::compared(Comparison sign, NodeId a, NodeId b) {
    switch (sign) {
    case Comparison::less:
        return is_less(graph_, a, b);
    case Comparison::at_most:
        return is_at_most(graph_, a, b);
    case Comparison::greater:
        return is_less(graph_, b, a);
    case Comparison::at_least:
        return is_at_most(graph_, b, a);
    case Comparison::same:
        return are_all(graph_, std::array{is_at_most(graph_, a, b), is_at_most(graph_, b, a)});
    case Comparison::other:
        break;
    }
    return is_any(graph_, std::array{is_less(graph_, a, b), is_less(graph_, b, a)});
}

bool FormulaParser::is_connective(std::string_view word) {
    constexpr std::array<std::string_view, 5> words{"and", "or", "not", "then", "else"};
    return std::ranges::count(words, word) > 0 && !named(word);
}

bool FormulaParser::accept_connective(std::string_view word) {
    skip_space();
    return peek_name() == word && is_connective(word) && accept(word);
}

NodeId FormulaParser::expression() {
    const Depth depth(*this);
    NodeId left = term();
    while (true) {
        skip_space();
        const std::size_t place = at_;
        if (accept('+')) {
            left = checked(graph_.add(left, term()), place, out_of_range);
        } else if (accept_minus()) {
            left = checked(graph_.subtract(left, term()), place, out_of_range);
        } else {
            return left;
        }
    }
}

NodeId FormulaParser::term() {
    NodeId left = factor();
    bool is_quotient = false; // so far
    while (true) {
        skip_space();
        const std::size_t place = at_;
        if (accept_times()) {
            left = checked(graph_.multiply(left, factor()), place, out_of_range);
            is_quotient = false;
        } else if (accept_over()) {
            const NodeId right = factor();
            if (graph_.is_constant(right, 0)) fail(place, "division by zero");
            left = graph_.divide(left, right);
            is_quotient = true;
        } else if (begins_factor(left)) {
            // 9/4 x is no more than one thing, 1/2x may be.
            const char before = text_[place - 1];
            const bool has_blank = !is_name_part(before) && before != ')' && before != '.';
            if (is_quotient && !(has_blank && graph_.is_constant(left)))
                fail(place, "expected an operator after a quotient: write a/(b*c), or (a/b)*c");
            left = checked(graph_.multiply(left, power()), place, out_of_range);
            is_quotient = false;
        } else {
            return left;
        }
    }
}

bool FormulaParser::begins_factor(NodeId left) {
    if (begins_word()) return !is_connective(peek_name()) && !compares_here(false);
    const bool joins_conditions =
        rest().starts_with("||") &&
        (is_compared_ || (is_choice(graph_[left]) && is_condition(graph_, left)));
    if (peek() == '|') return open_bars_ == 0 && !joins_conditions;
    return peek() == '(' || rest().starts_with("π") || rest().starts_with("√") ||
           rest().starts_with("∛");
}

NodeId FormulaParser::factor() {
    const Depth depth(*this);
    check_size();
    skip_space();
    if (accept_minus()) return graph_.unary(Op::negate, factor());
    if (accept('+')) return factor();
    return power();
}

NodeId FormulaParser::power() {
    const std::size_t begin = at_;
    const bool is_root = rest().starts_with("√") || rest().starts_with("∛");
    const NodeId base = primary();
    const std::size_t end = at_;
    const NodeId value = raised(base);
    if (is_root && at_ > end && value != base)
        fail(begin, "the power of a root may be two things: write √(a^2), or (√a)^2");
    return value;
}

template<class Read> NodeId FormulaParser::bound_tightly(const Read& read) {
    const bool outside = std::exchange(is_tight_, true);
    const NodeId value = read();
    is_tight_ = outside;
    return value;
}

NodeId FormulaParser::raised(NodeId base) {
    const std::size_t place_of_raised = at_;
    if (const auto exponent = accept_raised_number())
        base = raise(base, graph_.constant(*exponent), place_of_raised);
    if (accept("⁻")) fail(place_of_raised, "expected raised digits after the raised minus");
    skip_space();
    const std::size_t place = at_;
    if (!accept_power()) return base;
    skip_space();
    if (!accept('{')) return raise(base, bound_tightly([&] { return factor(); }), place);
    const NodeId exponent = inside('}', "to close the exponent");
    return raise(base, exponent, place);
}

NodeId FormulaParser::inside(char closing, std::string_view why) {
    const Enclosed enclosed(*this, closing);
    const NodeId within = value();
    expect(closing, why);
    return within;
}

NodeId FormulaParser::in_braces(std::string_view of) {
    expect('{', fmt::format("behind {}", of));
    return inside('}', fmt::format("to close what {} is of", of));
}

NodeId FormulaParser::absolute_value() {
    ++open_bars_;
    const bool outside = std::exchange(is_compared_, false);
    const NodeId value = expression();
    expect('|', "to close the absolute value");
    --open_bars_;
    is_compared_ = outside;
    return graph_.unary(Op::abs, value);
}

NodeId FormulaParser::raise(NodeId base, NodeId exponent, std::size_t place) {
    if (graph_.is_constant(base, 0) && graph_.is_constant(exponent) && graph_[exponent].value < 0) {
        fail(place, "division by zero: 0 to a negative power");
    }
    if (graph_.is_constant(base, std::numbers::e))
        return checked(graph_.unary(Op::exp, exponent), place, out_of_range);
    return checked(graph_.binary(Op::power, base, exponent), place,
                   "a negative number has no real power with a fractional exponent");
}

NodeId FormulaParser::primary() {
    skip_space();
    const std::size_t begin = at_;
    if (at_ == text_.size()) fail(at_, "the formula ends where a value is expected");
    if (const auto closing = accept_opening()) return inside(*closing, "to close the parenthesis");
    if (accept('|')) return absolute_value();
    if (accept("π")) return graph_.constant(std::numbers::pi);
    if (accept("√")) return root_sign(2, begin);
    if (accept("∛")) return root_sign(3, begin);
    if (const auto fraction = accept_fraction()) return graph_.constant(*fraction);
    if (std::isdigit(static_cast<unsigned char>(peek())) || peek() == '.') return number();
    if (peek() == ')') fail(at_, "expected a value before ')'");
    std::size_t place = begin;
    const std::string_view word = accept_word(place);
    if (word.empty()) fail_unexpected();
    if (place > begin && text_[place - 1] == '\\') {
        if (word == "frac" || word == "dfrac" || word == "tfrac") return fraction(begin);
        if (word == "sqrt" && (peek() == '{' || peek() == '[')) return root(begin);
        if (word == "lvert" || word == "vert") fail(begin, "write | for an absolute value");
    }
    return name_or_call(word, place);
}

NodeId FormulaParser::fraction(std::size_t begin) {
    const NodeId above = in_braces("\\frac"), below = in_braces("\\frac");
    if (graph_.is_constant(below, 0)) fail(begin, "division by zero");
    return graph_.divide(above, below);
}

NodeId FormulaParser::root(std::size_t begin) {
    double degree = 2;
    if (accept('[')) {
        const NodeId number = inside(']', "to close the degree of the root");
        degree = graph_.is_constant(number) ? graph_[number].value : 0;
    }
    if (degree != 2 && degree != 3) fail(begin, "write a^(1/n) for roots of a degree but 2 and 3");
    return root_of(int(degree), in_braces("\\sqrt"), begin);
}

NodeId FormulaParser::root_sign(int degree, std::size_t begin) {
    const Depth depth(*this);
    return root_of(degree, bound_tightly([&] { return primary(); }), begin);
}

NodeId FormulaParser::root_of(int degree, NodeId of, std::size_t place) {
    const Function* function = find_function(degree == 2 ? "sqrt" : "cbrt");
    return checked(function->call(graph_, std::array{of}), place,
                   "a negative number has no square root");
}

NodeId FormulaParser::name_or_call(std::string_view word, std::size_t begin) {
    if (const auto value = at_another_point(word)) return *value;
    if (const auto value = named(word)) return *value;
    if (is_point(word) && peek() == '.') {
        const std::size_t end = at_;
        if (const auto part = parts_of_point(); part && part->size() == 1) return part->front();
        at_ = end;
    }
    const bool is_known = defined_function(word) || find_function(plain_name(word));
    // What it is called elsewhere; the text of the name outlives this call, as a function's own.
    const std::string plain = is_known ? std::string(word) : plain_spelling(word);
    if (const auto value = plain == word ? std::nullopt : named(plain)) return *value;
    if (const auto value = is_known ? std::nullopt : first_of_product(word, begin)) return *value;
    if (const auto exponent = exponent_of_function(plain, begin)) {
        skip_space();
        if (!accept('(')) fail_without_parentheses(plain, begin);
        return raise(call(plain, begin, ')'), graph_.constant(*exponent), begin);
    }
    skip_space();
    if (plain == "if" && begins_condition()) return if_then_else(begin);
    if (const auto closing = accept_opening()) return call(plain, begin, *closing);
    if (const auto value = function_at_the_point(word, begin)) return *value;
    if (is_known || find_function(plain_name(plain))) fail_without_parentheses(plain, begin);
    if (begin > 0 && text_[begin - 1] == '\\')
        fail(begin - 1,
             fmt::format("'\\{}' is not read; fractions are \\frac{{a}}{{b}}, roots \\sqrt{{a}}",
                         word));
    fail_unknown(word, begin);
}

std::optional<NodeId> FormulaParser::first_of_product(std::string_view word, std::size_t begin) {
    const auto is_coordinate = [&](const char& c) {
        const bool is_single = std::ranges::count(word, c) == 1; // xx is a slip, more likely
        return is_single && std::ranges::count(coordinate_names, std::string_view(&c, 1)) > 0;
    };
    if (word.size() < 2 || !std::ranges::all_of(word, is_coordinate)) return std::nullopt;
    if (is_tight_) {
        fail(begin, fmt::format("it is not plain how much of '{}' is meant: write ({})", word,
                                fmt::join(word, "*")));
    }
    const std::optional<NodeId> first = named(word.substr(0, 1)); // none in rules of animation
    if (first) at_ = begin + 1;
    return first;
}

std::optional<int> FormulaParser::exponent_of_function(std::string_view name, std::size_t begin) {
    if (own().find(name) || !find_function(plain_name(name))) return std::nullopt;
    const std::size_t end = at_;
    std::optional<int> exponent = accept_raised_number();
    skip_space();
    if (!exponent && accept_power()) {
        const bool is_braced = accept('{'), is_negative = accept_minus();
        int digits = 0;
        for (; digits < 3 && std::isdigit(static_cast<unsigned char>(peek())); ++digits, ++at_)
            exponent = 10 * exponent.value_or(0) + (peek() - '0');
        if (exponent && is_negative) exponent = -*exponent;
        if (is_braced && !accept('}')) exponent = std::nullopt;
    }
    if (exponent && *exponent < 0) {
        fail(begin, fmt::format("{0}^{1} may be two things: write 1/{0}(a), or the inverse "
                                "function's name",
                                name, *exponent));
    }
    if (!exponent) at_ = end;
    return exponent;
}

// Whether no call's arguments stand behind `if`: if x > 0 then, if (x > 0) then.
bool FormulaParser::begins_condition() const {
    const Group group = group_ahead();
    if (group.parts == 0) return true;
    TextCursor behind(text_, group.end);
    behind.skip_space();
    return group.parts == 1 && behind.peek_name() == "then";
}

NodeId FormulaParser::if_then_else(std::size_t begin) {
    const auto accept_keyword = [&](std::string_view word) {
        skip_space();
        return peek_name() == word && accept(word);
    };
    const Depth depth(*this);
    const auto read_condition = [&] {
        const Enclosed enclosed(*this, closing_);
        return disjunction();
    };
    const NodeId condition = read_condition();
    if (!accept_keyword("then")) fail_without_parentheses("if", begin);
    const NodeId then = value();
    if (!accept_keyword("else")) fail(at_, "expected 'else' and the other value of the choice");
    return choose(graph_, condition, then, value());
}

NodeId FormulaParser::number() {
    double value = 0;
    const std::size_t begin = at_;
    const char* first = text_.data() + at_;
    const auto [end, error] = std::from_chars(first, text_.data() + text_.size(), value);
    if (error == std::errc::result_out_of_range) fail(at_, "this number is out of range");
    if (error != std::errc{}) fail(at_, "this is not a number");
    at_ += std::size_t(end - first);
    // A number of a shader, 1.5f.
    const bool has_point = text_.substr(begin, at_ - begin).find('.') != text_.npos;
    if (has_point && peek_name() == "f" && !named("f") && !own().find("f")) ++at_;
    if (peek_name() == "e")
        fail(at_, "the exponent of a number has no digits; write 2*e for a "
                  "product");
    return graph_.constant(value);
}

} // namespace isomotion::formula
