#include "render/march_plan.h"

#include <stdexcept>

#include <fmt/format.h>
#include <glm/glm.hpp>
#include <gtest/gtest.h>

namespace isomotion::render {
namespace {

TEST(MarchPlan, EveryPassStaysBelowTheLoopLimitAndTheWorkOfADraw) {
    for (const double operations : {1.0, 100.0, 1e4, 1e6, operations_at_a_point}) {
        for (const double iterations : {0.0, 1.0, 75.0, 5000.0, 59'999.0}) {
            for (const int size : {1, 63, 512, 16'384}) {
                const MarchPlan plan = plan_march({operations, iterations}, size, size, 2048);
                EXPECT_GE(plan.evaluations_per_pass, 1);
                EXPECT_LE(plan.evaluations_per_pass * (1 + iterations), 65'535);
                EXPECT_LE(plan.tile_width, size);
                EXPECT_LE(plan.tile_width, 2048);
                const double work = double(plan.tile_width) * plan.tile_height *
                                    plan.evaluations_per_pass * operations;
                if (plan.evaluations_per_pass > 1) {
                    EXPECT_LE(work, operations_per_draw);
                }
            }
        }
    }
}

// A picture is divided into fewer draws where a draw may take more; llvmpipe's limit on loops
// stays.
TEST(MarchPlan, FasterHardwareTakesFewerDraws) {
    EXPECT_EQ(operations_per_draw_at(0), operations_per_draw);    // software
    EXPECT_EQ(operations_per_draw_at(1e11), operations_per_draw); // slower than is planned for
    EXPECT_EQ(operations_per_draw_at(2e12), 5e10);
    EXPECT_EQ(operations_per_draw_at(1e15), operations_per_draw_at(1e14));
    const formula::Cost cost{100, 0};
    MarchPlan slower = plan_march(cost, 2048, 2048, 2048);
    for (const double speed : {1e12, 1e13, 1e14}) {
        const MarchPlan plan =
            plan_march(cost, 2048, 2048, 2048, {.operations = operations_per_draw_at(speed)});
        const auto of_a_draw = [](const MarchPlan& p) {
            return double(p.tile_width) * p.tile_height * p.evaluations_per_pass;
        };
        EXPECT_GT(of_a_draw(plan), of_a_draw(slower)) << speed;
        EXPECT_LE(of_a_draw(plan) * 100, operations_per_draw_at(speed));
        EXPECT_LE(plan.evaluations_per_pass, 65'535);
        slower = plan;
    }
}

// A thread of a software renderer draws squares of 64x64 pixels: one square keeps the others idle.
TEST(MarchPlan, TilesHaveSquaresForAllThreads) {
    for (const double operations : {10.0, 1e3, 5e3, 1e5, operations_at_a_point}) {
        for (const glm::ivec2 size : {glm::ivec2(2048), glm::ivec2(2048, 64)}) {
            const MarchPlan alone = plan_march({operations, 75}, size.x, size.y, 2048);
            for (const int threads : {2, 4, 16, 32}) {
                SCOPED_TRACE(fmt::format("{} operations, {} threads", operations, threads));
                const MarchPlan plan =
                    plan_march({operations, 75}, size.x, size.y, 2048, {.threads = threads});
                EXPECT_EQ(plan.evaluations_per_pass, alone.evaluations_per_pass);
                const auto work = [&](const MarchPlan& p) {
                    return double(p.tile_width) * p.tile_height * p.evaluations_per_pass *
                           operations;
                };
                EXPECT_LE(work(plan), std::max(8 * threads * operations_per_draw, work(alone)));
                if (operations <= 5e3) {
                    EXPECT_EQ(plan.tile_width, std::max(alone.tile_width, 512));
                }
            }
        }
    }
}

TEST(MarchPlan, RefusesASumThatNoPassCanHold) {
    EXPECT_THROW(plan_march({1e6, 60'001}, 64, 64, 2048), std::length_error);
}

// One draw of the smallest tile would last for minutes.
TEST(MarchPlan, RefusesAFormulaThatNoDrawCanHold) {
    EXPECT_THROW(plan_march({1.01 * operations_at_a_point, 100}, 64, 64, 2048), std::length_error);
    EXPECT_THROW(expect_drawable(1e300), std::length_error);
    EXPECT_NO_THROW(expect_drawable(operations_at_a_point));
}

} // namespace
} // namespace isomotion::render
