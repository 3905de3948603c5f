#include "topology/field/point_field.h"

#include <algorithm>

#include "formula/graph/lowering.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

formula::Program with_derivatives(const SpaceFormula& formula) {
    formula::Graph g = formula.graph;
    constexpr std::array<std::size_t, 3> axes{0, 1, 2};
    return formula::schedule(g,
                             formula::lower(g, jet_at_points(g, formula.root, axes, axes.size())));
}

} // namespace

PointField::PointField(const SpaceFormula& formula)
    : sign_of_solid_(formula.solid == Side::negative ? 1 : -1)
    , program_(with_derivatives(formula))
    , evaluator_(program_, 3, 3) {
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
    evaluator_.evaluate(bindings_, points);
    jets.resize(points.size());
    for (std::size_t p = 0; p < points.size(); ++p) {
        const Jet<double> f = evaluator_.jet(p);
        jets[p].value = sign_ * f.value;
        for (std::size_t i = 0; i < 3; ++i) {
            jets[p].gradient[i] = sign_ * f.gradient[i];
            for (std::size_t j = 0; j < 3; ++j) jets[p].hessian[i][j] = sign_ * f.hessian[i][j];
        }
    }
}

} // namespace isomotion::topology
