#include "formula/graph/functions.h"

#include <algorithm>
#include <array>
#include <cmath>


namespace isomotion::formula {
namespace {

using Arguments = std::span<const NodeId>;

template<Op op> NodeId unary(Graph& g, Arguments arguments) { return g.unary(op, arguments[0]); }

template<Op op> NodeId folded(Graph& g, Arguments arguments) {
    NodeId result = arguments[0];
    for (const NodeId next : arguments.subspan(1)) result = g.binary(op, result, next);
    return result;
}

// clang-format off
constexpr std::array table{
#define ROW(name, shader, sign, domain, slope)                                                    \
    Function{#name, "a", 1, false, unary<Op::name>,                                               \
             []([[maybe_unused]] double x) -> bool { return domain; }},
    ISOMOTION_FUNCTIONS(ROW)
#undef ROW
    Function{"min", "a, b, ...", 2, true, folded<Op::min>, nullptr},
    Function{"max", "a, b, ...", 2, true, folded<Op::max>, nullptr},
    // The parser's own: a power fails as ^ does; a degree and an array are no values.
    Function{"pow", "a, b", 2, false, nullptr, nullptr},
    Function{"chebyshev", "n, a", 2, false, nullptr, nullptr},
    Function{"sum", "array, expression", 2, false, nullptr, nullptr},
    // In animations alone.
    Function{"random", "i, k", 2, false, folded<Op::random>, nullptr},
};
// clang-format on

} // namespace

std::span<const Function> functions() { return table; }

const Function* find_function(std::string_view name) {
    const auto* const row =
        std::find_if(table.begin(), table.end(), [&](const Function& f) { return f.name == name; });
    return row == table.end() ? nullptr : row;
}

const UnaryTraits* unary_traits(Op op) {
    switch (op) {
#define ROW(name, shader, sign, domain, slope)                                                     \
    case Op::name: {                                                                               \
        static constexpr UnaryTraits traits{Shader::shader, Sign::sign};                           \
        return &traits;                                                                            \
    }
        ISOMOTION_FUNCTIONS(ROW)
#undef ROW
    default:
        return nullptr;
    }
}

std::string_view kernel(Op op) {
    if (op == Op::divide) return name(op);
    if (op == Op::power) return "pow";
    const UnaryTraits* traits = unary_traits(op);
    return traits && traits->shader == Shader::kernel ? name(op) : std::string_view{};
}

} // namespace isomotion::formula
