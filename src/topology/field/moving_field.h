// F and its derivatives in space and by the clock, over boxes as intervals and at points as
// doubles.
//
// A stratum of the bounds is its inside, a face, an edge or a corner. The coordinates that are not
// free there follow the bounds, and F is a function of the free ones and the clock. The variables
// below are the free ones of x, y, z, then the clock. If all three are free they may move with the
// surface (ComovingFrame); then the variables are places at rest.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "formula/evaluate/evaluate.h"
#include "formula/graph/program.h"
#include "formula/interval/interval.h"
#include "topology/field/box_field.h"
#include "topology/field/comoving_frame.h"
#include "topology/field/motion.h"
#include "topology/field/point_evaluator.h"

namespace isomotion::topology {

struct Stratum {
    enum class End : char { free, low, high };
    std::array<End, 3> axes{End::free, End::free, End::free};

    int dimension() const;
    bool operator==(const Stratum&) const = default;
};

// All strata of a box, the inside first.
std::vector<Stratum> strata_of_box();

class MovingField {
public:
    // `multipliers` holds the ranges of the motion's multipliers, if it has any (kinks.h). They are
    // variables too, between the coordinates and the clock.
    MovingField(const Motion& motion, const Stratum& stratum, const ComovingFrame& frame = {},
                std::span<const formula::Interval> multipliers = {});

    int variables() const { return variables_; }
    int dimension() const { return dimension_; } // free coordinates
    std::size_t clock() const { return std::size_t(variables_ - 1); }
    const Stratum& stratum() const { return stratum_; }
    // Contains the stratum at all times.
    const Box& domain() const { return domain_; }
    // Free coordinate k of the points in a box.
    formula::Interval x(const Box& box, std::size_t k) const;

private:
    friend class Enclosures;
    friend class Numbers;

    // Rewrites all of them: expressions linear in the clock by their values at the clock's ends.
    void between_ends(formula::Graph& graph, std::vector<formula::NodeId>& jet,
                      std::vector<SumSlopes>& slopes) const;

    Stratum stratum_;
    ComovingFrame comoving_;
    int dimension_ = 0, variables_ = 0;
    Box domain_{};
    formula::Bindings<double> bindings_;
    BoxField over_boxes_;
    formula::Program numbers_; // the same jet in doubles
    formula::Program place_;   // one output for each condition, at least 0 in the closed stratum
    formula::Program inward_;  // inward derivatives of F along the fixed axes
};

// Evaluates over boxes. Use one per thread.
class Enclosures : public BoxEvaluator {
public:
    explicit Enclosures(const MovingField& field);

    enum class Place { outside, inside, unknown };
    Place place(const Box& box); // in the stratum
    // The inward derivatives of F along the fixed axes.
    std::vector<formula::Interval> inward(const Box& box);

private:
    // At least 0 in the closed stratum.
    std::span<const formula::Interval> conditions(const Box& box);

    formula::Evaluator<formula::Interval> place_, inward_;
    std::vector<formula::Interval> conditions_, inward_values_;
};

// Evaluates at points, with all elements.
class Numbers {
public:
    explicit Numbers(const MovingField& field);

    Jet<double> jet(const Point& point);
    void jets(std::span<const Point> points, std::vector<Jet<double>>& jets);

private:
    const MovingField& field_;
    PointEvaluator evaluator_;
};

} // namespace isomotion::topology
