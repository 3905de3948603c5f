// A field with its first and second derivatives in n unknowns, for every number type: as nodes of a
// graph, and as outputs of a program.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "formula/graph/graph.h"
#include "formula/interval/interval.h"

namespace isomotion::topology {

// Three coordinates, a multiplier for each where the field has a kink (kinks.h), and the clock.
inline constexpr std::size_t most_variables = 7;

using Box = std::array<formula::Interval, most_variables>; // those beyond the variables stay 0
using Point = std::array<double, most_variables>;

inline Box at_point(const Point& p) {
    Box box;
    for (std::size_t k = 0; k < most_variables; ++k) box[k] = p[k];
    return box;
}

// Enclosures of F and its derivatives over a box, or their values at a point.
template<class T> struct Jet {
    T value{};
    std::array<T, most_variables> gradient{};
    // Rows are those of the coordinates. The clock's row stays 0; no code needs it.
    std::array<std::array<T, most_variables>, most_variables> hessian{};
};

// F, its derivatives by the unknowns (inputs of the graph), then its second derivatives: rows for
// the first `rows` unknowns, each from the diagonal on.
//
// Over boxes these are all difference quotients between two points. They are the entire line where
// F may jump or have no value. Second derivatives are the entire line where there may be a kink.
std::vector<formula::NodeId> jet_over_boxes(formula::Graph& graph, formula::NodeId field,
                                            std::span<const std::size_t> unknowns,
                                            std::size_t rows);
// For numbers: one derivative at each point.
std::vector<formula::NodeId> jet_at_points(formula::Graph& graph, formula::NodeId field,
                                           std::span<const std::size_t> unknowns, std::size_t rows);

// `output` returns the value of each of those nodes.
template<class T, class Output>
void unpack(Jet<T>& jet, std::size_t n, std::size_t rows, Output&& output) {
    jet.value = output(0);
    for (std::size_t k = 0; k < n; ++k) jet.gradient[k] = output(1 + k);
    std::size_t at = 1 + n;
    for (std::size_t i = 0; i < rows; ++i) {
        for (std::size_t j = i; j < n; ++j, ++at) {
            jet.hessian[i][j] = output(at);
            if (j < rows) jet.hessian[j][i] = jet.hessian[i][j];
        }
    }
}

} // namespace isomotion::topology
