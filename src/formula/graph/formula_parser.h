// The parser of a formula: a descent through the grammar of parser.h. The bodies of functions have
// parsers of their own, which share the functions.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "formula/graph/functions.h"
#include "formula/graph/graph.h"
#include "formula/graph/limits.h"
#include "formula/graph/names.h"
#include "formula/graph/own_functions.h"
#include "formula/graph/parse_hints.h"
#include "formula/graph/parser.h"
#include "formula/graph/text_cursor.h"

namespace isomotion::formula {

class FormulaParser : private TextCursor {
public:
    // `library`: functions that the formula need not define, or null.
    FormulaParser(std::string_view text, const Names& names, Graph& graph,
                  const OwnFunctions* library)
        : TextCursor(text)
        , names_(names)
        , vocabulary_(names.vocabulary())
        , graph_(graph)
        , library_(library)
        , is_enclosed_(!vocabulary_.allows_equation) {}

    NodeId formula();
    // Reads definitions alone, and gives their functions away.
    OwnFunctions definitions();

private:
    // Definitions, and what names mean (formula_parser.cpp).
    OwnFunctions& own() { return outer_ ? outer_->own() : own_functions_; }
    std::size_t& work() { return outer_ ? outer_->work() : work_; }
    void leave_out_last_semicolon();
    // f(x, y, z) = x^2 + ... is the function, and no equation.
    void skip_name_of_function();
    // `name = expression ;` or `name(names) = expression ;` if one starts here.
    bool parse_definition();
    void check_new_name(std::string_view word, std::size_t place) const;
    // The names within parentheses, if nothing else is there.
    std::optional<std::vector<std::string>> argument_names();
    // Coordinates and parameters may be names of arguments: those are hidden within the function.
    void define_function(std::string_view name, const std::vector<std::string>& arguments,
                         std::size_t begin);
    // A call must not be read as a product with a value of that name.
    void check_function_name(std::string_view name, std::size_t place) const;
    void check_size() const;
    std::optional<NodeId> named(std::string_view word);
    std::optional<NodeId> defined(std::string_view word) const;
    // A constant that isn't finite has no literal in a shader.
    NodeId checked(NodeId node, std::size_t place, std::string_view message) const;
    [[noreturn]] void fail_without_parentheses(std::string_view name, std::size_t begin);
    [[noreturn]] void fail_unknown(std::string_view word, std::size_t begin) const;

    // Operators and values (parse_values.cpp).
    // An expression, a condition, or one of two values: c ? a : b.
    NodeId value();
    NodeId disjunction();
    NodeId conjunction();
    NodeId negation();
    // a < b <= c, too.
    NodeId comparison();
    NodeId compared(Comparison sign, NodeId a, NodeId b);
    // Their names stay free.
    bool is_connective(std::string_view word);
    bool accept_connective(std::string_view word);
    NodeId expression();
    NodeId term();
    // Whether a product without a sign goes on: 2x, (x+1)(y+1), a sin(x). Within bars the next one
    // closes.
    bool begins_factor(NodeId left);
    NodeId factor();
    NodeId power();
    NodeId raised(NodeId base);
    // Parses up to a closing character; bars that are open outside are not closed in here.
    NodeId inside(char closing, std::string_view why);
    NodeId in_braces(std::string_view of);
    NodeId absolute_value();
    NodeId raise(NodeId base, NodeId exponent, std::size_t place);
    NodeId primary();
    NodeId fraction(std::size_t begin);
    // \sqrt{a}, \sqrt[3]{a}
    NodeId root(std::size_t begin);
    NodeId root_sign(int degree, std::size_t begin);
    NodeId root_of(int degree, NodeId of, std::size_t place);
    // What an exponent or a root is of.
    template<class Read> NodeId bound_tightly(const Read& read);
    NodeId name_or_call(std::string_view word, std::size_t begin);
    // xyz is x*y*z: x is read, and the rest follows as the next factors. Only coordinates are, and
    // not in exponents and roots, 2^xy.
    std::optional<NodeId> first_of_product(std::string_view word, std::size_t begin);
    // sin^2(x) is sin(x)^2, but sin^-1 is the inverse function to some.
    std::optional<int> exponent_of_function(std::string_view name, std::size_t begin);
    bool begins_condition() const;
    NodeId if_then_else(std::size_t begin);
    NodeId number();

