// The window's pictures on simulated machines.
#include "player/draw/resolution_controller.h"

#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "unit/formula/testing.h"

namespace isomotion::player {
namespace {

using formula::Random;

constexpr double budget = 1000.0 / 30;

// Milliseconds of a draw by its scale.
using Machine = std::function<double(double scale)>;

Machine machine(double fixed, double filled) {
    return [=](double scale) { return fixed + filled * scale * scale; };
}

struct Simulation {
    ResolutionController controller;
    std::vector<int> rungs;    // of each draw
    std::vector<double> times; // of each draw
    double now = 0;            // seconds
    double idle_until = 0;     // milliseconds from one draw to the next, at least

    void draw(const Machine& machine, int draws) {
        for (int k = 0; k < draws; ++k) {
            rungs.push_back(controller.rung);
            times.push_back(machine(controller.scale()));
            now += std::max(times.back(), idle_until) / 1000;
            controller = adjusted(controller, {controller.scale(), times.back(), now}, 30);
        }
    }
    // How often the scale changed in the last so many draws.
    int changes(int last) const {
        int count = 0;
        for (std::size_t k = rungs.size() - std::size_t(last); k < rungs.size(); ++k) {
            count += rungs[k] != rungs[k - 1];
        }
        return count;
    }
};

const std::vector<double> fixed_costs{0, 0.5, 3, 10, 20, 25},
    filled_costs{0.1, 5, 25, 40, 90, 300, 900, 1500, 7000};

TEST(ResolutionController, ScalesHalveTheirPixelsEverySecondRung) {
    EXPECT_EQ(scale_of(0), 1);
    EXPECT_EQ(scale_of(scale_count - 1), 0.0625);
    for (int k = 0; k + 2 < scale_count; ++k) {
        EXPECT_NEAR(scale_of(k) * scale_of(k), 2 * scale_of(k + 2) * scale_of(k + 2), 1e-15) << k;
    }
}

TEST(ResolutionController, FindsTheLargestPictureThatKeepsTheRate) {
    int small = 0;
    for (const double fixed : fixed_costs) {
        for (const double filled : filled_costs) {
            SCOPED_TRACE(fmt::format("{} + {} s^2", fixed, filled));
            const Machine cost = machine(fixed, filled);
            Simulation run;
            run.draw(cost, 8);
            const bool possible = cost(scale_of(scale_count - 1)) <= budget;
            if (!possible) {
                ++small;
                EXPECT_EQ(run.controller.rung, scale_count - 1) << "the floor";
                continue;
            }
            EXPECT_LE(cost(run.controller.scale()), budget) << "in a few draws";
            run.draw(cost, 200);
            EXPECT_LE(cost(run.controller.scale()), budget);
            // One rung larger would leave no room to spare.
            if (run.controller.rung > 0) {
                EXPECT_GT(cost(scale_of(run.controller.rung - 1)), 0.8 * budget);
            }
            EXPECT_EQ(run.changes(100), 0);
        }
    }
    EXPECT_GT(small, 0);
    EXPECT_LT(small, int(fixed_costs.size() * filled_costs.size()) / 2);
}

TEST(ResolutionController, HoldsStillOnAMachineThatIsNeverTheSame) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const Machine mean = machine(random.in(0, 15), std::exp(random.in(0, 6.5)));
        const Machine noisy = [&](double scale) { return mean(scale) * random.in(0.85, 1.15); };
        Simulation run;
        run.draw(noisy, 60);
        run.draw(noisy, 300);
        EXPECT_LE(run.changes(300), 6) << "ten seconds";
        EXPECT_TRUE(mean(run.controller.scale()) <= 1.1 * budget ||
                    run.controller.rung == scale_count - 1);
    }
}

