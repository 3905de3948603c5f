// When the next picture is asked for: the clock is the test's, the pictures come from a real
// thread.
#include "player/draw/frame_scheduler.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "gpu/context.h"
#include "player/model/orbit.h"
#include "scene/reading/load.h"

namespace isomotion::player {
namespace {

class FrameSchedulers : public testing::Test {
protected:
    void SetUp() override {
        try {
            context_ = gpu::Context::create(gpu::Backend::egl);
        } catch (const gpu::Unavailable& error) {
            GTEST_SKIP() << error.what();
        }
        context_->release();
        thread.emplace(*context_, [] {});
        scheduler.emplace(*thread);
    }

    void turn() {
        Look look = session.look();
        look.camera = orbited(session.at(1).camera, {0.1, 0});
        session.set(look);
    }
    void ask(double now, bool hand_rests) { scheduler->ask(session, 1, {64, 48}, now, hand_rests); }

    // The picture of the last request; the one that compiles takes its time.
    Shown come() {
        for (;;) {
            if (auto failure = thread->take_failure()) throw std::runtime_error(failure->text);
            if (auto shown = thread->take_shown()) {
                if (shown->number == scheduler->number()) return *shown;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
    }

    // As if it had taken so many seconds: the machine's own are nobody's to promise.
    Shown come_after(double seconds) {
        Shown shown = come();
        while (shown.samples < shown.asked) shown = come();
        shown.compiled = false;
        shown.took = std::chrono::duration<double>(seconds);
        return shown;
    }

    Session session{scene::load("torus", {"look=none"})};
    std::unique_ptr<gpu::Context> context_;
    std::optional<DrawThread> thread;
    std::optional<FrameScheduler> scheduler;
};

TEST_F(FrameSchedulers, WhatAHandMovesWaitsForThePictureOnItsWay) {
    ask(0, false);
    ASSERT_EQ(scheduler->number(), 1u);
    const Shown first = come();
    turn();
    ask(0.01, false);
    EXPECT_EQ(scheduler->number(), 1u) << "nobody has been told of the first picture";
    turn();
    ask(0.02, false);
    EXPECT_EQ(scheduler->number(), 1u);
    EXPECT_TRUE(scheduler->awaits());
    scheduler->learn(first, 0.005, 0.03);
    ask(0.03, false);
    EXPECT_EQ(scheduler->number(), 2u) << "both turns in one";
    ask(0.04, false);
    EXPECT_EQ(scheduler->number(), 2u);
    const Shown second = come();
    EXPECT_LT(second.asked_at, std::chrono::steady_clock::now());
    EXPECT_GT(second.asked_at, first.asked_at);
}

TEST_F(FrameSchedulers, APictureThatTakesLongIsNotWaitedFor) {
    ask(0, false);
    turn();
    ask(0.01, false);
    ASSERT_EQ(scheduler->number(), 1u);
    ASSERT_TRUE(scheduler->next_change()) << "nothing else might wake the window";
    const double later = *scheduler->next_change();
    EXPECT_GT(later, 0.01);
    EXPECT_LT(later, 1);
    ask(later, false);
    EXPECT_EQ(scheduler->number(), 2u);
}

TEST_F(FrameSchedulers, WhatPlaysWaitsForThePictureOnItsWay) {
    ask(0, true);
    turn();
    ask(0.01, true);
    EXPECT_EQ(scheduler->number(), 1u);
    scheduler->learn(come_after(0.001), 0, 0.02);
    ask(0.02, true);
    EXPECT_EQ(scheduler->number(), 2u);
}

TEST_F(FrameSchedulers, AHandThatRestsHasTheLastChangeAskedForAndThenTheWholePicture) {
    ask(0, false);
    turn();
    ask(0.01, false);
    scheduler->learn(come_after(0.001), 0, 0.02);
    ask(0.02, true);
    ASSERT_EQ(scheduler->number(), 2u);
    scheduler->learn(come_after(0.001), 0, 0.5);
    ASSERT_TRUE(scheduler->next_change());
    ask(*scheduler->next_change(), true);
    EXPECT_EQ(scheduler->number(), 3u);
    const Shown whole = come_after(0.001);
    scheduler->learn(whole, 0, 1);
    EXPECT_EQ(whole.scale, 1);
    EXPECT_TRUE(scheduler->at_rest());
    EXPECT_FALSE(scheduler->next_change()) << "what rests is not woken";
}

// Told that the machine is slow, as if each picture took so many seconds for its part of the whole.
TEST_F(FrameSchedulers, WhatTakesLongGrowsAtRest) {
    double now = 0;
    std::vector<double> scales;
    for (int k = 0; k < 12 && !scheduler->at_rest(); ++k) {
        ask(now, true);
        Shown shown = come_after(0);
        scales.push_back(shown.scale);
        shown.took = std::chrono::duration<double>(2 * shown.scale * shown.scale);
        scheduler->learn(shown, 0, now);
        if (k == 0) turn(); // the first picture told what one costs
        now += 1;
    }
    ASSERT_TRUE(scheduler->at_rest());
    ASSERT_GE(scales.size(), 4u);
    EXPECT_LT(scales[1], 0.2) << "30 a second";
    for (std::size_t k = 2; k < scales.size(); ++k)
        EXPECT_EQ(scales[k], std::min(1.0, 2 * scales[k - 1]));
    EXPECT_EQ(scales.back(), 1);
}

// A dear scene shows its first picture soon, and one at rest is whole next.
TEST_F(FrameSchedulers, EachSceneBeginsWithASmallPicture) {
    for (int scene = 0; scene < 2; ++scene) {
        const double now = 10 * scene;
        ask(now, true);
        const Shown first = come_after(0.001);
        EXPECT_LE(first.scale * first.scale, 0.125 + 1e-12);
        scheduler->learn(first, 0, now);
        ask(now + 1, true);
        EXPECT_EQ(come().scale, 1);
        scheduler->begin_scene();
    }
}

TEST_F(FrameSchedulers, AWholePictureOnItsWayIsNotWaitedForByAHand) {
    ask(0, true);
    scheduler->learn(come_after(0.001), 0, 0.5);
    ask(1, true);
    ASSERT_EQ(scheduler->number(), 2u) << "whole";
    turn();
    ask(1.01, false);
    EXPECT_EQ(scheduler->number(), 3u);
}

TEST(FittedSize, IsTheLargestOfItsAspectThatFits) {
    EXPECT_EQ(fitted_size({800, 600}, 1), glm::ivec2(600, 600));
    EXPECT_EQ(fitted_size({600, 800}, 1), glm::ivec2(600, 600));
    EXPECT_EQ(fitted_size({1000, 1000}, 2), glm::ivec2(1000, 500));
    EXPECT_EQ(fitted_size({1000, 1000}, 0.5), glm::ivec2(500, 1000));
    EXPECT_EQ(fitted_size({0, 0}, 1), glm::ivec2(1, 1));
    EXPECT_EQ(fitted_size({-40, 300}, 1), glm::ivec2(1, 1));
}

} // namespace
} // namespace isomotion::player