    // Calls (parse_calls.cpp).
    // A function that the formula defines or that the library has; none of either.
    struct Defined {
        const OwnFunctions* owner = nullptr;
        const OwnFunction* function = nullptr;
        explicit operator bool() const { return function; }
    };
    Defined defined_function(std::string_view name);
    NodeId call_defined(const Defined& defined, const std::vector<NodeId>& arguments,
                        std::string_view name, std::size_t begin);
    // What `make` makes. Tells a CallError at the place.
    template<class Make> NodeId made(std::size_t begin, const Make& make);
    bool has_place() const; // whether x, y and z are its inputs 0 to 2
    // f(x - 1, y, z), where f is an argument or a named part: it at another point.
    std::optional<NodeId> at_another_point(std::string_view word);
    void check_constants(std::size_t first, std::string_view name, std::size_t place) const;
    NodeId call(std::string_view called, std::size_t begin, char closing);
    NodeId called_by(std::string_view name, std::size_t begin);
    void need_arguments(const Function& function, std::size_t given, std::size_t begin) const;
    // The parts of a vector, where one is an argument: vec2(a, b), p for the point, p.xy. Stays
    // where there is none.
    std::optional<std::vector<NodeId>> accept_vector();
    std::vector<NodeId> parts_of_vector(std::string_view function, std::size_t begin);
    // A function of x, y and z that stands for its value: twist(body, 2).
    std::optional<NodeId> function_at_the_point(std::string_view word, std::size_t begin);
    // Behind p: nothing, or .xy and the like.
    std::optional<std::vector<NodeId>> parts_of_point();
    std::vector<NodeId> argument_list();
    NodeId chebyshev();
    NodeId fbm(std::size_t begin);
    NodeId dot(std::size_t begin);
    // sum(array, a), least(array, a), greatest(array, a); for the last two also what is asked of
    // that element.
    NodeId over_elements(std::string_view function, std::size_t begin);

    // Shaders call the point p.
    bool is_point(std::string_view word) { return word == "p" && !named(word); }
    static constexpr std::string_view out_of_range =
        "these constants lead beyond the range of numbers";
    static std::string join(const std::vector<std::string>& words) {
        return fmt::format("{}", fmt::join(words, ", "));
    }
    [[noreturn]] void fail_unexpected() const { fail(at_, message_for_unexpected(text_, at_)); }
    [[noreturn]] void fail(std::size_t offset, const std::string& message) const {
        throw ParseError(text_, offset, message);
    }

    // The recursion of a hostile formula, "((((...", must end in an error and not in the stack.
    struct Depth {
        explicit Depth(FormulaParser& parser)
            : owner(parser) {
            if (++owner.depth_ > limits::nesting) {
                owner.fail(owner.at_, "the formula is nested too deeply");
            }
        }
        ~Depth() { --owner.depth_; }
        Depth(const Depth&) = delete;
        Depth& operator=(const Depth&) = delete;
        FormulaParser& owner;
    };
    // What stands in parentheses, braces or a list of arguments. Bars and comparisons that are open
    // outside do not go on in it.
    struct Enclosed {
        Enclosed(FormulaParser& parser, char closing)
            : owner(parser)
            , bars(std::exchange(owner.open_bars_, 0))
            , is_compared(std::exchange(owner.is_compared_, false))
            , is_tight(std::exchange(owner.is_tight_, false))
            , is_enclosed(std::exchange(owner.is_enclosed_, true))
            , outer_closing(std::exchange(owner.closing_, closing)) {}
        ~Enclosed() {
            owner.open_bars_ = bars;
            owner.is_compared_ = is_compared;
            owner.is_tight_ = is_tight;
            owner.is_enclosed_ = is_enclosed;
            owner.closing_ = outer_closing;
        }
        Enclosed(const Enclosed&) = delete;
        Enclosed& operator=(const Enclosed&) = delete;
        FormulaParser& owner;
        int bars;
        bool is_compared, is_tight, is_enclosed;
        char outer_closing;
    };

    void expect_closing(std::string_view why) { expect(closing_, why); }
    void expect(char c, std::string_view why) {
        skip_space();
        if (!accept(c)) fail(at_, fmt::format("expected '{}' {}", c, why));
    }

    struct OpenLoop {
        int array;
        std::string_view function;
    };

    const Names& names_;
    const Vocabulary& vocabulary_;
    Graph& graph_;
    const OwnFunctions* library_;
    int depth_ = 0;
    int open_bars_ = 0;                 // absolute values that wait for their closing bar
    bool is_compared_ = false;          // behind a comparison's sign
    bool is_tight_ = false;             // in an exponent or behind the sign of a root
    bool is_enclosed_;                  // by parentheses, or where no equation may be
    bool joins_conditions_ = false;     // by `and` or `or`, outside of parentheses
    char closing_ = ')';                // of the arguments that are read
    std::vector<OpenLoop> open_arrays_; // arrays being gone through
    std::map<std::string, NodeId, std::less<>> definitions_;
    OwnFunctions own_functions_;
    std::size_t work_ = 0; // operations that calls of own functions have looked at
    // Where this parses the body of a function:
    FormulaParser* outer_ = nullptr;
    std::string_view function_;
    std::vector<std::string> arguments_;
};

} // namespace isomotion::formula
