#include "topology/search/morse.h"

#include <cmath>

namespace isomotion::topology {
namespace {

using formula::Interval;

// Columns are the eigenvectors of a symmetric matrix, by Jacobi's rotations.
Matrix eigenvectors(Matrix a, std::size_t n) {
    Matrix v{};
    for (std::size_t k = 0; k < n; ++k) v[k][k] = 1;
    for (int sweep = 0; sweep < 30; ++sweep) {
        double off = 0;
        for (std::size_t p = 0; p < n; ++p) {
            for (std::size_t q = p + 1; q < n; ++q) {
                off += std::abs(a[p][q]);
                if (a[p][q] == 0) continue;
                const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
                const double t = std::copysign(1 / (std::abs(theta) + std::hypot(theta, 1)), theta);
                const double c = 1 / std::hypot(t, 1), s = t * c;
                for (std::size_t k = 0; k < n; ++k) {
                    const double kp = a[k][p], kq = a[k][q];
                    a[k][p] = c * kp - s * kq;
                    a[k][q] = s * kp + c * kq;
                }
                for (std::size_t k = 0; k < n; ++k) {
                    const double pk = a[p][k], qk = a[q][k];
                    a[p][k] = c * pk - s * qk;
                    a[q][k] = s * pk + c * qk;
                }
                for (std::size_t k = 0; k < n; ++k) {
                    const double kp = v[k][p], kq = v[k][q];
                    v[k][p] = c * kp - s * kq;
                    v[k][q] = s * kp + c * kq;
                }
            }
        }
        if (off == 0) break;
    }
    return v;
}

} // namespace

std::optional<int> negative_eigenvalues(const IntervalMatrix& hessian, int size) {
    const auto n = std::size_t(size);
    Matrix middle{};
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            if (std::isinf(magnitude(hessian[i][j]))) return std::nullopt;
            middle[i][j] = mid(hessian[i][j]);
        }
    }
    const Matrix v = eigenvectors(middle, n);
    int negative = 0;
    for (std::size_t i = 0; i < n; ++i) {
        Interval diagonal;
        double radius = 0;
        for (std::size_t j = 0; j < n; ++j) {
            Interval entry(0.0);
            for (std::size_t k = 0; k < n; ++k) {
                Interval column(0.0);
                for (std::size_t l = 0; l < n; ++l) {
                    column = column + hessian[k][l] * Interval(v[l][j]);
                }
                entry = entry + Interval(v[k][i]) * column;
            }
            if (i == j) {
                diagonal = entry;
            } else {
                radius = formula::round_up(radius + magnitude(entry));
            }
        }
        const Interval disc = diagonal + Interval(-radius, radius);
        if (!(disc.hi < 0 || disc.lo > 0)) return std::nullopt;
        if (disc.hi < 0) ++negative;
    }
    return negative;
}

} // namespace isomotion::topology
