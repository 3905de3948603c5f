// What a formula can call: the parser, the reserved names, the shaders' kernels and the list in
// docs/formulas.md are made from these rows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "formula/graph/graph.h"

namespace isomotion::formula {

struct Function {
    std::string_view name;
    std::string_view arguments; // as the documents write them: "a, b"
    std::size_t count;          // of arguments, or the least if there may be more
    bool may_have_more;
    // The call as nodes; null where the parser has a rule of its own.
    NodeId (*call)(Graph&, std::span<const NodeId> arguments);
    // Whether it has a value at a number, on paper: evaluation forgives what rounding does to a
    // radicand, a constant needs no forgiving. Of functions of one argument, else null.
    bool (*has_value)(double x);
};

// Those of one argument first, in the order of their table.
std::span<const Function> functions();
const Function* find_function(std::string_view name); // null if there is none

enum class Shader : std::uint8_t {
    built_in,     // GLSL's own, exact and monotone, so that it maps the ends of intervals
    by_intervals, // GLSL's own on numbers; shaders/interval/arithmetic.glsl has it on intervals
    kernel,       // a function of shaders/math/, and one of shaders/interval/
};
enum class Sign : std::uint8_t { any, not_negative, as_argument };

// What shaders are written by, of the operations that are functions of one argument.
struct UnaryTraits {
    Shader shader;
    Sign sign;
};
const UnaryTraits* unary_traits(Op op); // null for other operations

// The kernel im_<name> that an operation calls in shaders, or empty for what needs none.
std::string_view kernel(Op op);

} // namespace isomotion::formula
