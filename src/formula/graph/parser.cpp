#include "formula/graph/parser.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/nearest_name.h"
#include "formula/graph/composed_functions.h"
#include "formula/graph/conditions.h"
#include "formula/graph/functions.h"
#include "formula/graph/limits.h"
#include "formula/graph/own_functions.h"
#include "formula/graph/parse_hints.h"
#include "formula/graph/substitute.h"
#include "formula/graph/text_cursor.h"
#include "formula/graph/utf8.h"

namespace isomotion::formula {
namespace {

std::vector<std::string> function_names() {
    std::vector<std::string> names;
    for (const std::span<const Function> rows : {functions(), composed_functions()}) {
        for (const Function& function : rows) names.emplace_back(function.name);
    }
    return names;
}

bool is_function_name(std::string_view name) {
    return std::ranges::find(functions(), name, &Function::name) != functions().end();
}

class Parser : private TextCursor {
public:
    Parser(std::string_view text, const Names& names, Graph& graph)
        : TextCursor(text)
        , names_(names)
        , vocabulary_(names.vocabulary())
        , graph_(graph) {}

    NodeId formula() {
        if (text_.size() > limits::formula_bytes) {
            fail(limits::formula_bytes, fmt::format("the formula has {} bytes; at most {} are read",
                                                    text_.size(), limits::formula_bytes));
        }
        while (parse_definition()) {
        }
        NodeId root = value();
        skip_space();
        const std::size_t place = at_;
        const bool is_equation = vocabulary_.allows_equation && accept('=');
        if (is_equation) {
            root = checked(graph_.subtract(root, value()), place, out_of_range);
            skip_space();
            if (peek() == '=') fail(at_, "a formula has one '=' at most");
        }
        if (at_ < text_.size()) fail_unexpected();
        const bool may_be_solid = vocabulary_.allows_equation && !is_equation;
        return may_be_solid && is_choice(graph_[root]) && is_condition(graph_, root)
                   ? solid_of(graph_, root)
                   : root;
    }

private:
    // `name = expression ;` or `name(names) = expression ;` if one starts here.
    bool parse_definition() {
        skip_space();
        const std::size_t begin = at_;
        const std::string_view word = peek_name();
        if (word.empty()) return false;
        at_ += word.size();
        skip_space();
        const std::size_t end_of_word = at_;
        const std::optional<std::vector<std::string>> arguments = argument_names();
        if (!arguments) at_ = end_of_word;
        skip_space();
        const bool is_equation = vocabulary_.allows_equation && text_.find(';', at_) == text_.npos;
        if (peek() != '=' || is_equation) {
            at_ = begin;
            return false;
        }
        check_new_name(word, begin);
        ++at_;
        if (arguments) {
            define_function(word, *arguments, begin);
        } else {
            if (own().find(word)) fail(begin, fmt::format("'{}' is a function already", word));
            definitions_[std::string(word)] = value();
        }
        skip_space();
        if (peek() != ';') {
            fail(at_, fmt::format("expected ';' after the definition of '{}'", word));
        }
        ++at_;
        return true;
    }

    void check_new_name(std::string_view word, std::size_t place) const {
        if (is_reserved(word)) fail(place, fmt::format("'{}' already has a meaning", word));
        if (word.size() > limits::name_bytes) {
            fail(place, fmt::format("a name of {} characters; at most {} are read", word.size(),
                                    limits::name_bytes));
        }
    }

    // The names within parentheses, if nothing else is there.
    std::optional<std::vector<std::string>> argument_names() {
        if (!accept('(')) return std::nullopt;
        std::vector<std::string> names;
        do {
            skip_space();
            const std::string_view word = peek_name();
            if (word.empty()) return std::nullopt;
            names.emplace_back(word);
            at_ += word.size();
            skip_space();
        } while (accept(','));
        return accept(')') ? std::optional(names) : std::nullopt;
    }

