// Takes formulas apart that are sums of functions of one input each, as T_n(x) + T_n(y) + T_n(z) +
// c.
//
// The critical points of such a sum are all combinations of those of its terms, and each term is
// examined along its own axis alone (search/separable_search.h, betti/separable_frame.h).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "formula/evaluate/evaluate.h"
#include "formula/graph/program.h"
#include "formula/interval/interval.h"

namespace isomotion::topology {

// A term for each of the first `inputs` inputs, which are all that the formula has. The last term
// also holds what depends on no input. Empty if the formula is no such sum.
std::optional<std::vector<formula::NodeId>> separated(formula::Graph& graph, formula::NodeId root,
                                                      std::size_t inputs);

// A function of one input, with its slopes over intervals (jet.h). Use one per thread.
class Term {
public:
    Term(formula::Graph graph, formula::NodeId root, std::size_t input,
         const formula::Bindings<formula::Interval>& bindings);
    Term(const Term&) = delete; // since the evaluator refers to the program
    Term& operator=(const Term&) = delete;

    struct Over {
        formula::Interval value, slope, second;
    };
    Over over(formula::Interval x);

private:
    const formula::Bindings<formula::Interval>& bindings_;
    formula::Program program_;
    formula::Evaluator<formula::Interval> evaluator_;
    std::vector<formula::Interval> inputs_;
};

// A root of a function of one unknown that has no other one in `alone`. `where` is inside it.
struct Root {
    formula::Interval where, alone;
};

// All roots in a span, in order, and maybe some just outside of it; each is simple. Empty where
// that can't be proved.
std::optional<std::vector<Root>> stationary_points(Term& term, formula::Interval span);
// Those of term + c, for each c of an interval.
std::optional<std::vector<Root>> zeros(Term& term, formula::Interval c, formula::Interval span);

} // namespace isomotion::topology
