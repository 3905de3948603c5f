#include "formula/graph/formula_parser.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

#include "formula/graph/conditions.h"
#include "formula/graph/library.h"

namespace isomotion::formula {

OwnFunctions FormulaParser::definitions() {
    while (parse_definition()) {
    }
    skip_space();
    if (at_ < text_.size()) fail_unexpected();
    return std::move(own_functions_);
}

NodeId FormulaParser::formula() {
    if (text_.size() > limits::formula_bytes) {
        fail(limits::formula_bytes, fmt::format("the formula has {} bytes; at most {} are read",
                                                text_.size(), limits::formula_bytes));
    }
    leave_out_last_semicolon();
    while (parse_definition()) {
    }
    skip_name_of_function();
    NodeId root = value();
    skip_space();
    const std::size_t place = at_;
    const bool may_compare = rest().starts_with("==");
    const bool is_equation = vocabulary_.allows_equation && accept_equals();
    if (is_equation) {
        // x == 1 and y > 0 compares, in other languages.
        const NodeId right = may_compare ? expression() : value();
        skip_space();
        const bool goes_on = at_ < text_.size() && peek() != '=';
        if (may_compare && (joins_conditions_ || goes_on))
            fail(place, "put the comparison in parentheses: (a == b)");
        root = checked(graph_.subtract(root, right), place, out_of_range);
        skip_space();
        if (peek() == '=') fail(at_, "a formula has one '=' at most");
    }
    if (at_ < text_.size()) fail_unexpected();
    const bool may_be_solid = vocabulary_.allows_equation && !is_equation;
    return may_be_solid && is_choice(graph_[root]) && is_condition(graph_, root)
               ? solid_of(graph_, root)
               : root;
}

void FormulaParser::leave_out_last_semicolon() {
    const std::size_t last = text_.find_last_not_of(" \t\r\n");
    if (last != text_.npos && text_[last] == ';') text_ = text_.substr(0, last);
}

void FormulaParser::skip_name_of_function() {
    skip_space();
    const std::size_t begin = at_;
    std::size_t place = at_;
    const std::string_view word = accept_word(place);
    const bool is_new =
        !word.empty() && !named(word) && !own().find(word) && !find_function(plain_name(word));
    if (vocabulary_.allows_equation && is_new && argument_names() == coordinate_names) {
        skip_space();
        if (accept('=')) return;
    }
    at_ = begin;
}

bool FormulaParser::parse_definition() {
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
    if (peek() != '=' || rest().starts_with("==") || is_equation) {
        at_ = begin;
        return false;
    }
    check_new_name(word, begin);
    ++at_;
    if (arguments) {
        define_function(word, *arguments, begin);
    } else {
        if (own().find(word)) fail(begin, fmt::format("'{}' is a function already", word));
        const Enclosed enclosed(*this, ';');
        definitions_[std::string(word)] = value();
    }
    skip_space();
    if (peek() != ';') {
        fail(at_, fmt::format("expected ';' after the definition of '{}'", word));
    }
    ++at_;
    return true;
}

void FormulaParser::check_new_name(std::string_view word, std::size_t place) const {
    if (is_reserved(word)) fail(place, fmt::format("'{}' already has a meaning", word));
    if (word.size() > limits::name_bytes) {
        fail(place, fmt::format("a name of {} characters; at most {} are read", word.size(),
                                limits::name_bytes));
    }
}

std::optional<std::vector<std::string>> FormulaParser::argument_names() {
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

void FormulaParser::define_function(std::string_view name,
                                    const std::vector<std::string>& arguments, std::size_t begin) {
    check_function_name(name, begin);
    if (arguments.size() > limits::function_arguments) {
        fail(begin, fmt::format("'{}' has {} arguments; at most {} are read", name,
                                arguments.size(), limits::function_arguments));
    }
    for (const std::string& argument : arguments) {
        if (is_reserved(argument) && std::ranges::count(coordinate_names, argument) == 0)
            fail(begin, fmt::format("'{}' already has a meaning", argument));
        if (std::count(arguments.begin(), arguments.end(), argument) > 1)
            fail(begin, fmt::format("two arguments of '{}' are named '{}'", name, argument));
    }
    FormulaParser body(text_, names_, own().bodies(), library_);
    body.outer_ = this;
    body.at_ = at_;
    body.function_ = name;
    body.arguments_ = arguments;
    body.is_enclosed_ = true;
    const NodeId root = body.value();
    at_ = body.at_;
    own().add(name, {arguments, root});
}

void FormulaParser::check_function_name(std::string_view name, std::size_t place) const {
    bool has_value = names_.parameter(name) || names_.input(name) || defined(name);
    for (const ArrayName& array : vocabulary_.arrays)
        has_value = has_value || std::ranges::count(array.fields, name, &FieldName::name) > 0;
    if (has_value) fail(place, fmt::format("'{}' already has a value", name));
    if (plain_name(name) != name) fail(place, fmt::format("'{}' already has a meaning", name));
}

void FormulaParser::check_size() const {
    if (graph_.size() > limits::formula_nodes) {
        fail(at_, fmt::format("the formula is too large: it has more than {} operations, names "
                              "and numbers",
                              limits::formula_nodes));
    }
}

std::optional<NodeId> FormulaParser::named(std::string_view word) {
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

std::optional<NodeId> FormulaParser::defined(std::string_view word) const {
    const auto found = definitions_.find(word);
    return found == definitions_.end() ? std::nullopt : std::optional(found->second);
}

NodeId FormulaParser::checked(NodeId node, std::size_t place, std::string_view message) const {
    if (!graph_.is_constant(node) || std::isfinite(graph_[node].value)) return node;
    fail(place, std::string(message));
}

void FormulaParser::fail_without_parentheses(std::string_view name, std::size_t begin) {
    const Function* function = find_function(name);
    const Defined defined = defined_function(name);
    const std::string call = fmt::format("{}({})", name,
                                         function  ? std::string(function->arguments)
                                         : defined ? join(defined.function->arguments)
                                                   : "...");
    const std::string_view rest = text_.substr(at_);
    const bool is_power = rest.starts_with('^') || rest.starts_with("²") || rest.starts_with("³");
    fail(begin, is_power ? fmt::format("the power of a function: write '{}^...'", call)
                         : fmt::format("{} needs parentheses: write '{}'", name, call));
}

void FormulaParser::fail_unknown(std::string_view word, std::size_t begin) const {
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

NodeId parse(std::string_view text, const Vocabulary& vocabulary, Graph& graph) {
    return parse(text, Names(vocabulary), graph);
}

NodeId parse(std::string_view text, const Names& names, Graph& graph) {
    return FormulaParser(text, names, graph, &library()).formula();
}

} // namespace isomotion::formula