    // Coordinates and parameters may be names of arguments: those are hidden within the function.
    void define_function(std::string_view name, const std::vector<std::string>& arguments,
                         std::size_t begin) {
        check_function_name(name, begin);
        if (arguments.size() > limits::function_arguments) {
            fail(begin, fmt::format("'{}' has {} arguments; at most {} are read", name,
                                    arguments.size(), limits::function_arguments));
        }
        for (const std::string& argument : arguments) {
            if (argument == "pi" || is_function_name(argument))
                fail(begin, fmt::format("'{}' already has a meaning", argument));
            if (std::count(arguments.begin(), arguments.end(), argument) > 1)
                fail(begin, fmt::format("two arguments of '{}' are named '{}'", name, argument));
        }
        Parser body(text_, names_, own().bodies());
        body.outer_ = this;
        body.at_ = at_;
        body.function_ = name;
        body.arguments_ = arguments;
        const NodeId root = body.value();
        at_ = body.at_;
        own().add(name, {arguments, root});
    }

    // A call must not be read as a product with a value of that name.
    void check_function_name(std::string_view name, std::size_t place) const {
        bool has_value = names_.parameter(name) || names_.input(name) || defined(name);
        for (const ArrayName& array : vocabulary_.arrays)
            has_value = has_value || std::ranges::count(array.fields, name, &FieldName::name) > 0;
        if (has_value) fail(place, fmt::format("'{}' already has a value", name));
        if (plain_name(name) != name) fail(place, fmt::format("'{}' already has a meaning", name));
    }

    OwnFunctions& own() { return outer_ ? outer_->own() : own_functions_; }
    std::size_t& work() { return outer_ ? outer_->work() : work_; }

    NodeId call_own(const OwnFunction& function, std::string_view name, std::size_t begin) {
        const std::vector<NodeId> arguments = argument_list();
        if (arguments.size() != function.arguments.size()) {
            fail(begin, fmt::format("{}({}) takes {} argument{}, not {}", name,
                                    join(function.arguments), function.arguments.size(),
                                    function.arguments.size() == 1 ? "" : "s", arguments.size()));
        }
        std::vector<int> open;
        for (const OpenLoop& loop : open_arrays_) open.push_back(loop.array);
        if (const auto array = own().array_of(function, open)) {
            fail(begin, fmt::format("'{}' goes through '{}', and is called where that is done",
                                    name, vocabulary_.arrays[std::size_t(*array)].name));
        }
        work() += own().work_of(function);
        if (work() > limits::calls_work) fail(begin, "the formula calls large functions too often");
        const std::size_t first = graph_.size();
        const NodeId value = own().call(graph_, function, arguments);
        check_constants(first, name, begin);
        check_size();
        return value;
    }

    void check_constants(std::size_t first, std::string_view name, std::size_t place) const {
        if (has_undefined_constant(graph_, first))
            fail(place, fmt::format("{} is not defined here", name));
    }

    void check_size() const {
        if (graph_.size() > limits::formula_nodes) {
            fail(at_, fmt::format("the formula is too large: it has more than {} operations, names "
                                  "and numbers",
                                  limits::formula_nodes));
        }
    }

    // An expression, a condition, or one of two values: c ? a : b.
    NodeId value() {
        const NodeId first = disjunction();
        skip_space();
        if (!accept('?')) return first;
        const Depth depth(*this);
        const NodeId then = value();
        expect(':', "between the two values of a choice");
        return choose(graph_, first, then, value());
    }

    NodeId disjunction() {
        std::vector<NodeId> all{conjunction()};
        while (accept_connective("or")) all.push_back(conjunction());
        return is_any(graph_, all);
    }

    NodeId conjunction() {
        std::vector<NodeId> all{negation()};
        while (accept_connective("and") || accept("&&") || accept('&')) all.push_back(negation());
        return are_all(graph_, all);
    }

    NodeId negation() {
        skip_space();
        if (!accept_connective("not") && !accept('!')) return comparison();
        const Depth depth(*this);
        return choose(graph_, negation(), graph_.constant(0), graph_.constant(1));
    }

    // a < b <= c, too.
    NodeId comparison() {
        NodeId left = expression();
        std::optional<NodeId> all;
        for (auto sign = accept_comparison(); !sign.empty(); sign = accept_comparison()) {
            const NodeId right = expression();
            const bool is_less_than = sign.front() == '<';
            const NodeId low = is_less_than ? left : right, high = is_less_than ? right : left;
            const NodeId now =
                sign.size() == 1 ? is_less(graph_, low, high) : is_at_most(graph_, low, high);
            all = all ? choose(graph_, *all, now, graph_.constant(0)) : now;
            left = right;
        }
        return all.value_or(left);
    }

    // Their names stay free.
    bool is_connective(std::string_view word) {
        return (word == "and" || word == "or" || word == "not") && !named(word);
    }
    bool accept_connective(std::string_view word) {
        skip_space();
        return peek_name() == word && is_connective(word) && accept(word);
    }

