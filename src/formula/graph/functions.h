// The functions that a formula can call. The parser, the reserved names, the shaders' kernels and
// the list in docs/formulas.md are made from these rows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "formula/graph/graph.h"

namespace isomotion::formula {

enum class Naming : std::uint8_t {
    reserved, // nothing else may have its name
    free,     // a parameter or an array field may: in formulas that is the name's meaning
};

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
    Naming naming = Naming::reserved;
};

// Those of the table and those that the parser reads itself. Functions of one argument first, in
// the order of their table.
std::span<const Function> functions();
// Of these, or of composed_functions(); null if there is none.
const Function* find_function(std::string_view name);
// The name itself, or the one that it is another name of: log for ln.
std::string_view plain_name(std::string_view name);

enum class Shader : std::uint8_t {
    built_in,     // a function of GLSL, exact and monotone, so that it maps the ends of intervals
    by_intervals, // a function of GLSL on numbers; shaders/interval/arithmetic.glsl defines it on
                  // intervals
    kernel,       // a function of shaders/math/, and one of shaders/interval/
};
// as_argument: not negative if the argument is not, or the first one; of_both: if both are not;
// of_either: if one is not.
enum class Sign : std::uint8_t { any, as_argument, of_both, of_either, not_negative, positive };
enum class Extent : std::uint8_t {
    unit,      // from -1 to 1
    finite,    // where the arguments are
    unbounded, // larger than any number at some arguments, or too large for a float
};
enum class At0 : std::uint8_t { zero, other };
enum class Breaks : std::uint8_t {
    nowhere,
    kink_at_0,
    kink_at_1,       // at 1 and -1; constant beyond
    begins_at_1,     // has a kink there; constant below
    kink_where_same, // where both arguments are the same
    turn,            // turns fast near 0 if the argument has a pole, as an angle does about an axis
    axis,            // turns fast near the axis a = b = 0, and has no limit there
    cut,             // jumps at a = 0 where b < 0, too
    pole_at_0,       // and no value below
    pole_at_b_0,
    base_at_0, // of a power: a kink or a pole, by its exponent
    poles,
    steps, // jumps, and is constant between jumps
};
enum class Gaps : std::uint8_t {
    kept, // no value where the argument has none
    cut,  // there may be one: implementations compare the argument, or cut it off
};

// What is known of an operation that has a row in the table.
struct Traits {
    std::size_t arguments;
    Shader shader;
    Sign sign;
    Extent extent;
    Breaks breaks;
    Gaps gaps;
    At0 at_0 = At0::other; // of functions of one argument

    bool is_never_negative() const { return sign == Sign::not_negative || sign == Sign::positive; }
    // argument(k): whether argument k is never negative.
    template<class Argument> bool is_never_negative(const Argument& argument) const {
        switch (sign) {
        case Sign::any:
            return false;
        case Sign::as_argument:
            return argument(0);
        case Sign::of_both:
            return argument(0) && argument(1);
        case Sign::of_either:
            return argument(0) || argument(1);
        case Sign::not_negative:
        case Sign::positive:
            return true;
        }
        return false;
    }
};
const Traits* traits(Op op);       // null for operations without a row
const Traits* unary_traits(Op op); // null, too, for those of two arguments

// The traits' `breaks`; nowhere for operations without a row.
Breaks breaks(Op op);
// Whether the operation jumps from value to value: functions with steps, and random.
bool has_steps(Op op);
// Whether it jumps on both sides of a surface: these, and atan2 at its cut.
bool may_jump(Op op);

// The kernel im_<name> that an operation calls in shaders; empty if it needs none.
std::string_view kernel(Op op);

} // namespace isomotion::formula
