// Solids on grids, for tests.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <ostream>

#include <glm/glm.hpp>

#include "topology/betti/sign_grid.h"

namespace isomotion::topology {

inline void PrintTo(const Betti& b, std::ostream* out) {
    *out << '(' << b.components << ", " << b.tunnels << ", " << b.voids << ')';
}

// The vertices of [-1, 1]^3 where `is_solid(glm::dvec3)`.
template<class Predicate> SignGrid grid_of(int side, Predicate&& is_solid) {
    SignGrid grid(side);
    const auto at = [&](int i) { return 2.0 * i / (side - 1) - 1; };
    for (int z = 0; z < side; ++z) {
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                if (is_solid(glm::dvec3(at(x), at(y), at(z)))) grid.set(x, y, z);
            }
        }
    }
    return grid;
}

inline bool in_ball(const glm::dvec3& p, const glm::dvec3& centre, double radius) {
    return glm::distance(p, centre) < radius;
}

// About an axis along z.
inline bool in_torus(const glm::dvec3& p, const glm::dvec3& centre, double ring, double tube) {
    const glm::dvec3 d = p - centre;
    return std::hypot(std::hypot(d.x, d.y) - ring, d.z) < tube;
}

// The knot that winds q times about the z axis while it goes p times round the ring.
inline bool in_torus_knot(const glm::dvec3& at, int p, int q, double tube) {
    constexpr int pieces = 150;
    for (int k = 0; k < pieces; ++k) {
        const double t = 2 * std::numbers::pi * k / pieces;
        const double ring = 0.55 + 0.25 * std::cos(p * t);
        const glm::dvec3 on(ring * std::cos(q * t), ring * std::sin(q * t), 0.25 * std::sin(p * t));
        if (in_ball(at, on, tube)) return true;
    }
    return false;
}

} // namespace isomotion::topology