// Pictures share the time with what puts them on the screen, whose cost no size changes.
TEST(ResolutionController, LeavesTimeToPutPicturesOnTheScreen) {
    for (const double display : {0.0, 4.0, 12.0, 20.0}) {
        for (const double filled : filled_costs) {
            SCOPED_TRACE(fmt::format("{} s^2, display {}", filled, display));
            const Machine cost = machine(0, filled);
            ResolutionController controller;
            for (int k = 0; k < 200; ++k) {
                const double scale = controller.scale();
                controller = adjusted(controller, {scale, cost(scale), k / 30.0, display}, 30);
            }
            const double left = budget - display;
            EXPECT_NEAR(controller.model.at(1), filled, 1e-9 * filled) << "of drawing alone";
            if (cost(scale_of(scale_count - 1)) > left) continue;
            EXPECT_LE(cost(controller.scale()), left);
            if (controller.rung > 0) {
                EXPECT_GT(cost(scale_of(controller.rung - 1)), 0.8 * left) << "room to spare";
            }
        }
    }
}

TEST(ResolutionController, DrawsGetAQuarterOfTheTimeHoweverSlowTheScreen) {
    ResolutionController controller;
    for (int k = 0; k < 100; ++k) {
        controller = adjusted(controller, {controller.scale(), 5, k / 30.0, 1000}, 30);
    }
    EXPECT_EQ(controller.rung, 0);
}

// Two seconds apart at least, however noisy, but for draws that take half as long again.
TEST(ResolutionController, ChangesSeldomOnceItHasSettled) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const Machine mean = machine(random.in(0, 15), std::exp(random.in(0, 6.5)));
        const double noise = random.in(0, 0.25);
        const Machine noisy = [&](double scale) {
            return mean(scale) * random.in(1 - noise, 1 + noise);
        };
        Simulation run;
        run.draw(noisy, 60);
        double since = 1e9;
        for (int k = 0; k < 900; ++k) {
            const int before = run.controller.rung;
            run.draw(noisy, 1);
            since += run.times.back();
            if (run.controller.rung == before) continue;
            EXPECT_TRUE(since >= 1999 || run.times.back() >= 1.5 * budget) << k << ": " << since;
            since = 0;
        }
    }
}

// Real costs don't follow the model: tiles, caches, powers other than two.
TEST(ResolutionController, DoesNotOscillateWhereTheModelIsWrong) {
    for (const double power : {0.5, 1.0, 1.5, 3.0}) {
        for (const double full : {20.0, 40.0, 70.0, 150.0, 400.0}) {
            SCOPED_TRACE(fmt::format("{} s^{}", full, power));
            const Machine cost = [&](double s) { return full * std::pow(s, power); };
            Simulation run;
            run.draw(cost, 600);
            EXPECT_LE(run.changes(300), 2);
            int late = 0;
            for (std::size_t k = 300; k < 600; ++k) late += run.times[k] > budget;
            if (cost(scale_of(scale_count - 1)) <= budget) {
                EXPECT_LE(late, 6);
            }
        }
    }
    // A step that no model expects: above half size everything takes far longer.
    const Machine cliff = [](double s) { return s > 0.51 ? 45 : 25 * s * s; };
    Simulation run;
    run.draw(cliff, 1200);
    int late = 0;
    for (std::size_t k = 600; k < 1200; ++k) late += run.times[k] > budget;
    EXPECT_LE(late, 12) << "what has failed is tried ever more seldom";
}

TEST(ResolutionController, AnswersASceneTenTimesDearerAtItsSecondPicture) {
    for (const double filled : {2.0, 10.0, 20.0, 30.0, 100.0}) {
        SCOPED_TRACE(filled);
        Simulation run;
        run.draw(machine(1, filled), 60);
        const int before = run.controller.rung;
        const Machine dearer = machine(10, 10 * filled);
        run.draw(dearer, 2);
        if (dearer(scale_of(before)) <= budget) {
            EXPECT_EQ(run.controller.rung, before);
        } else {
            EXPECT_GT(run.controller.rung, before);
            EXPECT_LE(dearer(run.controller.scale()), 1.1 * budget) << "and far enough";
        }
        run.draw(dearer, 4);
        EXPECT_LE(dearer(run.controller.scale()), budget);
    }
}

TEST(ResolutionController, ReturnsToFullSizeWhenTheSceneIsLightAgain) {
    for (const double idle_until :
         {0.0, budget}) { // at rest between the frames of an animation, too
        SCOPED_TRACE(idle_until);
        Simulation run;
        run.draw(machine(1, 900), 60);
        EXPECT_GT(run.controller.rung, 8);
        run.idle_until = idle_until;
        run.draw(machine(1, 9), 60);
        EXPECT_EQ(run.controller.rung, 0) << "two seconds";
    }
}

