#include "formula/graph/functions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "formula/graph/composed_functions.h"
#include "formula/graph/term.h"

namespace isomotion::formula {
namespace {

using Arguments = std::span<const NodeId>;

template<Op op> NodeId unary(Graph& g, Arguments arguments) { return g.unary(op, arguments[0]); }

template<Op op> NodeId folded(Graph& g, Arguments arguments) {
    NodeId result = arguments[0];
    for (const NodeId next : arguments.subspan(1)) result = g.binary(op, result, next);
    return result;
}

NodeId noise(Graph& g, Arguments arguments) {
    return g.noise({arguments[0], arguments[1], arguments[2]});
}

template<Op op> NodeId of_two(Graph& g, Arguments arguments) {
    return g.binary(op, arguments[0], arguments[1]);
}

template<Term (*call)(Term, Term, Term)> NodeId of_three(Graph& g, Arguments arguments) {
    return call({&g, arguments[0]}, {&g, arguments[1]}, {&g, arguments[2]}).node;
}

// min(a, b), less (k - |a - b|)^2 / 4k where a and b are less than k apart (Quilez 2013); for k <=
// 0 min(a, b) itself. The blend is that without a kink where a = b: less than both a and b where
// they are less than k apart, equal to the lesser where they are just k apart, and between them
// beyond. So what comparisons decide, slopes and kinks, changes there alone. Bounds are never above
// the minimum's; wide intervals lose no more than k / 2 below, narrow ones are at most twice too
// wide.
Term smoothmin(Term a, Term b, Term k) {
    const Term one = k.number(1), width = max(k, k.number(0));
    // 10^-30 keeps 0/0 off.
    const Term apart = max(-one, min((b - a) / max(k, k.number(1e-30)), one));
    const Term blend = 0.5 * (a + b) - 0.25 * (width * (1.0 + apart * apart));
    return min(min(blend, a), b);
}

// clang-format off
constexpr std::array table{
#define ROW(name, naming, shader, sign, extent, at_0, breaks, gaps, domain, slope)                 \
    Function{#name, "a", 1, false, unary<Op::name>,                                               \
             []([[maybe_unused]] double x) -> bool { return domain; }, Naming::naming},
    ISOMOTION_FUNCTIONS(ROW)
#undef ROW
    Function{"min", "a, b, ...", 2, true, folded<Op::min>, nullptr},
    Function{"max", "a, b, ...", 2, true, folded<Op::max>, nullptr},
    Function{"atan2", "y, x", 2, false, of_two<Op::atan2>, nullptr},
    Function{"smoothmin", "a, b, k", 3, false, of_three<smoothmin>, nullptr},
    Function{"noise", "a, b, c", 3, false, noise, nullptr, Naming::free},
    // The parser reads these itself: a power fails as ^ does; a degree and an array are no values.
    Function{"pow", "a, b", 2, false, nullptr, nullptr},
    Function{"chebyshev", "n, a", 2, false, nullptr, nullptr},
    Function{"fbm", "a, b, c, octaves", 4, false, nullptr, nullptr, Naming::free},
    Function{"sum", "array, expression", 2, false, nullptr, nullptr},
    Function{"least", "array, expression", 2, false, nullptr, nullptr},
    Function{"greatest", "array, expression", 2, false, nullptr, nullptr},
    // This one is for animations alone.
    Function{"random", "i, k", 2, false, of_two<Op::random>, nullptr},
};
// clang-format on

} // namespace

std::span<const Function> functions() { return table; }

std::string_view plain_name(std::string_view name) {
    constexpr std::array<std::array<std::string_view, 2>, 5> others{{{"ln", "log"},
                                                                     {"arcsin", "asin"},
                                                                     {"arccos", "acos"},
                                                                     {"arctan", "atan"},
                                                                     {"arctan2", "atan2"}}};
    for (const auto& [other, plain] : others) {
        if (name == other) return plain;
    }
    return name;
}

const Function* find_function(std::string_view name) {
    for (const std::span<const Function> rows : {functions(), composed_functions()}) {
        const auto row = std::ranges::find(rows, name, &Function::name);
        if (row != rows.end()) return &*row;
    }
    return nullptr;
}

const Traits* traits(Op op) {
    switch (op) {
#define ROW(name, naming, shader, sign, extent, at_0, breaks, gaps, domain, slope)                 \
    case Op::name: {                                                                               \
        static constexpr Traits row{                                                               \
            1, Shader::shader, Sign::sign, Extent::extent, Breaks::breaks, Gaps::gaps, At0::at_0}; \
        return &row;                                                                               \
    }
        ISOMOTION_FUNCTIONS(ROW)
#undef ROW
#define ROW(name, shader, sign, extent, breaks, gaps, slope)                                       \
    case Op::name: {                                                                               \
        static constexpr Traits row{                                                               \
            2, Shader::shader, Sign::sign, Extent::extent, Breaks::breaks, Gaps::gaps};            \
        return &row;                                                                               \
    }
        ISOMOTION_OPERATIONS_OF_TWO(ROW)
#undef ROW
    default:
        return nullptr;
    }
}

const Traits* unary_traits(Op op) {
    const Traits* row = traits(op);
    return row && row->arguments == 1 ? row : nullptr;
}

Breaks breaks(Op op) {
    const Traits* row = traits(op);
    return row ? row->breaks : Breaks::nowhere;
}

bool has_steps(Op op) { return op == Op::random || breaks(op) == Breaks::steps; }
bool may_jump(Op op) { return has_steps(op) || breaks(op) == Breaks::cut; }

std::string_view kernel(Op op) {
    if (op == Op::power) return "pow";
    if (op == Op::noise) return name(op);
    const Traits* row = traits(op);
    return row && row->shader == Shader::kernel ? name(op) : std::string_view{};
}

} // namespace isomotion::formula
