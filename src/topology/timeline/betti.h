// Betti numbers of the solid inside the bounds, and of its surface.
#pragma once

#include <compare>

namespace isomotion::topology {

struct Betti {
    int components = 0; // b0
    int tunnels = 0;    // b1
    int voids = 0;      // b2

    int euler() const { return components - tunnels + voids; }
    // No number is negative, and nothing has no tunnels and no voids.
    bool is_possible() const {
        return components >= 0 && tunnels >= 0 && voids >= 0 &&
               (components > 0 || (tunnels == 0 && voids == 0));
    }
    auto operator<=>(const Betti&) const = default;
};

constexpr Betti operator+(const Betti& a, const Betti& b) {
    return {a.components + b.components, a.tunnels + b.tunnels, a.voids + b.voids};
}

// The Betti numbers of the closed surface that bounds a solid. Each component of the solid and each
// void has one component of surface; each tunnel has a handle, which adds two loops.
constexpr Betti surface_of(const Betti& solid) {
    const int components = solid.components + solid.voids;
    return {components, 2 * solid.tunnels, components};
}

} // namespace isomotion::topology
