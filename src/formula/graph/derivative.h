// Forward-mode differentiation, as a map from graph to graph.
//
// The derivative is an expression of the same graph, so it shares every subexpression with the
// value, can be differentiated again (Hessian), and runs on every back end that runs the value.
#pragma once

#include <functional>

#include "formula/graph/graph.h"

namespace isomotion::formula {

// The derivative of a leaf (input, parameter or element): another node, or constant 0.
using LeafDerivative = std::function<NodeId(Graph&, NodeId leaf)>;

// Where a function has a kink, a jump or an end.
enum class Slopes {
    // One number a point, for numbers: abs and sqrt(0) have slope 0 for a resting argument, min and
    // max take the side they return, sign, floor and random have slope 0.
    pointwise,
    // The same for what is a derivative already. There a resting argument makes 0/0 of the slopes
    // of sqrt, asin and acos at their ends: 1/b keeps slope 0 where b = 0 rests.
    pointwise_again,
    // For intervals: over a box, all difference quotients between its points, across kinks too;
    // what sqrt, asin and acos hold constant has slope 0. The entire line, and no less, where there
    // may be a jump, a pole or a value that is cut off. So a slope that is not the entire line is a
    // proof that the function is continuous over the box; with gaps() (continuity.h) added, that it
    // has a value all over it, as the decoration "dac" of IEEE 1788 is. Sums, products and the
    // chain rule carry it along by themselves: the entire line times what is not 0 is the entire
    // line, and what rests does not jump. One end is infinite where a root's tangent is vertical.
    generalized,
};

// d root, when the leaves move as `leaf` says.
NodeId differentiate(Graph& graph, NodeId root, const LeafDerivative& leaf,
                     Slopes slopes = Slopes::pointwise);

// Input k has derivative `directions[k]`; parameters and elements are constant.
NodeId differentiate_inputs(Graph& graph, NodeId root, const std::vector<NodeId>& directions,
                            Slopes slopes = Slopes::pointwise);

} // namespace isomotion::formula
