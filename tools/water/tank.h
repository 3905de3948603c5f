#pragma once

#include <optional>
#include <vector>

#include "vec3.h"

namespace water {

struct Box {
    Vec3 low, high;
};

/// A plane wall; the water is where the distance is positive.
struct Wall {
    Vec3 normal;
    float offset;

    float distance(Vec3 p) const { return dot(normal, p) - offset; }
    Vec3 mirrored(Vec3 p) const { return p - 2 * distance(p) * normal; }
};

/// What holds the water: a box or an upright cylinder, open above, perhaps with a post in it.
struct Tank {
    Box inside; // its height is that of the walls
    bool round = false;
    std::optional<Box> post;

    /// How far a point is in the wall, the floor or the post; negative where water may be.
    float depth_in_wall(Vec3 p) const;

    /// The walls nearer than `reach` to a point of the water. A curved wall is its tangent plane,
    /// and a post's face ends at its edges.
    std::vector<Wall> walls_near(Vec3 p, float reach) const;

    /// Where there is a lattice of this spacing, with cells whose corner is that of the tank: the
    /// points of the wall less deep than `thickness`.
    std::vector<Vec3> wall_points(float spacing, float thickness) const;
};

} // namespace water
