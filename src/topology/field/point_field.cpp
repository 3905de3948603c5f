#include "topology/field/point_field.h"

#include <algorithm>

#include "formula/graph/derivative.h"
#include "formula/graph/lowering.h"

namespace isomotion::topology {
namespace {

using formula::Graph;
using formula::Interval;
using formula::NodeId;
using formula::Slopes;

// The value, x y z, xx xy xz yy yz zz.
constexpr std::size_t second[3][3] = {{4, 5, 6}, {5, 7, 8}, {6, 8, 9}};

formula::Program with_derivatives(const SpaceFormula& formula) {
    Graph g = formula.graph;
    std::array<std::vector<NodeId>, 3> axes;
    for (std::size_t i = 0; i < 3; ++i) {
        axes[i].assign(3, g.constant(0));
        axes[i][i] = g.constant(1);
    }
    std::vector<NodeId> outputs{formula.root};
    for (std::size_t i = 0; i < 3; ++i)
        outputs.push_back(differentiate_inputs(g, formula.root, axes[i]));
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = i; j < 3; ++j) {
            outputs.push_back(
                differentiate_inputs(g, outputs[1 + i], axes[j], Slopes::pointwise_again));
        }
    }
    return formula::schedule(g, formula::lower(g, outputs));
}

} // namespace

PointField::PointField(const SpaceFormula& formula)
    : sign_of_solid_(formula.solid == Side::negative ? 1 : -1)
    , program_(with_derivatives(formula))
    , evaluator_(program_) {
    bind(formula.bindings, false);
}

void PointField::bind(const formula::Bindings<Interval>& bindings, bool is_turned) {
    sign_ = is_turned ? -sign_of_solid_ : sign_of_solid_;
    const auto middles = [](const std::vector<Interval>& from) {
        std::vector<double> numbers(from.size());
        std::ranges::transform(from, numbers.begin(), [](const Interval& a) { return mid(a); });
        return numbers;
    };
    bindings_.parameters = middles(bindings.parameters);
    bindings_.seed = bindings.seed;
    bindings_.arrays.clear();
    for (const auto& array : bindings.arrays) {
        bindings_.arrays.push_back({array.count, {}});
        auto& columns = bindings_.arrays.back();
        for (const auto& field : array.fields) columns.fields.push_back(middles(field));
    }
}

void PointField::jets(std::span<const SpacePoint> points, std::vector<PointJet>& jets) {
    std::array<std::span<const double>, 3> in;
    for (std::size_t i = 0; i < 3; ++i) {
        inputs_[i].resize(points.size());
        for (std::size_t p = 0; p < points.size(); ++p) inputs_[i][p] = points[p][i];
        in[i] = inputs_[i];
    }
    std::array<std::span<double>, 10> out;
    for (std::size_t o = 0; o < out.size(); ++o) {
        outputs_[o].resize(points.size());
        out[o] = outputs_[o];
    }
    evaluator_.points(bindings_, in, out);
    jets.resize(points.size());
    for (std::size_t p = 0; p < points.size(); ++p) {
        jets[p].value = sign_ * outputs_[0][p];
        for (std::size_t i = 0; i < 3; ++i) {
            jets[p].gradient[i] = sign_ * outputs_[1 + i][p];
            for (std::size_t j = 0; j < 3; ++j)
                jets[p].hessian[i][j] = sign_ * outputs_[second[i][j]][p];
        }
    }
}

} // namespace isomotion::topology
