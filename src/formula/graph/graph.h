// The expression graph: the meaning of a formula, shared by all back ends.
//
// Nodes are hash-consed: equal expressions are one node, so a common subexpression is evaluated
// once, in GLSL and on the CPU alike. As nodes are made, constants are folded and trivial algebra
// (x*1, x+0, 0*x) is simplified; factors that are the same for all elements of a sum are moved out
// of it. A graph only grows, up to limits::graph_nodes, beyond which functions that make nodes
// throw std::length_error. Node ids are topologically ordered (children before parents).
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "formula/graph/function_table.h"
#include "formula/graph/limits.h"
#include "formula/graph/noise.h"

namespace isomotion::formula {

using NodeId = std::uint32_t;

enum class Op : std::uint8_t {
    constant,  // value
    input,     // index: x, y, z and the vocabulary's other inputs (ray direction, t, ...)
    parameter, // index into the parameter values
    element,   // field `second` of array `index` at the loop's current element
    negate,
#define ROW(name, ...) name,
    ISOMOTION_FUNCTIONS(ROW) // of one argument: abs, sqrt, ...
#undef ROW
#define ROW(name, ...) name,
    ISOMOTION_OPERATIONS_OF_TWO(ROW) // add, min, ..., power, whose integer exponents are products
#undef ROW
    random,    // random(i, k) in [0, 1): CPU double only
    chebyshev, // `second`-th derivative of T_index(a)
    noise,     // gradient noise at (a, b, c), differentiated as `index` packs it: noise.h
    select,    // a < b ? c : d; `index`: Graph::select's slope_of
    sum,       // sum of a over the elements of array `index`
    least,     // the least a over them; saturation without elements
    pick,      // b of the first element whose a is least; 0 without elements
    which,     // the number of that element, from 1; 0 without elements: for continuity.h
    at,        // the expression that input `index` stands for, at the point (a, b, c): only in the
               // bodies of functions (own_functions.h)
};

constexpr bool is_arithmetic(Op op) {
    return op == Op::add || op == Op::subtract || op == Op::multiply || op == Op::divide;
}

// Whether the operation loops over the elements of array `index`.
constexpr bool is_over_elements(Op op) {
    return op == Op::sum || op == Op::least || op == Op::pick || op == Op::which;
}

// Whether the operation finds the least element but returns something else than its key.
constexpr bool keeps_least(Op op) { return op == Op::pick || op == Op::which; }

struct Node {
    Op op = Op::constant;
    std::uint8_t arity = 0;
    int index = 0;
    int second = 0;
    double value = 0;
    std::array<NodeId, 4> children{};
    // Bit k set: the value changes with the current element of array k, so the node lives inside
    // a loop over that array.
    std::uint32_t arrays = 0;
    // Somewhere it may have no value, as far as its form shows: the log of what may be negative.
    bool may_have_gaps = false;

    // Numbers are compared by their bits, so that NaN equals itself and the graph holds each node
    // once.
    bool operator==(const Node& other) const {
        return op == other.op && arity == other.arity && index == other.index &&
               second == other.second && arrays == other.arrays && children == other.children &&
               std::bit_cast<std::uint64_t>(value) == std::bit_cast<std::uint64_t>(other.value);
    }
};

class Graph {
public:
    const Node& operator[](NodeId id) const { return nodes_[id]; }
    std::size_t size() const { return nodes_.size(); }

    // From now on constants are folded only where that is exact, for expressions such as slopes
    // whose intervals must hold the exact value.
    void fold_exactly() { exactly_ = true; }

    NodeId constant(double value);
    NodeId input(int index);
    NodeId parameter(int index);
    NodeId element(int array, int field);

    NodeId unary(Op op, NodeId a);
    NodeId binary(Op op, NodeId a, NodeId b);
    // `slope_of`: min or max if it is the slope of one of a and b, which tapes ask for; select if
    // it is a choice that a formula makes (conditions.h).
    NodeId select(NodeId a, NodeId b, NodeId then, NodeId otherwise, Op slope_of = Op::constant);
    // The `derivative`-th derivative of the Chebyshev polynomial T_degree at a; degree >= 0.
    NodeId chebyshev(int degree, NodeId a, int derivative = 0);
    NodeId noise(const std::array<NodeId, 3>& place, const NoiseOrder& order = {});
    NodeId sum(int array, NodeId body);
    NodeId least(int array, NodeId key) { return over_elements(Op::least, array, key); }
    NodeId pick(int array, NodeId key, NodeId value);
    NodeId at(int input, const std::array<NodeId, 3>& point);
    NodeId which(int array, NodeId key) { return over_elements(Op::which, array, key); }
    // a^n as a product of squares; x^2, x^4 and x^6 of one formula share them.
    NodeId integer_power(NodeId a, int n);
    // The largest base of the n-th power, if that is cut off: max(-reach, min(reach, a))^n.
    static std::optional<double> reach(int n);
    // a^n for n > 0, by repeated squaring, nowhere cut off.
    NodeId repeated_product(NodeId a, int n);

    NodeId add(NodeId a, NodeId b) { return binary(Op::add, a, b); }
    NodeId subtract(NodeId a, NodeId b) { return binary(Op::subtract, a, b); }
    NodeId multiply(NodeId a, NodeId b) { return binary(Op::multiply, a, b); }
    NodeId divide(NodeId a, NodeId b) { return binary(Op::divide, a, b); }

    bool is_constant(NodeId id) const { return nodes_[id].op == Op::constant; }
    bool is_constant(NodeId id, double value) const {
        return is_constant(id) && nodes_[id].value == value;
    }

private:
    NodeId intern(Node node);
    // Whether it may have no value where its operands have.
    bool makes_gaps(const Node& node) const;
    NodeId over_elements(Op op, int array, NodeId a);
    NodeId make(Op op, NodeId a);
    NodeId make(Op op, NodeId a, NodeId b);
    NodeId make(Op op, int index, const std::array<NodeId, 3>& operands);
    // A canonical order for commutative operations: constants first, then values computed outside
    // of loops. So x*y and y*x are one node.
    NodeId make_commutative(Op op, NodeId a, NodeId b);

    NodeId add_simplified(NodeId a, NodeId b);
    NodeId subtract_simplified(NodeId a, NodeId b);
    NodeId multiply_simplified(NodeId a, NodeId b);

    // True if a is computed outside some loop that contains b, and inside no other loop.
    bool is_outside(NodeId a, NodeId b) const;
    // f, if a = f*x and b = f*y and f is outside the loops of x and of y.
    std::optional<NodeId> common_outside_factor(NodeId a, NodeId b) const;
    // a - b, if one of them is the smaller or the larger of the other and something else.
    std::optional<NodeId> excess_over_choice(NodeId a, NodeId b);
    std::optional<NodeId> scaled_excess(NodeId a, NodeId b);
    NodeId kept_not_negative(NodeId a, int depth = 4);

    struct Hash {
        std::size_t operator()(const Node& node) const;
    };
    std::vector<Node> nodes_;
    std::unordered_map<Node, NodeId, Hash> ids_;
    bool exactly_ = false;
};

inline constexpr int max_arrays = limits::arrays;

std::string_view name(Op op);

} // namespace isomotion::formula
