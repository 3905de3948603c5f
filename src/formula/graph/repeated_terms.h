// Sums of many terms that differ in their numbers alone, as sums over elements that hold these.
//
// Programs write formulas of thousands of terms: exp(-(x - 0.12)^2 - (y + 0.3)^2) + ... A driver
// would compile each of them. A sum over an array is compiled once, and its elements are found by
// place. The least or the greatest of many terms are made so, too.
#pragma once

#include <vector>

#include "formula/graph/graph.h"

namespace isomotion::formula {

// For each field of an array, the number of each of its elements.
using ElementNumbers = std::vector<std::vector<double>>;

struct RepeatedTerms {
    NodeId root = 0; // the root itself where nothing is repeated
    std::vector<ElementNumbers> arrays{};
};

// Array k of the result is array `first_array` + k of the graph. Fewer terms than sixteen,
// or than four with noise, stay as they are written. Values are the same, but for rounding. Sums of
// exponentials and powers below a logarithm or a power stay, too: log_sums.h and power_sums.h keep
// them within the range of floats.
RepeatedTerms repeated_terms(Graph& graph, NodeId root, int first_array);

} // namespace isomotion::formula
