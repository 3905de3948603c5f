// The functions that a formula can call. The parser, the reserved names, the shaders' kernels and
// the list in docs/formulas.md are made from these rows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "formula/graph/graph.h"

namespace isomotion::formula {

struct Function {
    std::string_view name;
    std::string_view arguments; // as the documentation writes them: "a, b"
    std::size_t count;          // of arguments; the minimum if there may be more
    bool may_have_more;
    // Makes the call's nodes; null if the parser has a rule of its own.
    NodeId (*call)(Graph&, std::span<const NodeId> arguments);
    // Whether the function has a value at x, on paper. Only for functions of one argument,
    // otherwise null. Evaluation tolerates radicands that rounding makes negative; a constant needs
    // no tolerance.
    bool (*has_value)(double x);
};

// Functions of one argument first, in the order of their table.
std::span<const Function> functions();
const Function* find_function(std::string_view name); // null if there is none

enum class Shader : std::uint8_t {
    built_in,     // a function of GLSL, exact and monotone, so that it maps the ends of intervals
    by_intervals, // a function of GLSL on numbers; shaders/interval/arithmetic.glsl defines it on
                  // intervals
    kernel,       // a function of shaders/math/, and one of shaders/interval/
};
enum class Sign : std::uint8_t { any, not_negative, as_argument };

// Properties that the shader writers need of operations that are functions of one argument.
struct UnaryTraits {
    Shader shader;
    Sign sign;
};
const UnaryTraits* unary_traits(Op op); // null for other operations

// The kernel im_<name> that an operation calls in shaders; empty if it needs none.
std::string_view kernel(Op op);

} // namespace isomotion::formula
