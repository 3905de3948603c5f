// Time in the window. Rates are powers of two where a moment has to be met exactly.
#include "player/model/playback.h"

#include <cmath>
#include <limits>

#include "unit/formula/testing.h"

namespace isomotion::player {
namespace {

using animation::FrameRate;
using formula::Random;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr auto most_frames = std::numeric_limits<std::int64_t>::max();

Playback playing(std::int64_t first, std::int64_t last, bool loop = false) {
    return {{32, 1}, first, last, loop, true, 0, double(first), 100};
}
double after(double frames) { return 100 + frames / 32; }
std::int64_t shown(const Playback& p, double now) { return frame_at(p, now).frame; }

TEST(Playback, BeginsPausedAtTheTimelinesFirstFrame) {
    const Playback p = playback_of({{24, 1}, 48, true});
    EXPECT_EQ(p, (Playback{{24, 1}, 1, 48, true, false, 0, 1, 0}));
    EXPECT_EQ(shown(p, 1e6), 1);
    EXPECT_FALSE(playback_of({{24, 1}, 48, false}).loop);
}

TEST(Playback, ShowsEachFrameForItsDuration) {
    const Playback p = playing(1, 1000);
    for (int k = 0; k < 999; ++k) {
        ASSERT_EQ(shown(p, after(k)), 1 + k);
        ASSERT_EQ(shown(p, std::nextafter(after(k + 1), 0)), 1 + k);
        ASSERT_EQ(frame_at(p, after(k + 0.25)).part, 0.25);
    }
}

TEST(Playback, LoopsFromTheLastFrameToTheFirst) {
    const Playback p = playing(5, 7, true);
    for (const double rounds : {0.0, 1.0, 2.0, 1000.0, 1e9}) {
        for (int k = 0; k < 3; ++k) {
            const Position there = frame_at(p, after(3 * rounds + k));
            EXPECT_EQ(there.frame, 5 + k) << rounds;
            EXPECT_EQ(there.part, 0);
            EXPECT_FALSE(there.ended);
        }
    }
    EXPECT_EQ(shown(p, std::nextafter(after(3), 0)), 7);
    EXPECT_EQ(shown(p, after(3)), 5);
}

TEST(Playback, EndsAtTheLastFrame) {
    const Playback p = playing(5, 7);
    EXPECT_FALSE(frame_at(p, std::nextafter(after(2), 0)).ended);
    EXPECT_EQ(settled(p, after(1.5)), p);
    for (const double frames : {2.0, 2.5, 3.0, 1e12}) {
        const Position there = frame_at(p, after(frames));
        EXPECT_EQ(there.frame, 7);
        EXPECT_EQ(there.part, 0);
        EXPECT_TRUE(there.ended);
        const Playback still = settled(p, after(frames));
        EXPECT_FALSE(still.playing);
        EXPECT_EQ(still.anchor, 7);
        EXPECT_FALSE(frame_at(still, after(frames)).ended) << "over and done";
    }
}

TEST(Playback, BeginsAgainAfterTheEnd) {
    const Playback p = playing(5, 7);
    for (const Playback& over : {p, settled(p, after(10)), paused(p, after(10)),
                                 scrubbed(paused(p, after(1)), 7, after(1))}) {
        for (const Playback& again : {played(over, after(20)), toggled(over, after(20))}) {
            EXPECT_TRUE(again.playing);
            EXPECT_EQ(shown(again, after(20)), 5);
            EXPECT_EQ(shown(again, after(21)), 6);
        }
    }
    // Where it loops there is no end to begin after.
    const Playback round = scrubbed(paused(playing(5, 7, true), after(0)), 7, after(0));
    EXPECT_EQ(shown(played(round, after(20)), after(20)), 7);
}

TEST(Playback, PausedWithinAFrameStepsToItsNeighbours) {
    const Playback p = paused(playing(1, 100), after(6.9));
    EXPECT_NEAR(p.anchor, 7.9, 1e-12);
    EXPECT_EQ(shown(p, after(6.9)), 7);
    EXPECT_EQ(shown(p, after(1e6)), 7);
    EXPECT_EQ(stepped(p, -1, 0).anchor, 6);
    EXPECT_EQ(stepped(p, 1, 0).anchor, 8);
    EXPECT_EQ(stepped(p, 0, 0).anchor, 7);
    EXPECT_NEAR(frame_at(played(p, 500), 500).part, 0.9, 1e-12) << "and plays on from there";
}

TEST(Playback, AStepPausesAndStopsAtTheEndsOrGoesRound) {
    const Playback straight = playing(5, 9), round = playing(5, 9, true);
    EXPECT_FALSE(stepped(straight, 1, after(0)).playing);
    EXPECT_EQ(stepped(straight, 3, after(0)).anchor, 8);
    EXPECT_EQ(stepped(straight, 5, after(0)).anchor, 9);
    EXPECT_EQ(stepped(straight, -1, after(0)).anchor, 5);
    EXPECT_EQ(stepped(round, 4, after(0)).anchor, 9);
    EXPECT_EQ(stepped(round, 5, after(0)).anchor, 5);
    EXPECT_EQ(stepped(round, -1, after(0)).anchor, 9);
    EXPECT_EQ(stepped(round, -11, after(0)).anchor, 9);
    for (const std::int64_t far : {most_frames, -most_frames - 1}) {
        EXPECT_EQ(stepped(straight, far, after(0)).anchor, far > 0 ? 9 : 5);
        const double anchor = stepped(round, far, after(0)).anchor;
        EXPECT_EQ(anchor, 5 + double((far % 5 + 5) % 5));
    }
}

TEST(Playback, ScrubsWithinItsRangeAndPlaysOn) {
    const Playback p = playing(5, 9);
    EXPECT_EQ(scrubbed(p, 7, after(1)), (Playback{{32, 1}, 5, 9, false, true, 0, 7, after(1)}));
    EXPECT_EQ(shown(scrubbed(p, 7, after(1)), after(2)), 8);
    EXPECT_EQ(shown(scrubbed(p, -most_frames, after(1)), after(1)), 5);
    EXPECT_EQ(shown(scrubbed(p, most_frames, after(1)), after(1)), 9);
    EXPECT_FALSE(scrubbed(paused(p, after(1)), 7, after(1)).playing);
}

TEST(Playback, SpeedsAreMultiplesOfTheRate) {
    for (int doublings = -3; doublings <= 3; ++doublings) {
        const Playback p = with_speed(playing(1, 100'000), doublings, after(0));
        EXPECT_EQ(p.speed(), std::pow(2.0, doublings));
        EXPECT_EQ(shown(p, after(800)), 1 + int(800 * p.speed()));
    }
    EXPECT_EQ(with_speed(playing(1, 2), 9, 0).speed(), 8);
    EXPECT_EQ(with_speed(playing(1, 2), -9, 0).speed(), 0.125);
}

TEST(Playback, ClockThatRunsBackDoesNoHarm) {
    const Playback p = playing(5, 9, true);
    for (const double now : {after(-1), -1e9, -infinity, double(NAN)}) {
        EXPECT_EQ(shown(p, now), 5);
        EXPECT_EQ(shown(paused(p, now), after(0)), 5);
    }
    // Once anything is done in the new time, it plays on in it.
    const Playback on = with_speed(scrubbed(p, 7, after(4)), 0, -1000);
    EXPECT_EQ(shown(on, -1000), 7);
    EXPECT_EQ(shown(on, -1000 + 1.0 / 32), 8);
}

TEST(Playback, OneFrameIsAlwaysShown) {
    for (const bool loop : {false, true}) {
        const Playback p = playing(1, 1, loop);
        EXPECT_EQ(frame_at(p, after(1000)).frame, 1);
        EXPECT_EQ(frame_at(p, after(0)).ended, !loop) << "nothing to play: over at once";
        EXPECT_EQ(next_change(p, after(0)), std::nullopt);
        EXPECT_EQ(stepped(p, 1, after(0)).anchor, 1);
        EXPECT_EQ(stepped(p, -1, after(0)).anchor, 1);
        EXPECT_EQ(toggled(settled(p, after(3)), after(3)).playing, !loop);
    }
}

// The earliest moment, to the last bit: before it there is nothing to draw, at it there is.
TEST(Playback, KnowsWhenTheNextFrameIsDue) {
    for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        Playback p{{1 + random.below(120'000), 1 + random.below(2000)}, 1, 0, false, true, 0, 0, 0};
        p.first = 1 + random.below(1000);
        p.last = p.first + 1 + random.below(1000);
        p.loop = random.below(2) == 0;
        p.doublings = random.below(7) - 3;
        p.anchor = random.in(double(p.first), double(p.last));
        p.moment = random.in(-1e5, 1e5);
        const double now = p.moment + random.in(-1, 3) * double(p.fps.denominator) /
                                          double(p.fps.numerator) / p.speed();
        const Position here = frame_at(p, now);
        const auto due = next_change(p, now);
        ASSERT_EQ(due.has_value(), !here.ended);
        if (!due) continue;
        const Position there = frame_at(p, *due), before = frame_at(p, std::nextafter(*due, -1e9));
        EXPECT_EQ(there.frame, here.frame < p.last ? here.frame + 1 : p.first);
        EXPECT_EQ(there.ended, !p.loop && there.frame == p.last);
        EXPECT_EQ(before.frame, here.frame);
        EXPECT_FALSE(before.ended);
        EXPECT_GT(*due, now);
        EXPECT_EQ(shown(paused(p, std::nextafter(*due, -1e9)), 0), here.frame);
    }
    EXPECT_EQ(next_change(paused(playing(1, 9), after(0)), after(0)), std::nullopt);
    EXPECT_EQ(next_change(playing(1, 9), after(2.5)), after(3));
}

bool is_sound(const Playback& p, double now) {
    const Position there = frame_at(p, now);
    return p.first >= 1 && p.first <= p.last && double(p.first) <= p.anchor &&
           p.anchor < double(p.last + 1) && p.first <= there.frame && there.frame <= p.last &&
           0 <= there.part && there.part < 1 && (!there.ended || there.frame == p.last);
}

// Whatever a person does in whatever order: nothing moves but what was asked to.
TEST(Playback, EveryChangeKeepsTheRest) {
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        Playback p = playback_of(
            {{1 + random.below(60'000), 1 + random.below(1001)}, 1 + random.below(200), false});
        double now = random.in(0, 1e6);
        for (int k = 0; k < 200; ++k) {
            now += random.in(0, 0.5);
            const Position here = frame_at(p, now);
            Playback q = p;
            bool stays = true;
            switch (random.below(7)) {
            case 0:
                q = paused(p, now);
                break;
            case 1:
                q = with_speed(p, random.below(9) - 4, now);
                break;
            case 2:
                q = with_loop(p, random.below(2) == 0, now);
                break;
            case 3:
                q = settled(p, now);
                break;
            case 4:
                q = toggled(p, now);
                EXPECT_EQ(q.playing, !p.playing || here.ended);
                stays = p.playing ? !here.ended : p.loop || here.frame < p.last;
                break;
            case 5: {
                const int to = random.below(300) - 50;
                q = scrubbed(p, to, now);
                EXPECT_EQ(shown(q, now), std::clamp<std::int64_t>(to, p.first, p.last));
                stays = false;
                break;
            }
            case 6:
                q = stepped(p, random.below(9) - 4, now);
                EXPECT_EQ(q.anchor, std::floor(q.anchor));
                stays = false;
                break;
            }
            const Position there = frame_at(q, now);
            ASSERT_TRUE(is_sound(q, now));
            if (stays) {
                ASSERT_EQ(there.frame, here.frame);
                if (q.loop == p.loop) {
                    ASSERT_NEAR(there.part, here.part, 1e-9);
                }
            }
            p = q;
        }
    }
}

TEST(FrameOfTime, IsTheFrameItself) {
    for (const FrameRate fps : {FrameRate{24, 1}, FrameRate{30000, 1001}, FrameRate{24000, 1001},
                                FrameRate{2997, 125}, FrameRate{1, 7}, FrameRate{999'999'937, 3}}) {
        const animation::Timeline timeline{fps};
        for (std::int64_t frame = -1000; frame < 20'000; ++frame) {
            const double time = timeline.time(frame);
            ASSERT_EQ(frame_of_time(fps, time), frame) << animation::to_string(fps);
            ASSERT_EQ(frame_of_time(fps, std::nextafter(time, infinity)), frame);
            ASSERT_EQ(frame_of_time(fps, std::nextafter(time, -infinity)), frame - 1);
        }
    }
}

TEST(FrameOfTime, SaturatesFarOutside) {
    const FrameRate fps{30, 1};
    EXPECT_GT(frame_of_time(fps, 1e300), std::int64_t(1) << 60);
    EXPECT_EQ(frame_of_time(fps, infinity), frame_of_time(fps, 1e300));
    EXPECT_LT(frame_of_time(fps, -infinity), -(std::int64_t(1) << 60));
    EXPECT_EQ(frame_of_time(fps, NAN), 1);
    EXPECT_GT(frame_of_time({1, 1'000'000'000}, 1e300), 1'000'000'000);
}

TEST(Playback, JumpsToTheFrameThatIsShownAtATime) {
    const animation::Timeline timeline{{30000, 1001}, 2000, false};
    const Playback p = playback_of(timeline);
    EXPECT_EQ(jumped_to_time(p, timeline.time(812), 5).anchor, 812);
    EXPECT_EQ(jumped_to_time(p, timeline.time(812, 0.99), 5).anchor, 812);
    EXPECT_EQ(jumped_to_time(p, -3, 5).anchor, 1);
    EXPECT_EQ(jumped_to_time(p, 1e9, 5).anchor, 2000);
    EXPECT_EQ(jumped_to_time(p, NAN, 5).anchor, 1);
}

TEST(Playback, KeepsTheScenesTimeInAnotherTimeline) {
    const animation::Timeline slow{{24, 1}, 240, false};
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const animation::Timeline fast{{24 + random.below(100), 1 + random.below(2)}, 5000, false};
        const std::int64_t frame = 1 + random.below(200);
        const Playback p = scrubbed(playback_of(slow), frame, 0);
        const Playback q = moved_to(p, slow, fast, 7);
        EXPECT_TRUE(is_sound(q, 7));
        EXPECT_EQ(q.last, 5000);
        const Position there = frame_at(q, 7);
        EXPECT_NEAR(fast.time(there.frame, there.part), slow.time(frame), 1e-9);
        EXPECT_EQ(shown(moved_to(q, fast, slow, 7), 7), frame) << "and back";
    }
}

TEST(Playback, AReloadKeepsWhatThePersonChose) {
    const animation::Timeline before{{24, 1}, 240, false};
    animation::Timeline now = before;
    Playback p = with_speed(played(with_loop(playback_of(before), true, 0), 0), 2, 0);
    p = scrubbed(p, 200, 0);
    now.frames = 300;
    Playback q = moved_to(p, before, now, 0);
    EXPECT_EQ(q, (Playback{{24, 1}, 1, 300, true, true, 2, 200, 0}));
    now.frames = 100;
    EXPECT_EQ(shown(moved_to(p, before, now, 0), 0), 100);
    // Unless the scene itself now says otherwise.
    animation::Timeline looping = before;
    looping.loops = true;
    EXPECT_FALSE(moved_to(with_loop(p, false, 0), before, before, 0).loop);
    EXPECT_TRUE(moved_to(with_loop(p, false, 0), before, looping, 0).loop);
}

TEST(Playback, OfSomeFramesStaysInThem) {
    const animation::Timeline timeline{{30, 1}, 120, true};
    const Playback some = with_frames(playback_of(timeline), 31, 60);
    EXPECT_EQ(frame_at(some, 0).frame, 31);
    const Playback running = played(some, 0);
    EXPECT_EQ(frame_at(running, 0.5).frame, 46);
    EXPECT_EQ(frame_at(running, 1.5).frame, 46); // a second later it has begun again
    const Playback once = played(with_loop(some, false, 0), 0);
    EXPECT_EQ(frame_at(once, 100).frame, 60);
    EXPECT_TRUE(frame_at(once, 100).ended);
}

} // namespace
} // namespace isomotion::player
