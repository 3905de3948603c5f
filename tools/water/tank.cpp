#include "tank.h"

#include <algorithm>

namespace water {
namespace {

// The distance from a box's surface, positive outside; exact inside and beside faces, and along the
// edges a lower bound, which is enough here.
float outside_of(const Box& box, Vec3 p) {
    return std::max({box.low.x - p.x, p.x - box.high.x, box.low.y - p.y, p.y - box.high.y,
                     box.low.z - p.z, p.z - box.high.z});
}

// The level vector from the axis of a round tank.
Vec3 from_axis(const Box& inside, Vec3 p) {
    return {p.x - (inside.low.x + inside.high.x) / 2, p.y - (inside.low.y + inside.high.y) / 2, 0};
}

float radius_of(const Box& inside) { return (inside.high.x - inside.low.x) / 2; }

std::vector<Wall> walls_of_tank(const Tank& tank, Vec3 p) {
    const Box& in = tank.inside;
    std::vector<Wall> walls{{{0, 0, 1}, in.low.z}};
    if (tank.round) {
        const Vec3 out = from_axis(in, p);
        const float r = length(out);
        if (r > 0) {
            const Vec3 normal = (-1 / r) * out;
            walls.push_back({normal, dot(normal, p - out) - radius_of(in)});
        }
        return walls;
    }
    walls.push_back({{1, 0, 0}, in.low.x});
    walls.push_back({{-1, 0, 0}, -in.high.x});
    walls.push_back({{0, 1, 0}, in.low.y});
    walls.push_back({{0, -1, 0}, -in.high.y});
    return walls;
}

} // namespace

float Tank::depth_in_wall(Vec3 p) const {
    const float beside = round ? length(from_axis(inside, p)) - radius_of(inside)
                               : std::max({inside.low.x - p.x, p.x - inside.high.x,
                                           inside.low.y - p.y, p.y - inside.high.y});
    const float depth = std::max(beside, inside.low.z - p.z);
    return post ? std::max(depth, -outside_of(*post, p)) : depth;
}

std::vector<Wall> Tank::walls_near(Vec3 p, float reach) const {
    std::vector<Wall> walls = walls_of_tank(*this, p);
    std::erase_if(walls, [&](const Wall& wall) { return wall.distance(p) >= reach; });
    if (post && outside_of(*post, p) < reach) {
        // The face that the point is in front of; of a point in the post the nearest.
        const Wall faces[] = {{{-1, 0, 0}, -post->low.x},
                              {{1, 0, 0}, post->high.x},
                              {{0, -1, 0}, -post->low.y},
                              {{0, 1, 0}, post->high.y},
                              {{0, 0, 1}, post->high.z}};
        const Wall* face = nullptr;
        int before = 0;
        for (const Wall& f : faces) {
            before += f.distance(p) > 0;
            if (!face || f.distance(p) > face->distance(p)) face = &f;
        }
        if (before <= 1) walls.push_back(*face);
    }
    return walls;
}

std::vector<Vec3> Tank::wall_points(float spacing, float thickness) const {
    const int margin = int(thickness / spacing) + 1;
    const auto cells = [&](float low, float high) { return int((high - low) / spacing + 0.5F); };
    const int nx = cells(inside.low.x, inside.high.x), ny = cells(inside.low.y, inside.high.y),
              nz = cells(inside.low.z, inside.high.z);
    std::vector<Vec3> points;
    for (int k = -margin; k < nz; ++k) {
        for (int j = -margin; j < ny + margin; ++j) {
            for (int i = -margin; i < nx + margin; ++i) {
                const Vec3 p =
                    inside.low + spacing * Vec3{float(i) + 0.5F, float(j) + 0.5F, float(k) + 0.5F};
                const float depth = depth_in_wall(p);
                if (depth > 0 && depth < thickness) points.push_back(p);
            }
        }
    }
    return points;
}

} // namespace water
