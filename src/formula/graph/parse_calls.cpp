#include "formula/graph/formula_parser.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "base/nearest_name.h"
#include "formula/graph/composed_functions.h"
#include "formula/graph/conditions.h"
#include "formula/graph/spelling.h"
#include "formula/graph/substitute.h"

namespace isomotion::formula {
namespace {

std::vector<std::string> function_names(const OwnFunctions* library) {
    std::vector<std::string> names;
    for (const std::span<const Function> rows : {functions(), composed_functions()}) {
        for (const Function& function : rows) names.emplace_back(function.name);
    }
    for (const std::string& name : library ? library->names() : std::vector<std::string>{})
        names.push_back(name);
    return names;
}

} // namespace

FormulaParser::Defined FormulaParser::defined_function(std::string_view name) {
    if (const OwnFunction* found = own().find(name)) return {&own(), found};
    if (!library_ || find_function(plain_name(name))) return {};
    return {library_, library_->find(name)};
}

NodeId FormulaParser::call_defined(const Defined& defined, const std::vector<NodeId>& arguments,
                                   std::string_view name, std::size_t begin) {
    const OwnFunctions* const owner = defined.owner;
    const OwnFunction* const function = defined.function;
    if (arguments.size() != function->arguments.size()) {
        fail(begin, fmt::format("{}({}) takes {} argument{}, not {}", name,
                                join(function->arguments), function->arguments.size(),
                                function->arguments.size() == 1 ? "" : "s", arguments.size()));
    }
    std::vector<int> open;
    for (const OpenLoop& loop : open_arrays_) open.push_back(loop.array);
    if (const auto array = owner->array_of(*function, open)) {
        fail(begin, fmt::format("'{}' goes through '{}', and is called where that is done", name,
                                vocabulary_.arrays[std::size_t(*array)].name));
    }
    if (owner == library_ && !has_place() && owner->has_place(*function))
        fail(begin, fmt::format("'{}' is of a place, which this expression has not", name));
    const std::size_t first = graph_.size();
    std::vector<NodeId> given = arguments;
    for (NodeId& argument : given) { // a condition is its solid there
        const bool is_solid =
            owner == library_ && is_choice(graph_[argument]) && is_condition(graph_, argument);
        if (is_solid) argument = solid_of(graph_, argument);
    }
    const NodeId value = made(begin, [&] { return owner->call(graph_, *function, given, work()); });
    check_constants(first, name, begin);
    return value;
}

template<class Make> NodeId FormulaParser::made(std::size_t begin, const Make& make) {
    try {
        return make();
    } catch (const CallError& error) {
        fail(begin, error.what());
    }
}

bool FormulaParser::has_place() const {
    return names_.input("x") == 0 && names_.input("y") == 1 && names_.input("z") == 2;
}

std::optional<NodeId> FormulaParser::function_at_the_point(std::string_view word,
                                                           std::size_t begin) {
    const OwnFunction* function = own().find(word);
    if (!function || function->arguments.size() != coordinate_names.size()) return std::nullopt;
    std::vector<NodeId> point;
    for (const std::string& name : coordinate_names) {
        const auto coordinate = names_.input(name);
        if (!coordinate) return std::nullopt;
        point.push_back(graph_.input(*coordinate));
    }
    return call_defined({&own(), function}, point, word, begin);
}

std::optional<NodeId> FormulaParser::at_another_point(std::string_view word) {
    const bool is_argument = std::ranges::count(arguments_, word) > 0;
    const bool is_part = defined(word) || (outer_ && outer_->defined(word));
    if (!is_argument && !is_part) return std::nullopt;
    const std::size_t end = at_;
    skip_space();
    if (!has_place() || group_ahead().parts != 3) {
        at_ = end;
        return std::nullopt;
    }
    const std::optional<NodeId> of = named(word);
    const std::size_t begin = at_;
    const std::optional<char> closing = accept_opening();
    if (!of || !closing) throw std::logic_error("a named part, and its point in parentheses");
    const Enclosed enclosed(*this, *closing);
    const std::vector<NodeId> point = argument_list();
    const std::size_t first = graph_.size();
    const NodeId moved = made(begin, [&] {
        return at_point(graph_, *of, {point[0], point[1], point[2]}, work());
    });
    check_constants(first, word, begin);
    return moved;
}

void FormulaParser::check_constants(std::size_t first, std::string_view name,
                                    std::size_t place) const {
    if (has_undefined_constant(graph_, first))
        fail(place, fmt::format("{} is not defined here", name));
}

NodeId FormulaParser::call(std::string_view called, std::size_t begin, char closing) {
    const Enclosed enclosed(*this, closing);
    const Defined defined = defined_function(called);
    return defined ? call_defined(defined, argument_list(), called, begin)
                   : called_by(plain_name(called), begin);
}

NodeId FormulaParser::called_by(std::string_view name, std::size_t begin) {
    if (name == function_) fail(begin, fmt::format("'{}' calls itself", name));
    if (name == "sum" || name == "least" || name == "greatest") return over_elements(name, begin);
    if (name == "chebyshev") return chebyshev();
    if (name == "fbm") return fbm(begin);
    if (name == "dot") return dot(begin);
    const Function* function = find_function(name);
    if (!function) {
        fail(begin, fmt::format("there is no function '{}'{}", name,
                                hint_for_call(name, function_names(library_))));
    }
    const std::size_t first_argument = at_;
    const std::vector<NodeId> arguments =
        name == "length" || name == "noise" ? parts_of_vector(name, begin) : argument_list();
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
    if (function->naming == Naming::free) check_constants(first, name, first_argument);
    return value;
}

void FormulaParser::need_arguments(const Function& function, std::size_t given,
                                   std::size_t begin) const {
    constexpr std::array words{"no", "one", "two", "three", "four"};
    if (function.may_have_more) {
        if (given >= function.count) return;
        fail(begin, fmt::format("{} takes {} or more", function.name, words.at(function.count)));
    }
    if (given == function.count) return;
    const bool are_two = function.count == 1 && given == 2;
    const std::string_view instead = are_two && function.name == "atan" ? ": write atan2(y, x)"
                                     : are_two && function.name == "log"
                                         ? ": write log(a)/log(b) for a logarithm to the base b"
                                         : "";
    fail(begin, fmt::format("{} takes {} argument{}, not {}{}", function.name, function.count,
                            function.count == 1 ? "" : "s", given, instead));
}

std::optional<std::vector<NodeId>> FormulaParser::accept_vector() {
    skip_space();
    const std::size_t begin = at_;
    std::size_t place = begin;
    const std::string_view word = accept_word(place);
    constexpr std::array<std::string_view, 4> kinds{"vec2", "vec3", "float2", "float3"};
    if (std::ranges::count(kinds, word) > 0 && accept('(')) {
        const Enclosed enclosed(*this, ')');
        std::vector<NodeId> parts = argument_list();
        const auto wanted = std::size_t(word.back() - '0');
        if (parts.size() != wanted)
            fail(place, fmt::format("{} takes {} parts, not {}", word, wanted, parts.size()));
        return parts;
    }
    if (auto parts = is_point(word) ? parts_of_point() : std::nullopt) {
        skip_space();
        if (peek() == ',' || peek() == closing_) return parts;
    }
    at_ = begin;
    return std::nullopt;
}

std::optional<std::vector<NodeId>> FormulaParser::parts_of_point() {
    std::string_view letters = "xyz";
    if (accept('.')) {
        letters = peek_name();
        at_ += letters.size();
    }
    std::vector<NodeId> parts;
    for (const char& letter : letters) {
        const auto input = names_.input({&letter, 1});
        if (!input) return std::nullopt;
        parts.push_back(graph_.input(*input));
    }
    return parts;
}

std::vector<NodeId> FormulaParser::argument_list() {
    std::vector<NodeId> arguments;
    skip_space();
    if (accept(closing_)) return arguments;
    do {
        arguments.push_back(value());
        skip_space();
    } while (accept(','));
    expect_closing("to close the argument list");
    return arguments;
}

// length(a, b, c), and length of a vector.
std::vector<NodeId> FormulaParser::parts_of_vector(std::string_view function, std::size_t begin) {
    const auto parts = accept_vector();
    if (!parts) return argument_list();
    skip_space();
    if (!accept(closing_))
        fail(begin, fmt::format("{} takes one vector, or the parts of one", function));
    return *parts;
}

// Octaves of noise, each of half the size and twice the frequency of the one before. They are
// shifted, since all are 0 at their lattice points.
NodeId FormulaParser::fbm(std::size_t begin) {
    std::vector<NodeId> arguments;
    if (const auto place = accept_vector()) {
        arguments = *place;
        expect(',', "between the place and the octaves of fbm");
        arguments.push_back(expression());
        expect_closing("to close the argument list");
    } else {
        arguments = argument_list();
    }
    need_arguments(*find_function("fbm"), arguments.size(), begin);
    const NodeId octaves = arguments[3];
    const double count = graph_.is_constant(octaves) ? graph_[octaves].value : 0;
    if (!(count >= 1) || count != std::floor(count) || count > limits::octaves) {
        fail(begin, fmt::format("the octaves of fbm(a, b, c, octaves) must be a constant integer "
                                "from 1 to {}",
                                limits::octaves));
    }
    constexpr std::array shift{0.296875, 0.609375, 0.828125};
    NodeId sum = graph_.constant(0);
    double frequency = 1;
    for (int octave = 0; octave < int(count); ++octave, frequency *= 2) {
        std::array<NodeId, 3> place{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const NodeId scaled = graph_.multiply(graph_.constant(frequency), arguments[axis]);
            place[axis] = graph_.add(scaled, graph_.constant(octave * shift[axis]));
        }
        const NodeId size = graph_.constant(1 / frequency);
        sum = graph_.add(sum, graph_.multiply(size, graph_.noise(place)));
    }
    return checked(sum, begin, out_of_range);
}

NodeId FormulaParser::dot(std::size_t begin) {
    const auto first = accept_vector();
    skip_space();
    const auto second = accept(',') ? accept_vector() : std::nullopt;
    if (!first || !second || first->size() != second->size())
        fail(begin, "dot takes two vectors of as many parts: p, p.xy, vec3(a, b, c)");
    expect_closing("to close the argument list");
    NodeId sum = graph_.constant(0);
    for (std::size_t k = 0; k < first->size(); ++k)
        sum = graph_.add(sum, graph_.multiply((*first)[k], (*second)[k]));
    return checked(sum, begin, out_of_range);
}

NodeId FormulaParser::chebyshev() {
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
    expect_closing("to close the argument list");
    return graph_.chebyshev(int(n), argument);
}

NodeId FormulaParser::over_elements(std::string_view function, std::size_t begin) {
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
                 : fmt::format("{}(array, expression): there is no array '{}'{}", function, word,
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
    expect_closing(fmt::format("to close the {}", function));
    if (function == "sum") return graph_.sum(array, body);
    const bool is_least = function == "least";
    const NodeId key = is_least ? body : graph_.unary(Op::negate, body);
    if (asks) return graph_.pick(array, key, asked);
    const NodeId least = graph_.least(array, key);
    return is_least ? least : graph_.unary(Op::negate, least);
}

} // namespace isomotion::formula
