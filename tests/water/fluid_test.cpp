#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "ply.h"
#include "situations.h"

namespace water {
namespace {

std::vector<std::byte> bytes_after(Fluid fluid, int frames) {
    for (int k = 0; k < frames; ++k) fluid.advance(1.0F / 30);
    return ply_of(blobs_of(fluid, {}));
}

TEST(Fluid, IsTheSameOnEachRunAndOfAnyNumberOfThreads) {
    const std::vector<std::byte> once = bytes_after(dam_break(2000, 1), 3);
    EXPECT_EQ(bytes_after(dam_break(2000, 1), 3), once);
    EXPECT_EQ(bytes_after(dam_break(2000, 3), 3), once);
    EXPECT_NE(bytes_after(dam_break(2000, 1), 4), once);
}

TEST(Fluid, StaysInTheTankAndOutOfThePost) {
    for (Fluid fluid : {dam_break(500, 2), ball_into_pool(1000, 2)}) {
        const float spacing = fluid.settings().spacing;
        for (int frame = 0; frame < 45; ++frame) {
            fluid.advance(1.0F / 30);
            for (const Vec3& p : fluid.positions()) {
                ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
                ASSERT_LT(fluid.tank().depth_in_wall(p), 0.01F * spacing)
                    << p.x << ' ' << p.y << ' ' << p.z << " in frame " << frame;
            }
        }
    }
}

TEST(Fluid, ComesToRestAtItsDensityAtRestAndLevel) {
    Fluid fluid = dam_break(1000, 2);
    for (int frame = 0; frame < 450; ++frame) fluid.advance(1.0F / 30);
    const auto n = double(fluid.positions().size());
    double density = 0, square_of_speed = 0, level = 0;
    for (std::size_t i = 0; i < fluid.positions().size(); ++i) {
        // Those at the surface miss a part of their neighbours.
        density = std::max(density, double(fluid.densities()[i]));
        square_of_speed += double(dot(fluid.velocities()[i], fluid.velocities()[i])) / n;
        level += double(fluid.positions()[i].z) / n;
    }
    EXPECT_NEAR(density, 1, 0.1);
    EXPECT_LT(std::sqrt(square_of_speed), 0.05);
    // The middle of the column's water spread over the floor that the post leaves.
    EXPECT_NEAR(level, 0.61 * 0.85 / (2 - 0.04) / 2, 0.02);
}

TEST(Fluid, FallsAsTheAirLetsIt) {
    for (const float air : {0.0F, 1.5F}) {
        Tank tank;
        tank.inside = {{0, 0, 0}, {1, 1, 2}};
        Settings settings;
        settings.spacing = 0.1F;
        settings.air = air;
        Fluid fluid(tank, settings, {{0.5F, 0.5F, 1.5F}}, {{0, 0, 0}});
        fluid.advance(0.5F);
        // dv/dt = air v^2 - g
        const float g = settings.gravity;
        const float speed =
            air > 0 ? std::sqrt(g / air) * std::tanh(0.5F * std::sqrt(g * air)) : 0.5F * g;
        EXPECT_NEAR(fluid.velocities()[0].z, -speed, air > 0 ? 0.02F : 1e-4F) << air;
    }
}

} // namespace
} // namespace water