    NodeId expression() {
        const Depth depth(*this);
        NodeId left = term();
        while (true) {
            skip_space();
            const std::size_t place = at_;
            if (accept('+')) {
                left = checked(graph_.add(left, term()), place, out_of_range);
            } else if (accept('-') || accept(minus_sign)) {
                left = checked(graph_.subtract(left, term()), place, out_of_range);
            } else {
                return left;
            }
        }
    }

    NodeId term() {
        NodeId left = factor();
        bool is_quotient = false; // so far
        while (true) {
            skip_space();
            const std::size_t place = at_;
            if (accept('*') || accept("·") || accept("⋅") || accept("×")) {
                if (peek() == '*') fail(at_ - 1, "powers are written with '^'");
                left = checked(graph_.multiply(left, factor()), place, out_of_range);
                is_quotient = false;
            } else if (accept('/')) {
                const NodeId right = factor();
                if (graph_.is_constant(right, 0)) fail(place, "division by zero");
                left = graph_.divide(left, right);
                is_quotient = true;
            } else if (begins_factor()) {
                if (is_quotient) {
                    fail(place, "expected an operator after a quotient: write a/(b*c), or (a/b)*c");
                }
                left = checked(graph_.multiply(left, power()), place, out_of_range);
            } else {
                return left;
            }
        }
    }

    // Whether a product without a sign goes on: 2x, (x+1)(y+1), a sin(x). Within bars the next one
    // closes.
    bool begins_factor() {
        if (is_name_start(peek())) return !is_connective(peek_name());
        return peek() == '(' || text_.substr(at_).starts_with("π") ||
               (peek() == '|' && open_bars_ == 0);
    }

    NodeId factor() {
        const Depth depth(*this);
        check_size();
        skip_space();
        if (accept('-') || accept(minus_sign)) return graph_.unary(Op::negate, factor());
        if (accept('+')) return factor();
        return power();
    }

    NodeId power() {
        NodeId base = primary();
        const std::size_t raised = at_;
        if (const auto exponent = accept_raised_number())
            base = raise(base, graph_.constant(*exponent), raised);
        if (accept("⁻")) fail(raised, "expected raised digits after the raised minus");
        skip_space();
        const std::size_t place = at_;
        if (!accept('^')) return base;
        if (!accept('{')) return raise(base, factor(), place);
        const NodeId exponent = inside('}', "to close the exponent");
        return raise(base, exponent, place);
    }

    // Parses up to a closing character; bars that are open outside are not closed in here.
    NodeId inside(char closing, std::string_view why) {
        const int outside = std::exchange(open_bars_, 0);
        const NodeId within = value();
        expect(closing, why);
        open_bars_ = outside;
        return within;
    }

    NodeId absolute_value() {
        ++open_bars_;
        const NodeId value = expression();
        expect('|', "to close the absolute value");
        --open_bars_;
        return graph_.unary(Op::abs, value);
    }

    NodeId raise(NodeId base, NodeId exponent, std::size_t place) {
        if (graph_.is_constant(base, 0) && graph_.is_constant(exponent) &&
            graph_[exponent].value < 0) {
            fail(place, "division by zero: 0 to a negative power");
        }
        if (graph_.is_constant(base, std::numbers::e))
            return checked(graph_.unary(Op::exp, exponent), place, out_of_range);
        return checked(graph_.binary(Op::power, base, exponent), place,
                       "a negative number has no real power with a fractional exponent");
    }

    NodeId primary() {
        skip_space();
        const std::size_t begin = at_;
        if (at_ == text_.size()) fail(at_, "the formula ends where a value is expected");
        if (accept('(')) return inside(')', "to close the parenthesis");
        if (accept('|')) return absolute_value();
        if (accept("π")) return graph_.constant(std::numbers::pi);
        if (std::isdigit(static_cast<unsigned char>(peek())) || peek() == '.') return number();
        if (peek() == ')') fail(at_, "expected a value before ')'");
        const std::string_view word = peek_name();
        if (word.empty()) fail_unexpected();
        at_ += word.size();
        if (const auto value = named(word)) return *value;
        skip_space();
        if (accept('(')) return call(word, begin);
        if (find_function(word)) fail_without_parentheses(word, begin);
        fail_unknown(word, begin);
    }

