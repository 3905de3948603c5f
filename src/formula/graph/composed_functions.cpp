#include "formula/graph/composed_functions.h"

#include <array>
#include <numbers>

#include "formula/graph/conditions.h"
#include "formula/graph/term.h"

namespace isomotion::formula {
namespace composed {
namespace {

using Arguments = std::span<const NodeId>;

Term floor(Term a) { return a.of(Op::floor); }
Term abs(Term a) { return a.of(Op::abs); }
Term sign(Term a) { return a.of(Op::sign); }
Term sqrt(Term a) { return a.of(Op::sqrt); }
Term log(Term a) { return a.of(Op::log); }
Term sin(Term a) { return a.of(Op::sin); }
Term cos(Term a) { return a.of(Op::cos); }
Term pow(Term a, Term b) { return a.with(Op::power, b); }

Term ceil(Term a) { return -floor(-a); }
Term round(Term a) { return floor(a + a.number(0.5)); }
Term trunc(Term a) { return sign(a) * floor(abs(a)); }
Term fract(Term a) { return a - floor(a); }
Term exp2(Term a) { return pow(a.number(2), a); }
Term log2(Term a) { return log(a) / a.number(std::numbers::ln2); }
Term log10(Term a) { return log(a) / a.number(std::numbers::ln10); }
Term sec(Term a) { return 1.0 / cos(a); }
Term csc(Term a) { return 1.0 / sin(a); }
Term cot(Term a) { return cos(a) / sin(a); }
Term atanh(Term a) { return 0.5 * log((1.0 + a) / (1.0 - a)); }

Term mod(Term a, Term b) { return a - b * floor(a / b); }
// 0 below the edge, 1 from it on.
Term step(Term edge, Term a) { return floor(1.0 + 0.5 * sign(a - edge)); }

Term clamp(Term a, Term low, Term high) { return min(max(a, low), high); }
Term mix(Term a, Term b, Term part) { return a + (b - a) * part; }
Term smoothstep(Term low, Term high, Term a) {
    const Term part = clamp((a - low) / (high - low), a.number(0), a.number(1));
    return part * part * (3.0 - 2.0 * part);
}

template<Term (*call)(Term)> NodeId of_one(Graph& g, Arguments a) { return call({&g, a[0]}).node; }
template<Term (*call)(Term, Term)> NodeId of_two(Graph& g, Arguments a) {
    return call({&g, a[0]}, {&g, a[1]}).node;
}
template<Term (*call)(Term, Term, Term)> NodeId of_three(Graph& g, Arguments a) {
    return call({&g, a[0]}, {&g, a[1]}, {&g, a[2]}).node;
}

NodeId length(Graph& g, Arguments a) {
    Term squares{&g, g.constant(0)};
    for (const NodeId side : a) {
        const Term of{&g, side};
        squares = squares + of * of;
    }
    return sqrt(squares).node;
}

NodeId choice(Graph& g, Arguments a) { return choose(g, a[0], a[1], a[2]); }

NodeId smoothmax(Graph& g, Arguments a) {
    const std::array less{g.unary(Op::negate, a[0]), g.unary(Op::negate, a[1]), a[2]};
    return g.unary(Op::negate, find_function("smoothmin")->call(g, less));
}

// clang-format off
constexpr std::array table{
    Function{"if", "condition, a, b", 3, false, choice, nullptr, Naming::free},
    Function{"smoothmax", "a, b, k", 3, false, smoothmax, nullptr, Naming::free},
    Function{"clamp", "a, low, high", 3, false, of_three<clamp>, nullptr, Naming::free},
    Function{"mix", "a, b, part", 3, false, of_three<mix>, nullptr, Naming::free},
    Function{"step", "edge, a", 2, false, of_two<step>, nullptr, Naming::free},
    Function{"smoothstep", "low, high, a", 3, false, of_three<smoothstep>, nullptr, Naming::free},
    Function{"mod", "a, b", 2, false, of_two<mod>, nullptr, Naming::free},
    Function{"fract", "a", 1, false, of_one<fract>, nullptr, Naming::free},
    Function{"ceil", "a", 1, false, of_one<ceil>, nullptr, Naming::free},
    Function{"round", "a", 1, false, of_one<round>, nullptr, Naming::free},
    Function{"trunc", "a", 1, false, of_one<trunc>, nullptr, Naming::free},
    Function{"length", "a, b, ...", 2, true, length, nullptr, Naming::free},
    Function{"hypot", "a, b", 2, false, length, nullptr, Naming::free},
    Function{"exp2", "a", 1, false, of_one<exp2>, nullptr, Naming::free},
    Function{"log2", "a", 1, false, of_one<log2>, nullptr, Naming::free},
    Function{"log10", "a", 1, false, of_one<log10>, nullptr, Naming::free},
    Function{"sec", "a", 1, false, of_one<sec>, nullptr, Naming::free},
    Function{"csc", "a", 1, false, of_one<csc>, nullptr, Naming::free},
    Function{"cot", "a", 1, false, of_one<cot>, nullptr, Naming::free},
    Function{"atanh", "a", 1, false, of_one<atanh>, nullptr, Naming::free},
};
// clang-format on

} // namespace
} // namespace composed

std::span<const Function> composed_functions() { return composed::table; }

} // namespace isomotion::formula
