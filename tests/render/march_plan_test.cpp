#include "render/march_plan.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace isomotion::render {
namespace {

TEST(MarchPlan, EveryPassStaysBelowTheLoopLimitAndTheWorkOfADraw) {
    for (const double operations : {1.0, 100.0, 1e4, 1e6, 1e8}) {
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

TEST(MarchPlan, RefusesASumThatNoPassCanHold) {
    EXPECT_THROW(plan_march({1e6, 60'001}, 64, 64, 2048), std::length_error);
}

} // namespace
} // namespace isomotion::render