    NodeId number() {
        double value = 0;
        const char* first = text_.data() + at_;
        const auto [end, error] = std::from_chars(first, text_.data() + text_.size(), value);
        if (error == std::errc::result_out_of_range) fail(at_, "this number is out of range");
        if (error != std::errc{}) fail(at_, "this is not a number");
        at_ += std::size_t(end - first);
        if (peek_name() == "e")
            fail(at_, "the exponent of a number has no digits; write 2*e for a "
                      "product");
        return graph_.constant(value);
    }

    std::optional<NodeId> named(std::string_view word) {
        // Innermost first: fields of the arrays being gone through, definitions, then the
        // vocabulary.
        for (auto it = open_arrays_.rbegin(); it != open_arrays_.rend(); ++it) {
            const auto field = names_.field(it->array, word);
            if (!field) continue;
            const auto& fields = vocabulary_.arrays[std::size_t(it->array)].fields;
            const auto& parameter = fields[std::size_t(*field)].parameter;
            return parameter ? graph_.parameter(*parameter) : graph_.element(it->array, *field);
        }
        const auto argument = std::ranges::find(arguments_, word);
        if (argument != arguments_.end())
            return own().argument(std::size_t(argument - arguments_.begin()));
        if (const auto it = definitions_.find(word); it != definitions_.end()) return it->second;
        if (const auto value = outer_ ? outer_->defined(word) : std::nullopt) {
            const Node& node = outer_->graph_[*value];
            return node.op == Op::constant ? graph_.constant(node.value) : own().outside(*value);
        }
        if (own().find(word)) return std::nullopt;
        if (const auto k = names_.input(word)) return graph_.input(*k);
        if (const auto k = names_.parameter(word)) return graph_.parameter(*k);
        if (word == "pi") return graph_.constant(std::numbers::pi);
        if (word == "tau") return graph_.constant(2 * std::numbers::pi);
        if (word == "e") return graph_.constant(std::numbers::e);
        return std::nullopt;
    }

    std::optional<NodeId> defined(std::string_view word) const {
        const auto found = definitions_.find(word);
        return found == definitions_.end() ? std::nullopt : std::optional(found->second);
    }

    NodeId call(std::string_view called, std::size_t begin) {
        const int outside = std::exchange(open_bars_, 0);
        const OwnFunction* function = own().find(called);
        const NodeId value =
            function ? call_own(*function, called, begin) : called_by(plain_name(called), begin);
        open_bars_ = outside;
        return value;
    }

    NodeId called_by(std::string_view name, std::size_t begin) {
        if (name == function_) fail(begin, fmt::format("'{}' calls itself", name));
        if (name == "arg")
            fail(begin, "there is no function 'arg': write atan2(y, x) for the angle of the point "
                        "(x, y)");
        if (name == "sum" || name == "least" || name == "greatest")
            return over_elements(name, begin);
        if (name == "chebyshev") return chebyshev();
        const std::size_t first_argument = at_;
        const std::vector<NodeId> arguments = argument_list();
        const Function* function = find_function(name);
        if (!function) {
            const std::string near = base::nearest_name(name, function_names());
            fail(begin, fmt::format("there is no function '{}'{}", name,
                                    near.empty() ? "" : fmt::format("; did you mean '{}'?", near)));
        }
        if (name == "random" && !vocabulary_.allows_random) {
            fail(begin, "random is for animation: give a parameter or an array field its value "
                        "with random(i, k), not the formula");
        }
        need_arguments(*function, arguments.size(), begin);
        if (name == "pow") return raise(arguments[0], arguments[1], begin);
        const std::string undefined = fmt::format("{} is not defined here", name);
        if (function->has_value && graph_.is_constant(arguments[0]) &&
            !function->has_value(graph_[arguments[0]].value)) {
            fail(first_argument, undefined);
        }
        const std::size_t first = graph_.size();
        const NodeId value = checked(function->call(graph_, arguments), first_argument, undefined);
        if (!is_function_name(name)) check_constants(first, name, first_argument);
        return value;
    }

    void need_arguments(const Function& function, std::size_t given, std::size_t begin) const {
        constexpr std::array words{"no", "one", "two", "three"};
        if (function.may_have_more) {
            if (given >= function.count) return;
            fail(begin,
                 fmt::format("{} takes {} or more", function.name, words.at(function.count)));
        }
        if (given == function.count) return;
        const bool is_of_point = function.name == "atan" && given == 2;
        fail(begin, fmt::format("{} takes {} argument{}, not {}{}", function.name, function.count,
                                function.count == 1 ? "" : "s", given,
                                is_of_point ? ": write atan2(y, x)" : ""));
    }

