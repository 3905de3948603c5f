#include "render/march_plan.h"

#include <stdexcept>

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
