// A frame's field at points, in doubles, with first and second derivatives. Paths are sought with
// it before they are proved.
#pragma once

#include <span>
#include <vector>

#include "topology/field/point_evaluator.h"
#include "topology/field/space_formula.h"
#include "topology/field/space_point.h"

namespace isomotion::topology {

struct PointJet {
    double value = 0;
    SpacePoint gradient{};
    SpaceMatrix hessian{};
};

// Use one per thread.
class PointField {
public:
    explicit PointField(const SpaceFormula& formula);
    PointField(const PointField&) = delete; // since the evaluator refers to the program
    PointField& operator=(const PointField&) = delete;

    // Binds G with the middles of these values, or -G.
    void bind(const formula::Bindings<formula::Interval>& bindings, bool is_turned);

    void jets(std::span<const SpacePoint> points, std::vector<PointJet>& jets);

private:
    double sign_of_solid_, sign_ = 1;
    formula::Program program_;
    PointEvaluator evaluator_;
    formula::Bindings<double> bindings_;
};

} // namespace isomotion::topology
