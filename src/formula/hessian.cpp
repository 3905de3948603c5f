#include "formula/hessian.h"

#include "formula/graph/derivative.h"
#include "formula/graph/in_range.h"
#include "formula/graph/lowering.h"

namespace isomotion::formula {

Program hessian(const Field& field) {
    Graph g = field.graph; // the field keeps its own, which holds the first derivatives already
    std::array<std::vector<NodeId>, 3> axes;
    for (std::size_t k = 0; k < 3; ++k) {
        axes[k].assign(3, g.constant(0));
        axes[k][k] = g.constant(1);
    }
    const InRange in_range(g, field.root, Purpose::numbers);
    std::vector<NodeId> second;
    for (std::size_t i = 0; i < 3; ++i) {
        const NodeId first = differentiate_inputs(g, in_range.root(), axes[i]);
        for (std::size_t j = i; j < 3; ++j) {
            second.push_back(differentiate_inputs(g, first, axes[j], Slopes::pointwise_again));
        }
    }
    return schedule(g, lower(g, in_range.complete(second)));
}

std::string glsl_hessian(const Program& hessian, const ArrayPacking& packing) {
    return "struct Hessian { float xx, xy, xz, yy, yz, zz; };\n" +
           emit_glsl(hessian, {"Hessian field_hessian(vec3 p)", "Hessian", {"p.x", "p.y", "p.z"}},
                     packing);
}

} // namespace isomotion::formula