    std::vector<NodeId> argument_list() {
        std::vector<NodeId> arguments;
        skip_space();
        if (accept(')')) return arguments;
        do {
            arguments.push_back(value());
            skip_space();
        } while (accept(','));
        expect(')', "to close the argument list");
        return arguments;
    }

    NodeId chebyshev() {
        skip_space();
        const std::size_t place = at_;
        const NodeId degree = expression();
        const double n = graph_.is_constant(degree) ? graph_[degree].value : -1;
        if (n < 0 || n != std::floor(n) || n > limits::chebyshev_degree) {
            fail(place, fmt::format("the degree of chebyshev(n, x) must be a constant integer from "
                                    "0 to {}",
                                    limits::chebyshev_degree));
        }
        expect(',', "between the degree and the argument of chebyshev");
        const NodeId argument = expression();
        expect(')', "to close the argument list");
        return graph_.chebyshev(int(n), argument);
    }

    // sum(array, a), least(array, a), greatest(array, a); for the last two also what is asked of
    // that element.
    NodeId over_elements(std::string_view function, std::size_t begin) {
        skip_space();
        const std::size_t place = at_;
        const std::string_view word = peek_name();
        at_ += word.size();
        int array = -1;
        std::vector<std::string> known;
        for (std::size_t k = 0; k < vocabulary_.arrays.size(); ++k) {
            known.push_back(vocabulary_.arrays[k].name);
            if (vocabulary_.arrays[k].name == word) array = int(k);
        }
        if (array < 0) {
            const std::string near = base::nearest_name(word, known);
            fail(place,
                 known.empty()
                     ? fmt::format("{} needs an array, and the scene has none: add [arrays.name]",
                                   function)
                     : fmt::format("{}(array, expression): there is no array '{}'{}", function,
                                   word,
                                   near.empty() ? fmt::format("; known: {}", join(known))
                                                : fmt::format("; did you mean '{}'?", near)));
        }
        for (const OpenLoop& open : open_arrays_) {
            if (open.array == array) {
                fail(begin, fmt::format("a {} over '{}' inside a {} over '{}'", function, word,
                                        open.function, word));
            }
        }
        expect(',', fmt::format("between the array and the expression of {}", function));
        open_arrays_.push_back({array, function});
        const NodeId body = value();
        skip_space();
        const std::size_t second = at_;
        const bool asks = function != "sum" && accept(',');
        if (asks && !vocabulary_.allows_picks) {
            fail(second, fmt::format("a formula jumps where what is asked of the {} element does; "
                                     "that is for colours: here {}(array, expression)",
                                     function, function));
        }
        const NodeId asked = asks ? value() : body;
        open_arrays_.pop_back();
        expect(')', fmt::format("to close the {}", function));
        if (function == "sum") return graph_.sum(array, body);
        const bool is_least = function == "least";
        const NodeId key = is_least ? body : graph_.unary(Op::negate, body);
        if (asks) return graph_.pick(array, key, asked);
        const NodeId least = graph_.least(array, key);
        return is_least ? least : graph_.unary(Op::negate, least);
    }

    // A constant that isn't finite has no literal in a shader.
    NodeId checked(NodeId node, std::size_t place, std::string_view message) const {
        if (!graph_.is_constant(node) || std::isfinite(graph_[node].value)) return node;
        fail(place, std::string(message));
    }
    static constexpr std::string_view out_of_range =
        "these constants lead beyond the range of numbers";

    static std::string join(const std::vector<std::string>& words) {
        return fmt::format("{}", fmt::join(words, ", "));
    }

    [[noreturn]] void fail_without_parentheses(std::string_view name, std::size_t begin) const {
        const Function* function = find_function(name);
        const std::string call =
            fmt::format("{}({})", name, function ? function->arguments : "...");
        const std::string_view rest = text_.substr(at_);
        const bool is_power =
            rest.starts_with('^') || rest.starts_with("²") || rest.starts_with("³");
        fail(begin, is_power ? fmt::format("the power of a function: write '{}^...'", call)
                             : fmt::format("{} needs parentheses: write '{}'", name, call));
    }

