#include "formula/graph/graph.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include <fmt/format.h>

#include "formula/graph/angles.h"
#include "formula/graph/functions.h"
#include "formula/graph/operations.h"
#include "formula/graph/sign.h"

namespace isomotion::formula {
namespace {

using Fold = Operations<double>;

double fold(Op op, double a) {
    switch (op) {
    case Op::negate:
        return Fold::negate(a);
#define ROW(name, ...)                                                                             \
    case Op::name:                                                                                 \
        return Fold::name(a);
        ISOMOTION_FUNCTIONS(ROW)
#undef ROW
    default:
        assert(!"not a unary operation");
        return 0;
    }
}

double fold(Op op, double a, double b) {
    switch (op) {
#define ROW(name, ...)                                                                             \
    case Op::name:                                                                                 \
        return Fold::name(a, b);
        ISOMOTION_OPERATIONS_OF_TWO(ROW)
#undef ROW
    default:
        assert(!"not a foldable binary operation");
        return 0;
    }
}

// Nothing underflows where results are this large.
constexpr double no_underflow = 0x1p-900;

// What is no number stands for the entire line, which no operation but a change of sign keeps.
bool is_exact(Op op, double a, double result) {
    if (std::isnan(a)) return op == Op::negate;
    if (op == Op::sqrt) return a == 0 || (a > no_underflow && std::fma(result, result, -a) == 0);
    const Traits* row = unary_traits(op);
    return op == Op::negate || (row && row->shader != Shader::kernel);
}

// What may underflow counts as inexact.
bool is_exact(Op op, double a, double b, double result) {
    if (std::isnan(a) || std::isnan(b)) return false;
    const auto sum_is_exact = [&](double term) {
        const double from_a = result - term;
        return a - from_a == 0 && term - (result - from_a) == 0;
    };
    switch (op) {
    case Op::add:
        return sum_is_exact(b);
    case Op::subtract:
        return sum_is_exact(-b);
    case Op::multiply:
        return result == 0 ? a == 0 || b == 0
                           : std::abs(result) > no_underflow && std::fma(a, b, -result) == 0;
    case Op::divide:
        return b != 0 && std::abs(a) > no_underflow && std::fma(result, b, -a) == 0;
    case Op::min:
    case Op::max:
        return true;
    default:
        return false;
    }
}

Node leaf(Op op, int index = 0, int second = 0) {
    Node node;
    node.op = op;
    node.index = index;
    node.second = second;
    return node;
}

} // namespace

std::size_t Graph::Hash::operator()(const Node& node) const {
    std::uint64_t h = std::uint64_t(node.op) * 0x9E3779B97F4A7C15u;
    const auto mix = [&h](std::uint64_t v) {
        h ^= v + 0x9E3779B97F4A7C15u + (h << 6) + (h >> 2);
        h *= 0xBF58476D1CE4E5B9u;
    };
    mix(std::uint64_t(node.index));
    mix(std::uint64_t(node.second));
    mix(std::bit_cast<std::uint64_t>(node.value));
    for (int k = 0; k < node.arity; ++k) mix(node.children[std::size_t(k)]);
    return std::size_t(h);
}

bool Graph::makes_gaps(const Node& node) const {
    switch (node.op) {
    case Op::constant:
        return std::isnan(node.value);
    case Op::log:
    case Op::power:
        return !is_never_negative(*this, node.children[0]);
    case Op::divide: { // 0/0
        const NodeId by = node.children[1];
        return !is_constant(by) || is_constant(by, 0);
    }
    default:
        return false;
    }
}

NodeId Graph::intern(Node node) {
    for (int k = 0; k < node.arity; ++k)
        node.arrays |= nodes_[node.children[std::size_t(k)]].arrays;
    if (is_over_elements(node.op)) node.arrays &= ~(1u << node.index);
    node.may_have_gaps = makes_gaps(node);
    for (int k = 0; k < node.arity; ++k)
        node.may_have_gaps |= nodes_[node.children[std::size_t(k)]].may_have_gaps;
    if (node.op == Op::element) node.arrays = 1u << node.index;
    const auto [it, inserted] = ids_.try_emplace(node, NodeId(nodes_.size()));
    if (!inserted) return it->second;
    if (nodes_.size() >= limits::graph_nodes) {
        throw std::length_error(fmt::format(
            "the formula is too large: with its derivatives it takes more than {} operations",
            limits::graph_nodes));
    }
    nodes_.push_back(node);
    return it->second;
}

NodeId Graph::constant(double value) {
    Node node = leaf(Op::constant);
    node.value = value == 0 ? 0 : value; // one zero: -0 and 0 would not compare equal as keys
    if (std::isnan(value)) node.value = std::numeric_limits<double>::quiet_NaN();
    return intern(node);
}

NodeId Graph::input(int index) { return intern(leaf(Op::input, index)); }
NodeId Graph::parameter(int index) { return intern(leaf(Op::parameter, index)); }

NodeId Graph::element(int array, int field) {
    assert(array < max_arrays);
    return intern(leaf(Op::element, array, field));
}

NodeId Graph::unary(Op op, NodeId a) {
    const Node child = nodes_[a];
    if (child.op == Op::constant) {
        const double value = fold(op, child.value);
        if (!exactly_ || is_exact(op, child.value, value)) return constant(value);
    }
    if (op == Op::negate) {
        if (child.op == Op::negate) return child.children[0];
        if (child.op == Op::subtract) return subtract(child.children[1], child.children[0]);
        // A sign goes into a factor that is computed once, before the loop.
        if (child.op == Op::multiply && is_outside(child.children[0], child.children[1])) {
            return multiply(unary(Op::negate, child.children[0]), child.children[1]);
        }
    }
    if (op == Op::log) a = kept_not_negative(a);
    if (op == Op::sin || op == Op::cos || op == Op::tan) a = without_cuts(*this, op, a);
    if (op == Op::atan) {
        if (const auto half = half_angle(*this, a)) return *half;
    }
    if (op == Op::abs && (child.op == Op::abs || child.op == Op::negate)) {
        return unary(Op::abs, child.children[0]);
    }
    return make(op, a);
}

NodeId Graph::binary(Op op, NodeId a, NodeId b) {
    if (is_constant(a) && is_constant(b) && op != Op::random) {
        const double value = fold(op, nodes_[a].value, nodes_[b].value);
        if (!exactly_ || is_exact(op, nodes_[a].value, nodes_[b].value, value))
            return constant(value);
    }
    switch (op) {
    case Op::add:
        return add_simplified(a, b);
    case Op::subtract:
        return subtract_simplified(a, b);
    case Op::multiply:
        return multiply_simplified(a, b);
    case Op::divide:
        if (is_constant(a, 0)) return constant(0);
        if (is_constant(b, 1)) return a;
        break;
    case Op::power:
        if (is_constant(b)) {
            const double n = nodes_[b].value;
            if (n == std::floor(n) && std::abs(n) <= 256) return integer_power(a, int(n));
            if (n == 0.5) return unary(Op::sqrt, a);
        }
        return make(op, kept_not_negative(a), b);
    case Op::min: // as written, since derivatives decide ties by order
    case Op::max:
        if (a == b) return a;
        break;
    default:
        break;
    }
    return make(op, a, b);
}

NodeId Graph::add_simplified(NodeId a, NodeId b) {
    if (is_constant(a, 0)) return b;
    if (is_constant(b, 0)) return a;
    if (a == b) return multiply(constant(2), a);
    if (nodes_[b].op == Op::negate) return subtract(a, nodes_[b].children[0]);
    if (nodes_[a].op == Op::negate) return subtract(b, nodes_[a].children[0]);
    if (const auto factor = common_outside_factor(a, b)) {
        return multiply(*factor, add(nodes_[a].children[1], nodes_[b].children[1]));
    }
    return make_commutative(Op::add, a, b);
}

NodeId Graph::subtract_simplified(NodeId a, NodeId b) {
    if (is_constant(b, 0)) return a;
    if (is_constant(a, 0)) return unary(Op::negate, b);
    if (a == b) return is_constant(a) && std::isnan(nodes_[a].value) ? a : constant(0);
    if (nodes_[b].op == Op::negate) return add(a, nodes_[b].children[0]);
    if (const auto factor = common_outside_factor(a, b)) {
        return multiply(*factor, subtract(nodes_[a].children[1], nodes_[b].children[1]));
    }
    return make(Op::subtract, a, b);
}

// c - min(c, q) is max(c - q, 0), and so on; |b| - b is 2 max(0, -b). Written so, rounding cannot
// change its sign, and intervals know it. Derivatives of choices decide ties as before.
std::optional<NodeId> Graph::excess_over_choice(NodeId a, NodeId b) {
    const auto is_choice = [](const Node& node) {
        return node.op == Op::min || node.op == Op::max;
    };
    if (nodes_[a].op == Op::abs && nodes_[a].children[0] == b)
        return multiply(constant(2), binary(Op::max, constant(0), unary(Op::negate, b)));
    const Node left = nodes_[a], right = nodes_[b];
    if (!is_choice(left) && !is_choice(right)) return std::nullopt;
    std::array<NodeId, 2> parts{constant(0), constant(0)};
    for (const std::size_t k : {0u, 1u}) {
        if (is_choice(left) && left.children[k] == b) {
            parts[1 - k] = subtract(left.children[1 - k], b);
            return binary(left.op, parts[0], parts[1]);
        }
        if (is_choice(right) && right.children[k] == a) {
            parts[k] = subtract(a, right.children[1 - k]); // min prefers its second, max its first
            return binary(right.op == Op::min ? Op::max : Op::min, parts[0], parts[1]);
        }
    }
    return std::nullopt;
}

// k c - k min(c, q), where k is a constant above 0 and k c may be one, too.
std::optional<NodeId> Graph::scaled_excess(NodeId a, NodeId b) {
    const Node whole = nodes_[a], part = nodes_[b];
    if (part.op != Op::multiply) return std::nullopt;
    const NodeId factor = part.children[0];
    const double k = is_constant(factor) ? nodes_[factor].value : 0;
    if (!(k > 0)) return std::nullopt;
    std::optional<NodeId> c;
    if (whole.op == Op::multiply && whole.children[0] == factor) c = whole.children[1];
    if (whole.op == Op::constant && is_exact(Op::divide, whole.value, k, whole.value / k))
        c = constant(whole.value / k);
    const auto excess = c ? excess_over_choice(*c, part.children[1]) : std::nullopt;
    return excess ? std::optional(multiply(factor, *excess)) : std::nullopt;
}

// What rounding alone makes negative would have no power. A choice may drop what has no value, so
// only expressions that have one everywhere are rewritten.
NodeId Graph::kept_not_negative(NodeId a, int depth) {
    const Node base = nodes_[a];
    if (depth == 0 || base.may_have_gaps) return a;
    const auto child = [&](std::size_t k) {
        return kept_not_negative(base.children[k], depth - 1);
    };
    switch (base.op) {
    case Op::multiply:
        if (base.children[0] == base.children[1]) return a;
        return multiply(child(0), child(1));
    case Op::divide:
        return divide(child(0), base.children[1]);
    case Op::subtract:
        if (const auto excess = excess_over_choice(base.children[0], base.children[1]))
            return *excess;
        if (const auto excess = scaled_excess(base.children[0], base.children[1])) return *excess;
        return may_round_below_0(*this, a) ? binary(Op::max, constant(0), a) : a;
    case Op::add:
        for (const std::size_t k : {0u, 1u}) { // |x| + x
            const Node& size = nodes_[base.children[k]];
            const NodeId x = base.children[1 - k];
            if (size.op == Op::abs && size.children[0] == x)
                return multiply(constant(2), binary(Op::max, constant(0), x));
        }
        if (may_round_below_0(*this, a)) return binary(Op::max, constant(0), a);
        return is_never_negative(*this, a) ? add(child(0), child(1)) : a;
    default:
        return a;
    }
}

NodeId Graph::multiply_simplified(NodeId a, NodeId b) {
    if (is_constant(a, 0) || is_constant(b, 0)) return constant(0);
    if (is_constant(a, 1)) return b;
    if (is_constant(b, 1)) return a;
    if (is_constant(a, -1)) return unary(Op::negate, b);
    if (is_constant(b, -1)) return unary(Op::negate, a);
    if (a == b && nodes_[a].op == Op::abs) {
        return multiply(nodes_[a].children[0], nodes_[a].children[0]);
    }
    // Signs move outwards, where sums absorb them, but not out of what a loop computes once.
    for (const auto& [signed_one, other] : {std::pair(a, b), std::pair(b, a)}) {
        if (nodes_[signed_one].op == Op::negate && !is_outside(signed_one, other)) {
            return unary(Op::negate, multiply(nodes_[signed_one].children[0], other));
        }
    }
    // c1 * (c2 * x): derivatives pile up constant factors.
    if (is_constant(b)) std::swap(a, b);
    if (is_constant(a) && nodes_[b].op == Op::multiply && is_constant(nodes_[b].children[0])) {
        const double other = nodes_[nodes_[b].children[0]].value, factor = nodes_[a].value * other;
        if (std::isfinite(factor) &&
            (!exactly_ || is_exact(Op::multiply, nodes_[a].value, other, factor)))
            return multiply(constant(factor), nodes_[b].children[1]);
    }
    // What doesn't change with a loop's element moves out of the products that do, to be computed
    // once or to leave the sum altogether: a * (c * y) is (a * c) * y or c * (a * y).
    if (is_outside(b, a)) std::swap(a, b);
    for (const auto& [product, other] : {std::pair(b, a), std::pair(a, b)}) {
        if (nodes_[product].op != Op::multiply || is_outside(product, other)) continue;
        const NodeId c = nodes_[product].children[0], y = nodes_[product].children[1];
        if (!is_outside(c, y)) continue;
        if (is_outside(other, y)) return multiply(multiply(other, c), y);
        if (is_outside(c, other)) return multiply(c, multiply(other, y));
    }
    return make_commutative(Op::multiply, a, b);
}

bool Graph::is_outside(NodeId a, NodeId b) const {
    const std::uint32_t outer = nodes_[a].arrays, inner = nodes_[b].arrays;
    return outer != inner && (outer & ~inner) == 0;
}

std::optional<NodeId> Graph::common_outside_factor(NodeId a, NodeId b) const {
    const Node &x = nodes_[a], &y = nodes_[b];
    if (x.op != Op::multiply || y.op != Op::multiply) return std::nullopt;
    if (x.children[0] != y.children[0]) return std::nullopt;
    const bool outside =
        is_outside(x.children[0], x.children[1]) && is_outside(y.children[0], y.children[1]);
    return outside ? std::optional(x.children[0]) : std::nullopt;
}

NodeId Graph::make(Op op, NodeId a) {
    Node node = leaf(op);
    node.arity = 1;
    node.children = {a};
    return intern(node);
}

NodeId Graph::make(Op op, NodeId a, NodeId b) {
    Node node = leaf(op);
    node.arity = 2;
    node.children = {a, b};
    return intern(node);
}

NodeId Graph::make(Op op, int index, const std::array<NodeId, 3>& operands) {
    Node node = leaf(op, index);
    node.arity = 3;
    std::ranges::copy(operands, node.children.begin());
    return intern(node);
}

NodeId Graph::make_commutative(Op op, NodeId a, NodeId b) {
    const auto rank = [this](NodeId id) {
        return std::tuple(!is_constant(id), std::popcount(nodes_[id].arrays), id);
    };
    return rank(b) < rank(a) ? make(op, b, a) : make(op, a, b);
}

NodeId Graph::select(NodeId a, NodeId b, NodeId then, NodeId otherwise, Op slope_of) {
    if (then == otherwise) return then;
    const bool is_known =
        is_constant(a) && is_constant(b) &&
        !(exactly_ && (std::isnan(nodes_[a].value) || std::isnan(nodes_[b].value)));
    if (is_known) return nodes_[a].value < nodes_[b].value ? then : otherwise;
    Node node = leaf(Op::select, int(slope_of));
    node.arity = 4;
    node.children = {a, b, then, otherwise};
    return intern(node);
}

NodeId Graph::at(int input, const std::array<NodeId, 3>& point) {
    return make(Op::at, input, point);
}

NodeId Graph::noise(const std::array<NodeId, 3>& place, const NoiseOrder& order) {
    if (std::ranges::any_of(order.along, [](int n) { return n > NoiseOrder::most; }))
        return constant(0);
    const auto number = [&](std::size_t axis) { return nodes_[place[axis]].value; };
    if (!exactly_ && std::ranges::all_of(place, [&](NodeId id) { return is_constant(id); }))
        return constant(formula::noise(number(0), number(1), number(2), order));
    return make(Op::noise, order.packed(), place);
}

NodeId Graph::chebyshev(int degree, NodeId a, int derivative) {
    assert(degree >= 0 && derivative >= 0);
    if (derivative > degree) return constant(0);
    if (degree == 0) return constant(1);
    if (degree == 1) return derivative == 0 ? a : constant(1);
    Node node = leaf(Op::chebyshev, degree, derivative);
    node.arity = 1;
    node.children = {a};
    return intern(node);
}

NodeId Graph::sum(int array, NodeId body) {
    if (is_constant(body, 0)) return body;
    // Signs, and factors that are the same for every element, leave the sum.
    const Node inner = nodes_[body];
    const std::uint32_t bit = 1u << array;
    if (inner.op == Op::negate) return unary(Op::negate, sum(array, inner.children[0]));
    for (const std::size_t k : {0u, 1u}) {
        const NodeId factor = inner.children[k], rest = inner.children[1 - k];
        if (inner.op == Op::multiply && !(nodes_[factor].arrays & bit) &&
            (nodes_[rest].arrays & bit)) {
            return multiply(factor, sum(array, rest));
        }
    }
    return over_elements(Op::sum, array, body);
}

NodeId Graph::over_elements(Op op, int array, NodeId a) {
    Node node = leaf(op, array);
    node.arity = 1;
    node.children = {a};
    return intern(node);
}

NodeId Graph::pick(int array, NodeId key, NodeId value) {
    if (is_constant(value, 0)) return value;
    Node node = leaf(Op::pick, array);
    node.arity = 2;
    node.children = {key, value};
    return intern(node);
}

NodeId Graph::integer_power(NodeId a, int n) {
    if (n < 0) return divide(constant(1), integer_power(a, -n));
    if (n == 0) return constant(1);
    if (nodes_[a].op == Op::abs && n % 2 == 0) return integer_power(nodes_[a].children[0], n);
    if (const std::optional<double> end = reach(n)) {
        const NodeId high = constant(*end), low = unary(Op::negate, high);
        a = binary(Op::max, low, binary(Op::min, high, a));
    }
    return repeated_product(a, n);
}

NodeId Graph::repeated_product(NodeId a, int n) {
    if (n == 1) return a;
    const NodeId half = repeated_product(a, n / 2);
    const NodeId square = multiply(half, half);
    return n % 2 == 0 ? square : multiply(square, a);
}

// High powers overflow float inside ordinary bounds (6^200); clamping the base keeps sums of them
// free of inf - inf. Low ones don't, and stay bare products that others can share.
std::optional<double> Graph::reach(int n) {
    constexpr int bare = 24;
    if (n <= bare) return std::nullopt;
    return std::pow(double(Operations<float>::saturation()), 1.0 / n);
}

std::string_view name(Op op) {
    switch (op) {
    case Op::constant:
        return "constant";
    case Op::input:
        return "input";
    case Op::parameter:
        return "parameter";
    case Op::element:
        return "element";
    case Op::negate:
        return "negate";
#define ROW(name, ...)                                                                             \
    case Op::name:                                                                                 \
        return #name;
        ISOMOTION_FUNCTIONS(ROW)
#undef ROW
#define ROW(name, ...)                                                                             \
    case Op::name:                                                                                 \
        return #name;
        ISOMOTION_OPERATIONS_OF_TWO(ROW)
#undef ROW
    case Op::random:
        return "random";
    case Op::chebyshev:
        return "chebyshev";
    case Op::noise:
        return "noise";
    case Op::select:
        return "select";
    case Op::at:
        return "at";
    case Op::sum:
        return "sum";
    case Op::least:
        return "least";
    case Op::pick:
        return "pick";
    case Op::which:
        return "which";
    }
    return "?";
}

} // namespace isomotion::formula
