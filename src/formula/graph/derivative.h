// Forward-mode differentiation, from graph to graph.
//
// The derivative is an expression of the same graph. So it shares every subexpression with the
// value, can be differentiated again (Hessian), and runs on every back end that runs the value.
#pragma once

#include <functional>

#include "formula/graph/graph.h"

namespace isomotion::formula {

// The derivative of a leaf (input, parameter or element): another node, or constant 0.
using LeafDerivative = std::function<NodeId(Graph&, NodeId leaf)>;

// The slope at a kink, a jump or the end of a domain.
enum class Slopes {
    // One number per point, for evaluation in numbers. abs and sqrt(0) have slope 0 for a constant
    // argument, min and max have the slope of the side that they return, sign, floor and random
    // have slope 0.
    pointwise,
    // The same for an expression that is a derivative already. There a constant argument turns the
    // slopes of sqrt, asin and acos at their ends into 0/0. With this choice 1/b keeps slope 0
    // where b = 0 is constant.
    pointwise_again,
    // For intervals: over a box, all difference quotients between its points, also across kinks.
    // The slope is 0 where sqrt, asin and acos hold their argument constant. It is the entire line
    // wherever there may be a jump, a pole or a value that is cut off. So a slope that is not the
    // entire line proves that the function is continuous over the box. With gaps() (continuity.h)
    // added it also proves that the function has a value everywhere in the box, as the decoration
    // "dac" of IEEE 1788 does. Sums, products and the chain rule propagate this by themselves: the
    // entire line times anything but 0 is the entire line, and a constant argument does not jump.
    // One end is infinite where a root's tangent is vertical.
    generalized,
};

// The derivative of root, with the leaves' derivatives given by `leaf`.
NodeId differentiate(Graph& graph, NodeId root, const LeafDerivative& leaf,
                     Slopes slopes = Slopes::pointwise);

// Input k has derivative `directions[k]`; parameters and elements are constant.
NodeId differentiate_inputs(Graph& graph, NodeId root, const std::vector<NodeId>& directions,
                            Slopes slopes = Slopes::pointwise);

} // namespace isomotion::formula