    [[noreturn]] void fail_unknown(std::string_view word, std::size_t begin) const {
        std::vector<std::string> known = vocabulary_.inputs;
        // "camera.fov" is a parameter to the animation but no name in a formula.
        std::copy_if(vocabulary_.parameters.begin(), vocabulary_.parameters.end(),
                     std::back_inserter(known), is_identifier);
        for (const OpenLoop& open : open_arrays_) {
            for (const auto& field : vocabulary_.arrays[std::size_t(open.array)].fields) {
                known.push_back(field.name);
            }
        }
        for (const auto& [defined, node] : definitions_) known.push_back(defined);
        known.emplace_back("pi");
        for (const auto& array : vocabulary_.arrays) {
            for (const auto& field : array.fields) {
                if (field.name == word) {
                    fail(begin, fmt::format("'{}' is a field of the array '{}' and has a value "
                                            "only inside sum({}, ...)",
                                            word, array.name, array.name));
                }
            }
        }
        fail(begin, fmt::format("unknown name '{}'{}", word, hint_for_unknown(word, known)));
    }

    [[noreturn]] void fail_unexpected() const {
        if (at_ == text_.size()) fail(at_, "the formula ends too early");
        if (peek() == '=' && at_ > 0 && text_[at_ - 1] == '=')
            fail(at_, "unexpected second '=': write one");
        if (peek() == '=' && text_.find_first_not_of(" \t\n\r") == at_)
            fail(at_, "a value is expected before '='");
        if (peek() == '=')
            fail(at_, "unexpected '=': an expression has a value, and equals nothing");
        if (std::isdigit(static_cast<unsigned char>(peek())) || peek() == '|')
            fail(at_, fmt::format("expected an operator before '{}'", peek()));
        if (peek() == ')') fail(at_, "this ')' closes nothing");
        if (peek() == ';') fail(at_, "unexpected ';': a formula ends without it");
        const auto is_digit = [&](std::size_t at) {
            return at < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at]));
        };
        if (peek() == ',' && at_ > 0 && is_digit(at_ - 1) && is_digit(at_ + 1))
            fail(at_, "unexpected ',': numbers are written with a point, as 1.5");
        std::size_t length = 1; // a whole UTF-8 character
        while (at_ + length < text_.size() && continues_character(text_[at_ + length])) ++length;
        const std::string_view sign = text_.substr(at_, length);
        fail(at_, fmt::format("unexpected '{}'{}", sign, hint_for_sign(sign)));
    }

    [[noreturn]] void fail(std::size_t offset, const std::string& message) const {
        throw ParseError(text_, offset, message);
    }

    // The recursion of a hostile formula, "((((...", must end in an error and not in the stack.
    struct Depth {
        explicit Depth(Parser& parser)
            : owner(parser) {
            if (++owner.depth_ > limits::nesting) {
                owner.fail(owner.at_, "the formula is nested too deeply");
            }
        }
        ~Depth() { --owner.depth_; }
        Depth(const Depth&) = delete;
        Depth& operator=(const Depth&) = delete;
        Parser& owner;
    };

    static constexpr std::string_view minus_sign = "−";
    void expect(char c, std::string_view why) {
        skip_space();
        if (!accept(c)) fail(at_, fmt::format("expected '{}' {}", c, why));
    }

    const Names& names_;
    const Vocabulary& vocabulary_;
    Graph& graph_;
    int depth_ = 0;
    int open_bars_ = 0; // absolute values that wait for their closing bar
    struct OpenLoop {
        int array;
        std::string_view function;
    };
    std::vector<OpenLoop> open_arrays_; // arrays being gone through
    std::map<std::string, NodeId, std::less<>> definitions_;
    OwnFunctions own_functions_;
    std::size_t work_ = 0; // operations that calls of own functions have looked at
    // Of the parser of a function's body.
    Parser* outer_ = nullptr;
    std::string_view function_;
    std::vector<std::string> arguments_;
};

} // namespace

NodeId parse(std::string_view text, const Vocabulary& vocabulary, Graph& graph) {
    return parse(text, Names(vocabulary), graph);
}

NodeId parse(std::string_view text, const Names& names, Graph& graph) {
    return Parser(text, names, graph).formula();
}

bool is_reserved(std::string_view name) {
    return name == "pi" || name == "x" || name == "y" || name == "z" || is_function_name(name);
}

} // namespace isomotion::formula
