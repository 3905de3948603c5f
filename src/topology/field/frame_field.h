// A frame's field over boxes of space, with its gradient; of sums only the elements that matter.
//
// G is F where the solid is {F < 0}, else -F. Slopes are generalized (formula/enclosure.h): a
// gradient encloses all difference quotients between points of the box, also across kinks. In a
// small box most elements of a sum are far away and hardly change; what these add is enclosed once,
// for a box, and holds for all boxes in it.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "formula/interval/interval.h"
#include "topology/field/space_box.h"
#include "topology/field/space_formula.h"

namespace isomotion::topology {

// One a thread.
class FrameField {
public:
    explicit FrameField(const SpaceFormula& formula);

    // Other values for the same names.
    void bind(formula::Bindings<formula::Interval> bindings) { bindings_ = std::move(bindings); }

    // Of one sum, in a box.
    struct Elements {
        std::vector<std::vector<formula::Interval>> columns; // of the fields that the sum reads
        int count = 0;
        std::array<formula::Interval, 10> others{}; // what those left out add, with derivatives
    };
    using Near = std::vector<Elements>; // one for each sum

    Near everything() const;

    // Over boxes where `near` holds.
    void over(const Near& near, std::span<const SpaceBox> boxes, std::span<ValueAndGradient> out);
    // The same by Taylor's formula about the middle, to second order: tighter in small boxes.
    // Leaves `out` as it is where the formula has kinks.
    void tighten(const Near& near, std::span<const SpaceBox> boxes,
                 std::span<ValueAndGradient> out);
    void values(const Near& near, std::span<const SpaceBox> boxes,
                std::span<formula::Interval> out);

    // Second derivatives; without bounds where the formula has kinks.
    SpaceHessian hessian(const Near& near, const SpaceBox& box);

    // Without the elements that hardly change in the k-th box of the last call of tighten(), which
    // was given this `near`.
    Near nearer(const Near& near, int k) const;

private:
    // A program with its outputs over many points.
    struct Runner {
        formula::Program program;
        formula::Evaluator<formula::Interval> evaluator;
        std::vector<std::vector<formula::Interval>> outputs;

        explicit Runner(formula::Program of)
            : program(std::move(of))
            , evaluator(program)
            , outputs(program.outputs.size()) {}
        void run(const formula::Bindings<formula::Interval>& bindings,
                 std::span<const std::vector<formula::Interval>> inputs);
    };
    // By order: value; and gradient; and the six second derivatives. Inputs x y z and, of a term,
    // its element's fields; of the whole, each sum with all its derivatives.
    using ByOrder = std::array<std::unique_ptr<Runner>, 3>;
    struct Sum {
        int array;
        std::vector<int> fields;
        ByOrder term;
    };
    static ByOrder by_order(formula::Graph& graph, formula::NodeId root, bool inputs_move);

    // Of a box of the last run of order 2: no kink.
    bool is_smooth_in(std::size_t box) const;
    // G and its derivatives over the boxes are then in the outputs of `whole_`.
    void run(const Near& near, std::span<const SpaceBox> boxes, int order);
    formula::Interval of_solid(formula::Interval f) const {
        return solid_ == Side::negative ? f : -f;
    }

    formula::Bindings<formula::Interval> bindings_;
    Side solid_;
    std::vector<Sum> sums_;
    ByOrder whole_;
    bool is_bent_ = true; // second derivatives are enclosed where no kink is
    std::vector<std::vector<formula::Interval>> inputs_, term_inputs_;
};

} // namespace isomotion::topology
