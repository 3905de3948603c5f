#include "nodes/second_order.h"

#include "formula/graph/derivative.h"
#include "formula/graph/lowering.h"

namespace isomotion {
namespace {

using namespace formula;

constexpr std::size_t inputs = 3, outputs = 10;

Program second_order_program(const Field& field) {
    Graph graph = field.graph;
    const NodeId one = graph.constant(1), zero = graph.constant(0);
    const std::array<std::vector<NodeId>, 3> axes{
        {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}};
    std::vector<NodeId> roots{field.root};
    for (const auto& axis : axes) roots.push_back(differentiate_inputs(graph, field.root, axis));
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column <= row; ++column) {
            roots.push_back(differentiate_inputs(graph, roots[1 + row], axes[column]));
        }
    }
    return schedule(graph, lower(graph, roots));
}

} // namespace

SecondOrderField::SecondOrderField(const Field& field, Bindings<double> bindings)
    : program_(second_order_program(field))
    , evaluator_(program_)
    , bindings_(std::move(bindings)) {}

void SecondOrderField::at(std::span<const glm::dvec3> points, std::span<SecondOrder> results) {
    const std::size_t count = points.size();
    columns_.resize((inputs + outputs) * count);
    std::array<std::span<const double>, inputs> in;
    std::array<std::span<double>, outputs> out;
    for (std::size_t k = 0; k < inputs; ++k) {
        double* const column = &columns_[k * count];
        for (std::size_t i = 0; i < count; ++i) column[i] = points[i][int(k)];
        in[k] = {column, count};
    }
    for (std::size_t k = 0; k < outputs; ++k) out[k] = {&columns_[(inputs + k) * count], count};
    evaluator_.points(bindings_, in, out);
    for (std::size_t i = 0; i < count; ++i) {
        SecondOrder& f = results[i];
        f.value = out[0][i];
        std::size_t next = 4;
        for (int row = 0; row < 3; ++row) {
            f.gradient[row] = out[std::size_t(1 + row)][i];
            for (int column = 0; column <= row; ++column, ++next) {
                f.hessian[column][row] = f.hessian[row][column] = out[next][i];
            }
        }
    }
}

} // namespace isomotion
