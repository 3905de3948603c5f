#include "situations.h"

#include <cmath>

namespace water {
namespace {

// Evenly spread in [0, 1), one value for each count (SplitMix64).
float random_part(std::uint64_t count) {
    std::uint64_t x = (count + 1) * 0x9E3779B97F4A7C15U;
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9U;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBU;
    return float((x ^ (x >> 31)) >> 40) * 0x1p-24F;
}

// The middles of a lattice's cells where inside() holds, shaken a little: from an exact lattice
// water would fall in rows, and a round sheet would not know where to break.
template<class Inside>
std::vector<Vec3> fill(const Box& box, float spacing, float shake, const Inside& inside) {
    const auto cells = [&](float low, float high) { return int((high - low) / spacing + 0.5F); };
    std::vector<Vec3> points;
    for (int k = 0; k < cells(box.low.z, box.high.z); ++k) {
        for (int j = 0; j < cells(box.low.y, box.high.y); ++j) {
            for (int i = 0; i < cells(box.low.x, box.high.x); ++i) {
                Vec3 p =
                    box.low + spacing * Vec3{float(i) + 0.5F, float(j) + 0.5F, float(k) + 0.5F};
                if (!inside(p)) continue;
                const std::uint64_t count = 3 * points.size();
                p += (shake * spacing) * Vec3{random_part(count) - 0.5F,
                                              random_part(count + 1) - 0.5F,
                                              random_part(count + 2) - 0.5F};
                points.push_back(p);
            }
        }
    }
    return points;
}

} // namespace

Fluid dam_break(int particles, unsigned threads) {
    // Whole numbers of cells everywhere, so that the lattice of the walls meets that of the water.
    const float n = std::round(46 * std::cbrt(float(particles) / 50000)), spacing = 1 / n;
    const auto whole = [&](float length) { return std::round(length * n) * spacing; };
    Tank tank;
    tank.inside = {{0, 0, 0}, {2, 1, whole(1.6F)}};
    tank.post = Box{{whole(1.1F), whole(0.4F), 0}, {whole(1.3F), whole(0.6F), whole(0.5F)}};
    const Box column{{0, 0, 0}, {whole(0.61F), 1, whole(0.85F)}};
    std::vector<Vec3> points = fill(column, spacing, 0.2F, [](Vec3) { return true; });
    Settings settings;
    settings.spacing = spacing;
    settings.threads = threads;
    std::vector<Vec3> still(points.size());
    Fluid fluid(tank, settings, std::move(points), std::move(still));
    fluid.settle(20);
    return fluid;
}

Fluid ball_into_pool(int particles, unsigned threads) {
    // 100,000 particles make a tank 100 spacings across, a pool 10 deep and a ball 36 thick.
    const float n = std::round(100 * std::cbrt(float(particles) / 100000)), spacing = 2 / n;
    const auto whole = [&](float length) { return std::round(length / spacing) * spacing; };
    Tank tank;
    tank.inside = {{-1, -1, 0}, {1, 1, whole(1.6F)}};
    tank.round = true;
    const float surface = whole(0.19F), radius = 0.36F;
    const Vec3 middle{0, 0, surface + radius + spacing};
    const auto in_ball = [&](Vec3 p) { return length(p - middle) < radius; };
    const auto in_pool = [&](Vec3 p) {
        return p.z < surface && tank.depth_in_wall(p) < -0.4F * spacing;
    };
    std::vector<Vec3> points =
        fill(tank.inside, spacing, 0.3F, [&](Vec3 p) { return in_ball(p) || in_pool(p); });
    std::vector<Vec3> velocities;
    for (const Vec3& p : points) velocities.push_back(p.z > surface ? Vec3{0, 0, -2.6F} : Vec3{});
    Settings settings;
    settings.spacing = spacing;
    settings.threads = threads;
    Fluid fluid(tank, settings, std::move(points), std::move(velocities));
    fluid.settle(20);
    return fluid;
}

} // namespace water
