#include "formula/enclosure.h"

#include "formula/derivative.h"

namespace isomotion::formula {

EnclosurePrograms enclosure_programs(const Field& field) {
    Graph g = field.graph;
    const auto slope = [&](const std::vector<NodeId>& directions) {
        return differentiate_inputs(g, field.root, directions, Slopes::generalized);
    };
    const NodeId one = g.constant(1), zero = g.constant(0);
    const NodeId along = slope(
        {g.input(first_direction), g.input(first_direction + 1), g.input(first_direction + 2)});
    const std::array gradient{slope({one, zero, zero}), slope({zero, one, zero}),
                              slope({zero, zero, one})};
    return {schedule(g, std::array{field.root}), schedule(g, std::array{field.root, along}),
            schedule(g, gradient)};
}

} // namespace isomotion::formula
