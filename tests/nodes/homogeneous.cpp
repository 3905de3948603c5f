#include "nodes/homogeneous.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace isomotion {

Homogeneous homogenise(const SecondOrder& f, const glm::dvec3& x, int degree) {
    const double d = degree, w = 1 / std::sqrt(1 + glm::dot(x, x));
    const glm::dvec3 hx = f.hessian * x;
    const double gx = glm::dot(f.gradient, x);
    const glm::dvec3 mixed = (d - 1) * f.gradient - hx;

    Homogeneous result;
    result.gradient = std::pow(w, d - 1) * glm::dvec4(f.gradient, d * f.value - gx);
    for (int k = 0; k < 3; ++k) result.hessian[k] = glm::dvec4(f.hessian[k], mixed[k]);
    result.hessian[3] =
        glm::dvec4(mixed, d * (d - 1) * f.value - 2 * (d - 1) * gx + glm::dot(x, hx));
    result.hessian *= std::pow(w, d - 2);
    return result;
}

int degree_of(SecondOrderField& field) {
    const glm::dvec3 far = 1e6 * glm::dvec3(0.6, 0.47, -0.65); // on no symmetry plane
    const std::array<glm::dvec3, 2> points{far, 2.0 * far};
    std::array<SecondOrder, 2> f;
    field.at(points, f);
    const double degree = std::log2(std::abs(f[1].value / f[0].value));
    if (!(std::abs(degree - std::round(degree)) < 1e-3)) {
        throw std::invalid_argument("not a polynomial: it grows like degree " +
                                    std::to_string(degree));
    }
    return int(std::lround(degree));
}

glm::dmat3x4 tangent_basis(const glm::dvec4& p) {
    // The reflection that takes p to an axis takes the other three axes to its tangents.
    glm::dvec4 mirror = p;
    mirror.w += p.w < 0 ? -1 : 1;
    mirror = glm::normalize(mirror);
    glm::dmat3x4 basis;
    for (int k = 0; k < 3; ++k) {
        basis[k] = -2 * mirror[k] * mirror;
        basis[k][k] += 1;
    }
    return basis;
}

glm::dvec3 eigenvalues(glm::dmat3 a) {
    for (int sweep = 0; sweep < 10; ++sweep) { // Jacobi's rotations; converge quadratically
        for (const auto& [p, q] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
            if (a[p][q] == 0) continue;
            const double angle = 0.5 * std::atan2(2 * a[p][q], a[q][q] - a[p][p]);
            glm::dmat3 rotation(1);
            rotation[p][p] = rotation[q][q] = std::cos(angle);
            rotation[q][p] = std::sin(angle);
            rotation[p][q] = -std::sin(angle);
            a = glm::transpose(rotation) * a * rotation;
        }
    }
    std::array<double, 3> values{a[0][0], a[1][1], a[2][2]};
    std::sort(values.begin(), values.end());
    return {values[0], values[1], values[2]};
}

} // namespace isomotion
