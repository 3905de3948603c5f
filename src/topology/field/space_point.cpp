#include "topology/field/space_point.h"

namespace isomotion::topology {
namespace {

// Twelve times the unit roundoff: what is rotated below this part of the matrix is 0 already.
constexpr double rotated_away = 0x1p-49;

struct Invariants {
    double trace, minors, determinant;
};

Invariants invariants(const SpaceMatrix& a) {
    const auto minor = [&](std::size_t i, std::size_t j) {
        return a[i][i] * a[j][j] - a[i][j] * a[j][i];
    };
    const double determinant = a[0][0] * minor(1, 2) -
                               a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
                               a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
    return {a[0][0] + a[1][1] + a[2][2], minor(0, 1) + minor(0, 2) + minor(1, 2), determinant};
}

} // namespace

// Counts signs by Descartes' rule, which is exact for the characteristic polynomial: all its roots
// are real.
Inertia inertia(const SpaceMatrix& a) {
    const auto [trace, minors, determinant] = invariants(a);
    const auto changes = [](const std::array<double, 4>& coefficients) {
        int count = 0;
        double last = 0;
        for (const double c : coefficients) {
            if (c == 0) continue;
            count += last * c < 0;
            last = c;
        }
        return count;
    };
    return {changes({1, -trace, minors, -determinant}),
            changes({-1, -trace, -minors, -determinant})};
}

std::optional<SpacePoint> solve(const SpaceMatrix& a, const SpacePoint& b) {
    const double determinant = invariants(a).determinant;
    SpacePoint x;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        x[i] = 0;
        for (std::size_t row = 0; row < 3; ++row) {
            const std::size_t next = (row + 1) % 3, last = (row + 2) % 3;
            x[i] += (a[next][j] * a[last][k] - a[next][k] * a[last][j]) * b[row];
        }
        x[i] /= determinant;
        if (!std::isfinite(x[i])) return std::nullopt;
    }
    return x;
}

namespace {

// Makes a diagonal by Jacobi's rotations, which `columns` add up.
void rotate_to_diagonal(SpaceMatrix& a, SpaceMatrix& columns, const std::array<bool, 3>& free) {
    double size = 0;
    for (const auto& row : a) size = std::max(size, length(row));
    for (int sweep = 0; sweep < 30; ++sweep) {
        bool is_diagonal = true;
        for (std::size_t p = 0; p < 3; ++p) {
            for (std::size_t q = p + 1; q < 3; ++q) {
                if (!free[p] || !free[q] || std::abs(a[p][q]) <= rotated_away * size) continue;
                is_diagonal = false;
                const double angle = 0.5 * std::atan2(2 * a[p][q], a[q][q] - a[p][p]);
                const double c = std::cos(angle), s = std::sin(angle);
                const auto rotate = [&](double& x, double& y) {
                    const double turned = c * x - s * y;
                    y = s * x + c * y;
                    x = turned;
                };
                for (std::size_t k = 0; k < 3; ++k) rotate(a[k][p], a[k][q]);
                for (std::size_t k = 0; k < 3; ++k) rotate(a[p][k], a[q][k]);
                for (std::size_t k = 0; k < 3; ++k) rotate(columns[k][p], columns[k][q]);
            }
        }
        if (is_diagonal) break;
    }
}

} // namespace

SpacePoint least_direction(SpaceMatrix a, const std::array<bool, 3>& free) {
    SpaceMatrix columns{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    rotate_to_diagonal(a, columns, free);
    std::optional<std::size_t> least;
    for (std::size_t k = 0; k < 3; ++k) {
        if (free[k] && (!least || a[k][k] < a[*least][*least])) least = k;
    }
    SpacePoint direction{};
    if (!least) return direction;
    for (std::size_t k = 0; k < 3; ++k) direction[k] = columns[k][*least];
    return direction;
}

} // namespace isomotion::topology
