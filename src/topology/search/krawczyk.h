// Krawczyk's operator (Krawczyk 1969; Moore 1977), which locates the roots of a system of equations
// in a box.
//
// K(X) = m - Y f(m) + (I - Y S)(X - m), with S the slopes of f over X, m a point of X and Y any
// matrix, ideally the inverse of the middle of S. All roots in X lie in K(X). If K(X) is inside X,
// X holds exactly one root, and Y and every matrix in S are regular.
#pragma once

#include <array>
#include <optional>

#include "topology/field/moving_field.h"

namespace isomotion::topology {

using Matrix = std::array<std::array<double, most_variables>, most_variables>;
using IntervalMatrix = std::array<std::array<formula::Interval, most_variables>, most_variables>;

// An approximate inverse of the first n rows and columns. Empty if they are nearly singular.
std::optional<Matrix> inverse(const Matrix& matrix, int n);
// The inverse of the entries' middles, for use as Y. Empty also if an entry is unbounded.
std::optional<Matrix> middle_inverse(const IntervalMatrix& slopes, int n);

struct Krawczyk {
    Box image;
    bool is_inside = false; // the image is inside the box: one root
    bool is_empty = false;  // the image doesn't meet the box: no root
    // A bound on the factor by which I - Y S stretches boxes shaped like X. Below 1: at most one
    // root in X.
    double contraction = 0;
};

// The image in doubles, with I - Y S taken for 0 where S is the middle of the slopes: it tells for
// a third of the cost whether the enclosure is worth computing, and proves nothing.
struct ImageEstimate {
    Point shift{}; // of its middle
    Point reach{}; // to both sides
};
ImageEstimate estimate(const Box& x, const Box& at_middle, const IntervalMatrix& slopes,
                       const Matrix& y, int n);

Krawczyk krawczyk(const Box& x, const Point& middle, const Box& at_middle,
                  const IntervalMatrix& slopes, const Matrix& y, int n);

} // namespace isomotion::topology
