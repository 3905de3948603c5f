#include "topology/search/krawczyk.h"

#include <cmath>
#include <utility>

namespace isomotion::topology {

using formula::Interval;

std::optional<Matrix> inverse(const Matrix& matrix, int n) {
    const auto size = std::size_t(n);
    Matrix a = matrix, b{};
    for (std::size_t k = 0; k < size; ++k) b[k][k] = 1;
    for (std::size_t column = 0; column < size; ++column) {
        // Pivots by their part of the row: rows are in units of their own.
        std::size_t pivot = column;
        double best = 0;
        for (std::size_t row = column; row < size; ++row) {
            double scale = 0;
            for (std::size_t k = 0; k < size; ++k) scale += std::abs(matrix[row][k]);
            const double part = scale > 0 ? std::abs(a[row][column]) / scale : 0;
            if (part > best) {
                best = part;
                pivot = row;
            }
        }
        if (!(best > 1e-300) || !std::isfinite(best)) return std::nullopt;
        std::swap(a[pivot], a[column]);
        std::swap(b[pivot], b[column]);
        const double factor = 1 / a[column][column];
        for (std::size_t k = 0; k < size; ++k) {
            a[column][k] *= factor;
            b[column][k] *= factor;
        }
        for (std::size_t row = 0; row < size; ++row) {
            const double times = a[row][column];
            if (row == column || times == 0) continue;
            for (std::size_t k = 0; k < size; ++k) {
                a[row][k] -= times * a[column][k];
                b[row][k] -= times * b[column][k];
            }
        }
    }
    for (const auto& row : b) {
        for (const double entry : row) {
            if (!std::isfinite(entry)) return std::nullopt;
        }
    }
    return b;
}

std::optional<Matrix> middle_inverse(const IntervalMatrix& slopes, int n) {
    const auto size = std::size_t(n);
    Matrix middle{};
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t j = 0; j < size; ++j) {
            if (std::isinf(magnitude(slopes[i][j]))) return std::nullopt;
            middle[i][j] = mid(slopes[i][j]);
        }
    }
    return inverse(middle, n);
}

ImageEstimate estimate(const Box& x, const Box& at_middle, const IntervalMatrix& slopes,
                       const Matrix& y, int n) {
    const auto size = std::size_t(n);
    const auto half_width = [](const Interval& a) { return (a.hi - a.lo) / 2; };
    Point value{}, blur{};
    for (std::size_t l = 0; l < size; ++l) {
        value[l] = mid(at_middle[l]);
        blur[l] = half_width(at_middle[l]);
        for (std::size_t j = 0; j < size; ++j)
            blur[l] += half_width(slopes[l][j]) * half_width(x[j]);
    }
    ImageEstimate image;
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t l = 0; l < size; ++l) {
            image.shift[i] -= y[i][l] * value[l];
            image.reach[i] += std::abs(y[i][l]) * blur[l];
        }
    }
    return image;
}

Krawczyk krawczyk(const Box& x, const Point& middle, const Box& at_middle,
                  const IntervalMatrix& slopes, const Matrix& y, int n) {
    const auto size = std::size_t(n);
    Krawczyk k;
    k.is_inside = true;
    Box reach{};
    for (std::size_t j = 0; j < size; ++j) reach[j] = x[j] - Interval(middle[j]);
    for (std::size_t i = 0; i < size; ++i) {
        Interval image(middle[i]);
        double stretch = 0;
        for (std::size_t l = 0; l < size; ++l) {
            if (y[i][l] != 0) image = image - Interval(y[i][l]) * at_middle[l];
        }
        for (std::size_t j = 0; j < size; ++j) {
            Interval entry(i == j ? 1.0 : 0.0);
            for (std::size_t l = 0; l < size; ++l) {
                if (y[i][l] != 0) entry = entry - Interval(y[i][l]) * slopes[l][j];
            }
            image = image + entry * reach[j];
            stretch += magnitude(entry) * magnitude(reach[j]);
        }
        k.image[i] = image;
        k.is_inside &= x[i].lo < image.lo && image.hi < x[i].hi;
        k.is_empty |= image.hi < x[i].lo || x[i].hi < image.lo;
        const double size_i = magnitude(reach[i]);
        const double contraction = size_i > 0 ? stretch / size_i : stretch > 0 ? HUGE_VAL : 0;
        if (!(contraction <= k.contraction)) k.contraction = contraction;
    }
    return k;
}

} // namespace isomotion::topology