TEST(ResolutionController, AHiccupChangesNothing) {
    Simulation run;
    run.draw(machine(2, 60), 100);
    const int settled = run.controller.rung;
    EXPECT_GT(settled, 0);
    for (int k = 0; k < 20; ++k) {
        run.draw(machine(300, 60), 1);
        EXPECT_EQ(run.controller.rung, settled);
        run.draw(machine(2, 60), 9);
        EXPECT_EQ(run.controller.rung, settled);
    }
    EXPECT_NEAR(run.controller.model.at(1), 62, 1e-6) << "nor what the scene is taken to cost";
}

TEST(ResolutionController, TheFirstPictureIsBelieved) {
    Simulation run;
    run.draw(machine(0, 10000), 1);
    EXPECT_EQ(run.controller.scale(), scale_of(scale_count - 1));
    run = {};
    run.draw(machine(0, 100), 1);
    EXPECT_NEAR(run.controller.scale(), 0.5, 1e-12); // 100 s^2 <= 30: s <= 0.548
}

// With a thread that draws, some pictures come late, of the size that was asked for before.
TEST(ResolutionController, PicturesBegunBeforeTheChangeDoNotCountTwice) {
    const Machine cost = machine(0, 100);
    ResolutionController controller = adjusted({}, {1, cost(1)}, 30);
    const int fallen = controller.rung;
    EXPECT_GT(fallen, 0);
    for (int k = 0; k < 3; ++k) controller = adjusted(controller, {1, cost(1)}, 30);
    EXPECT_EQ(controller.rung, fallen);
}

TEST(ResolutionController, WhatIsNoMeasurementIsLeftOut) {
    Simulation run;
    run.draw(machine(1, 60), 40);
    const ResolutionController before = run.controller;
    for (const double bad : {0.0, -1.0, double(NAN), double(INFINITY)}) {
        for (int k = 0; k < 5; ++k)
            run.controller = adjusted(run.controller, {before.scale(), bad}, 30);
        for (int k = 0; k < 5; ++k)
            run.controller = adjusted(run.controller, {bad == INFINITY ? -2 : bad, 5}, 30);
    }
    EXPECT_EQ(run.controller.rung, before.rung);
    EXPECT_EQ(run.controller.model.at(1), before.model.at(1));
    EXPECT_EQ(run.controller.draws.size(), before.draws.size());
}

TEST(CostOfDraws, IsExactWhereDrawsFollowTheModel) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const CostModel truth{random.in(0, 20), random.in(0, 500)};
        std::vector<MeasuredDraw> draws;
        for (const double scale : {1.0, 0.5, 0.5, 0.3, 0.2}) {
            draws.push_back({scale, truth.at(scale)});
        }
        const CostModel found = cost_of(draws, {});
        EXPECT_NEAR(found.fixed, truth.fixed, 1e-8);
        EXPECT_NEAR(found.filled, truth.filled, 1e-8);
    }
}

TEST(CostOfDraws, KeepsItsShapeWhereAllAreOfOneSize) {
    const CostModel found = cost_of({{0.5, 24}, {0.5, 24}}, {4, 32}); // 12 at this size
    EXPECT_NEAR(found.fixed, 8, 1e-12);
    EXPECT_NEAR(found.filled, 64, 1e-12);
    EXPECT_NEAR(cost_of({{0.5, 24}}, {}).filled, 96, 1e-12) << "else all is taken for pixels";
}

TEST(CostOfDraws, IsNeverNegative) {
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        std::vector<MeasuredDraw> draws;
        for (int k = 0; k < 8; ++k) {
            draws.push_back({scale_of(random.below(scale_count)), random.in(1, 100)});
        }
        const CostModel found = cost_of(draws, {});
        EXPECT_GE(found.fixed, 0);
        EXPECT_GE(found.filled, 0);
        EXPECT_GT(found.at(1), 0);
    }
}

} // namespace
} // namespace isomotion::player
