// Expressions of coordinates that are counted from another point than the origin.
#pragma once

#include <array>
#include <vector>

#include "formula/graph/graph.h"

namespace isomotion::formula {

// A parameter or a field of elements that is far from 0, and the field that has it counted from
// `from`. That of a parameter is of an array of one element.
struct FarNumber {
    bool is_parameter = false;
    int index = 0, field = 0; // of the parameter; of the array, and the field in it
    double from = 0;
    int near_array = 0, near_field = 0;
};

// Where coordinates are counted from, in those that a formula is written in.
struct Origin {
    std::array<double, 3> point{};
    std::vector<FarNumber> numbers{};
};

// What `root` says of p + origin, as an expression of p. Constants are gathered, so that
// (x - 500000)^2 from 500000 on is x^2: sums add them up, products and quotients by a number pass
// them on, and whole turns of sin, cos and tan and whole steps of floor are left out. Constants are
// kept to 106 bits, in two numbers where one is too short.
NodeId recentred(Graph& graph, NodeId root, const Origin& origin);

} // namespace isomotion::formula
