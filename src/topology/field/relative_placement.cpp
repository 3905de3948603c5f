#include "topology/field/relative_placement.h"

#include <cmath>
#include <numbers>

#include "formula/graph/continuity.h"

namespace isomotion::topology {
namespace {

using formula::Graph;
using formula::NodeId;
using formula::Op;
using Vector = std::array<NodeId, 3>;
using Matrix = std::array<Vector, 3>; // rows

struct Turn {
    NodeId cosine, sine;
};

// Turns by an angle in degrees. Quarter turns are exact, so that boxes stay boxes along the axes.
Turn turn(Graph& g, NodeId degrees) {
    if (g.is_constant(degrees)) {
        const double angle = std::remainder(g[degrees].value, 360.0);
        if (std::remainder(angle, 90.0) == 0) {
            constexpr std::array<double, 4> sines{0, 1, 0, -1};
            const auto quarter = std::size_t(int(angle / 90) + 4);
            return {g.constant(sines[(quarter + 1) % 4]), g.constant(sines[quarter % 4])};
        }
    }
    const NodeId angle = g.multiply(degrees, g.constant(std::numbers::pi / 180));
    return {g.unary(Op::cos, angle), g.unary(Op::sin, angle)};
}

Matrix product(Graph& g, const Matrix& a, const Matrix& b) {
    Matrix result{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            NodeId sum = g.constant(0);
            for (std::size_t k = 0; k < 3; ++k) sum = g.add(sum, g.multiply(a[i][k], b[k][j]));
            result[i][j] = sum;
        }
    }
    return result;
}

Matrix transposed(const Matrix& a) {
    Matrix result{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) result[i][j] = a[j][i];
    }
    return result;
}

Vector product(Graph& g, const Matrix& a, const Vector& v) {
    Vector result{};
    for (std::size_t i = 0; i < 3; ++i) {
        NodeId sum = g.constant(0);
        for (std::size_t k = 0; k < 3; ++k) sum = g.add(sum, g.multiply(a[i][k], v[k]));
        result[i] = sum;
    }
    return result;
}

// Turns about the fixed axes x, then y, then z.
Matrix rotation(Graph& g, const Vector& degrees) {
    const auto [cx, sx] = turn(g, degrees[0]);
    const auto [cy, sy] = turn(g, degrees[1]);
    const auto [cz, sz] = turn(g, degrees[2]);
    const NodeId zero = g.constant(0), one = g.constant(1);
    const auto minus = [&](NodeId a) { return g.unary(Op::negate, a); };
    const Matrix x{{{one, zero, zero}, {zero, cx, minus(sx)}, {zero, sx, cx}}};
    const Matrix y{{{cy, zero, sy}, {zero, one, zero}, {minus(sy), zero, cy}}};
    const Matrix z{{{cz, minus(sz), zero}, {sz, cz, zero}, {zero, zero, one}}};
    return product(g, z, product(g, y, x));
}

} // namespace

PlacementNodes placement_nodes(const scene::Placement& placement, Graph& graph,
                               animation::Rules& rules) {
    const auto track = [&](int k) { return formula::with_gaps(graph, rules.track(k)); };
    PlacementNodes nodes;
    for (std::size_t k = 0; k < 3; ++k) {
        nodes.translate[k] = track(placement.translate[k]);
        nodes.rotate[k] = track(placement.rotate[k]);
    }
    nodes.scale = track(placement.scale);
    return nodes;
}

Vector coordinates_in(Graph& g, const PlacementNodes& from, const PlacementNodes& to) {
    Vector between{};
    for (std::size_t k = 0; k < 3; ++k) {
        between[k] = from.translate[k] == to.translate[k]
                         ? g.constant(0)
                         : g.subtract(from.translate[k], to.translate[k]);
    }
    const Matrix back = transposed(rotation(g, to.rotate));
    const NodeId one = g.constant(1), zero = g.constant(0);
    Matrix turned{{{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}};
    if (from.rotate != to.rotate) turned = product(g, back, rotation(g, from.rotate));
    const NodeId ratio = from.scale == to.scale ? one : g.divide(from.scale, to.scale);
    const Vector offset = product(g, back, between);
    const Vector place{g.input(0), g.input(1), g.input(2)};
    Vector result = product(g, turned, place);
    for (std::size_t k = 0; k < 3; ++k) {
        result[k] = g.add(g.multiply(ratio, result[k]), g.divide(offset[k], to.scale));
    }
    return result;
}

} // namespace isomotion::topology
