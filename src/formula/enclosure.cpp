#include "formula/enclosure.h"

#include "formula/graph/continuity.h"
#include "formula/graph/decoration.h"
#include "formula/graph/degree.h"
#include "formula/graph/derivative.h"
#include "formula/graph/roughness.h"

namespace isomotion::formula {

namespace {

std::vector<NodeId> direction(Graph& g) {
    return {g.input(first_direction), g.input(first_direction + 1), g.input(first_direction + 2)};
}

bool has_chebyshev(const Graph& g) {
    for (std::size_t id = 0; id < g.size(); ++id) {
        if (g[NodeId(id)].op == Op::chebyshev) return true;
    }
    return false;
}

} // namespace

EnclosurePrograms enclosure_programs(const Field& field) {
    Graph g = field.graph;
    g.fold_exactly();
    const NodeId without = gaps(g, field.root), value = g.add(field.root, without);
    const auto slope = [&](const std::vector<NodeId>& directions) {
        const NodeId all = differentiate_inputs(g, field.root, directions, Slopes::generalized);
        return g.add(all, without);
    };
    const NodeId one = g.constant(1), zero = g.constant(0);
    const NodeId along = slope(direction(g));
    const std::array gradient{slope({one, zero, zero}), slope({zero, one, zero}),
                              slope({zero, zero, one})};
    const NodeId jump = jumps(g, field.root);
    const NodeId is_root = field.wall_distance > 0 ? unless_bounded(g, value) : jump;
    return {schedule(g, std::array{value}),
            schedule(g, std::array{value, along}),
            schedule(g, gradient),
            schedule(g, std::array{is_root}),
            schedule(g, std::array{jump, without_value(g, field.root)}),
            schedule(g, std::array{value, anywhere(g, roughness(g, field.root))})};
}

Program value_enclosure(const Field& field) {
    Graph g = field.graph;
    g.fold_exactly();
    return schedule(g, std::array{g.add(field.root, gaps(g, field.root))});
}

std::optional<Program> hessian_program(const Field& field) {
    if (!degree(field.graph, field.root) || has_chebyshev(field.graph)) return {};
    Graph g = field.graph;
    g.fold_exactly();
    const NodeId along = differentiate_inputs(g, field.root, direction(g));
    const NodeId one = g.constant(1), zero = g.constant(0);
    std::vector<NodeId> outputs{field.root, along};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::vector<NodeId> directions(6, zero); // the ray's rests
        directions[axis] = one;
        outputs.push_back(differentiate_inputs(g, along, directions));
    }
    return schedule(g, outputs);
}

} // namespace isomotion::formula
