#include "animation/element_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gmock/gmock.h>

namespace isomotion::animation {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Interpolation = ElementSamples::Interpolation;

// Three times: elements 1 2 3, then 3 1 4, then none; the value of an element is 10 * id + time.
ElementSamples three_times(Interpolation interpolation, bool with_ids = true) {
    ElementSamples::Rows rows;
    rows.times = {0, 2, 3};
    rows.begin = {0, 3, 6, 6};
    rows.values = {{10, 20, 30, 32, 12, 42}};
    if (with_ids) rows.ids = {1, 2, 3, 3, 1, 4};
    return ElementSamples(std::move(rows), interpolation);
}

TEST(ElementSamples, AreExactAtTheirTimes) {
    for (const auto interpolation : {Interpolation::linear, Interpolation::hold}) {
        const ElementSamples samples = three_times(interpolation);
        EXPECT_THAT(samples.at(0).fields[0], ElementsAre(10, 20, 30));
        EXPECT_THAT(samples.at(2).fields[0], ElementsAre(32, 12, 42));
        EXPECT_EQ(samples.at(2).count, 3);
        EXPECT_THAT(samples.at(3).fields[0], IsEmpty());
        EXPECT_EQ(samples.at(3).count, 0);
    }
}

TEST(ElementSamples, MoveToWhereTheirIdIsNext) {
    const ElementSamples samples = three_times(Interpolation::linear);
    // 1 and 3 go on; 2 has no successor and stays, 4 has no predecessor and is not yet there.
    EXPECT_THAT(samples.at(1).fields[0], ElementsAre(11, 20, 31));
    EXPECT_THAT(samples.at(0.5).fields[0], ElementsAre(10.5, 20, 30.5));
    EXPECT_THAT(samples.at(std::nextafter(2, 0)).fields[0][1], 20);
    EXPECT_EQ(samples.at(std::nextafter(2, 0)).count, 3);
    // Nothing is left at 3: until then everything stays.
    EXPECT_THAT(samples.at(2.9).fields[0], ElementsAre(32, 12, 42));
}

TEST(ElementSamples, WithoutIdsMoveToTheirPlaceInTheNextSample) {
    const ElementSamples samples = three_times(Interpolation::linear, false);
    EXPECT_THAT(samples.at(1).fields[0], ElementsAre(21, 16, 36));
}

TEST(ElementSamples, HoldUntilTheNextSample) {
    const ElementSamples samples = three_times(Interpolation::hold);
    EXPECT_THAT(samples.at(1.999).fields[0], ElementsAre(10, 20, 30));
}

TEST(ElementSamples, StayBeforeTheFirstSampleAndAfterTheLast) {
    const ElementSamples samples = three_times(Interpolation::linear);
    for (const double before : {-1.0, -1e300, -HUGE_VAL}) {
        EXPECT_THAT(samples.at(before).fields[0], ElementsAre(10, 20, 30));
    }
    for (const double after : {3.5, 1e300, HUGE_VAL}) EXPECT_EQ(samples.at(after).count, 0);
    EXPECT_EQ(samples.first_time(), 0);
    EXPECT_EQ(samples.last_time(), 3);
    EXPECT_EQ(samples.most(), 3);
}

TEST(ElementSamples, OneSampleStandsStill) {
    ElementSamples::Rows rows;
    rows.times = {5};
    rows.begin = {0, 2};
    rows.values = {{1, 2}, {3, 4}};
    const ElementSamples samples(std::move(rows), Interpolation::linear);
    for (const double time : {-1.0, 0.0, 5.0, 9.0}) {
        EXPECT_THAT(samples.at(time).fields[0], ElementsAre(1, 2));
        EXPECT_THAT(samples.at(time).fields[1], ElementsAre(3, 4));
    }
}

TEST(ElementSamples, ReorderWhereOneThatStaysIsInAnotherRow) {
    // Elements 1 2 3, then 1 3 2, then 1 3, then 1 3 again.
    const ElementSamples::Rows rows{{0, 1, 2, 3},
                                    {0, 3, 6, 8, 10},
                                    {std::vector<double>(10, 7.0)},
                                    {1, 2, 3, 1, 3, 2, 1, 3, 1, 3}};
    for (const auto interpolation : {Interpolation::linear, Interpolation::hold}) {
        const ElementSamples samples(rows, interpolation);
        const std::array<bool, 4> jumps{false, false, true, false};
        const std::array<bool, 4> recounts{false, false, true, false};
        const std::array<bool, 4> reorders{false, true, false, false};
        for (std::size_t k = 0; k < 4; ++k) {
            EXPECT_EQ(samples.jumps(k), jumps[k]) << k;
            EXPECT_EQ(samples.recounts(k), recounts[k]) << k;
            EXPECT_EQ(samples.reorders(k), reorders[k]) << k;
        }
    }
    // Without ids the k-th is the k-th.
    const ElementSamples samples(three_times(Interpolation::linear, false));
    for (std::size_t k = 0; k < 3; ++k) EXPECT_FALSE(samples.reorders(k)) << k;
}

// The second of three ends where a fourth begins: as many as before.
TEST(ElementSamples, JumpWhereOneEndsThoughAnotherBegins) {
    for (const auto interpolation : {Interpolation::linear, Interpolation::hold}) {
        const ElementSamples samples = three_times(interpolation);
        EXPECT_FALSE(samples.recounts(1));
        EXPECT_TRUE(samples.jumps(1));
    }
}

// A column with velocities, of a motion that a cubic is.
double cubic(double t) { return 2 + t - 3 * t * t + 0.5 * t * t * t; }
double speed(double t) { return 1 - 6 * t + 1.5 * t * t; }

ElementSamples::Rows moving_rows() {
    ElementSamples::Rows rows;
    rows.times = {0, 0.5, 2};
    rows.begin = {0, 2, 4, 5};
    // Element 1 is in all, in another row in the second; 2 is in the first two.
    rows.ids = {1, 2, 2, 1, 1};
    rows.values = {{cubic(0), 7, 8, cubic(0.5), cubic(2)}, {speed(0), 2, 2, speed(0.5), speed(2)}};
    rows.velocities = {1, std::nullopt};
    return rows;
}

TEST(ElementSamples, WithVelocitiesFollowTheCubic) {
    const ElementSamples samples(moving_rows(), Interpolation::hermite);
    for (const double t : {0.0, 0.1, 0.25, 0.49}) {
        EXPECT_NEAR(samples.at(t).fields[0][0], cubic(t), 1e-12) << t;
        EXPECT_NEAR(samples.at(t).fields[0][1], 7 + 2 * t, 1e-12) << t;
    }
    for (const double t : {0.5, 1.0, 1.99}) {
        EXPECT_NEAR(samples.at(t).fields[0][1], cubic(t), 1e-12) << t;
        // It ends at the third: until then it goes on as fast as it was.
        EXPECT_NEAR(samples.at(t).fields[0][0], 8 + 2 * (t - 0.5), 1e-12) << t;
        // Velocities themselves go straight.
        EXPECT_NEAR(samples.at(t).fields[1][1],
                    speed(0.5) + (t - 0.5) / 1.5 * (speed(2) - speed(0.5)), 1e-12)
            << t;
    }
    EXPECT_THAT(samples.at(9).fields[0], ElementsAre(cubic(2)));
    EXPECT_TRUE(samples.is_curved(0));
    EXPECT_FALSE(samples.is_curved(1));
}

TEST(ElementSamples, MultipliedMoveAsTheyDidButFarther) {
    const ElementSamples samples(moving_rows(), Interpolation::hermite);
    const ElementSamples twice = samples.multiplied(0, -2);
    for (const double t : {0.0, 0.3, 0.5, 1.7, 2.0}) {
        const auto once = samples.at(t), now = twice.at(t);
        for (std::size_t i = 0; i < once.fields[0].size(); ++i) {
            EXPECT_NEAR(now.fields[0][i], -2 * once.fields[0][i], 1e-12);
            EXPECT_EQ(now.fields[1][i], once.fields[1][i]);
        }
    }
}

TEST(ElementSamples, OnlySomeColumnsHaveValues) {
    const ElementSamples samples = ElementSamples(moving_rows(), Interpolation::hermite);
    const ElementSamples only = samples.only({true, false});
    for (const double t : {0.0, 0.3, 1.7}) {
        EXPECT_EQ(only.at(t).fields[0], samples.at(t).fields[0]);
        EXPECT_THAT(only.at(t).fields[1], IsEmpty());
        EXPECT_EQ(only.at(t).count, samples.at(t).count);
    }
}

TEST(ElementSamples, TwinsAreFound) {
    EXPECT_FALSE(find_twins(std::vector<std::int64_t>{1, 2, 9}));
    EXPECT_FALSE(find_twins(std::vector<std::int64_t>{9, -2, 1}));
    const auto twins = find_twins(std::vector<std::int64_t>{4, 9, 1, 9, 4, 4});
    ASSERT_TRUE(twins);
    EXPECT_EQ(twins->first, 1u);
    EXPECT_EQ(twins->second, 3u);
}

// Against a look at every pair; ids from all of their range, of few and of many bytes.
TEST(ElementSamples, AreMatchedByTheirIds) {
    std::mt19937_64 random(5);
    constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min();
    constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
    for (int round = 0; round < 300; ++round) {
        const std::int64_t span = round % 3 == 0 ? 40 : round % 3 == 1 ? 70'000 : most;
        std::uniform_int_distribution<std::int64_t> draw(-span, span);
        std::vector<std::int64_t> all{0, -1, 1, 255, 256, -256};
        if (span == most) all.insert(all.end(), {least, most});
        for (int k = 0; k < 30; ++k) all.push_back(draw(random));
        const auto some = [&](bool twice) {
            std::vector<std::int64_t> ids = all;
            if (!twice) {
                std::ranges::sort(ids);
                ids.erase(std::ranges::unique(ids).begin(), ids.end());
            }
            std::ranges::shuffle(ids, random);
            ids.resize(random() % (ids.size() + 1));
            return ids;
        };
        std::vector<std::int64_t> here = some(false), there = some(false);
        // As simulations write them: many where they were.
        if (round % 2)
            std::copy_n(here.begin(), std::min(here.size(), there.size()) / 2, there.begin());
        if (find_twins(there)) continue;
        const std::vector<std::uint32_t> found = match(here, there);
        ASSERT_EQ(found.size(), here.size());
        for (std::size_t row = 0; row < here.size(); ++row) {
            const auto at = std::ranges::find(there, here[row]);
            EXPECT_EQ(found[row], at == there.end() ? SampleSource::Successors::none
                                                    : std::uint32_t(at - there.begin()))
                << round;
        }

        const std::vector<std::int64_t> ids = some(true);
        std::optional<std::size_t> second; // the first that was there before
        for (std::size_t k = 0; k < ids.size() && !second; ++k) {
            if (std::find(ids.begin(), ids.begin() + std::ptrdiff_t(k), ids[k]) !=
                ids.begin() + std::ptrdiff_t(k))
                second = k;
        }
        const auto twins = find_twins(ids);
        ASSERT_EQ(twins.has_value(), second.has_value()) << round;
        if (!twins) continue;
        EXPECT_EQ(twins->second, *second);
        EXPECT_EQ(twins->first, std::size_t(std::ranges::find(ids, ids[*second]) - ids.begin()));
    }
}

// No jump but where elements come and go.
TEST(ElementSamples, MoveContinuously) {
    ElementSamples::Rows rows;
    const int times = 20, elements = 7;
    rows.begin = {0};
    rows.values.resize(1);
    for (int k = 0; k < times; ++k) {
        rows.times.push_back(k * 0.1);
        for (int e = 0; e < elements; ++e) {
            rows.values[0].push_back(std::sin(3 * k + e));
            rows.ids.push_back((e * 3 + k) % elements); // another order every time
        }
        rows.begin.push_back(std::size_t(elements * (k + 1)));
    }
    const auto of_id = [&](int k, int id) {
        for (int e = 0; e < elements; ++e) {
            if (rows.ids[std::size_t(k * elements + e)] == id)
                return rows.values[0][std::size_t(k * elements + e)];
        }
        return HUGE_VAL;
    };
    std::vector<double> ends;
    for (int id = 0; id < elements; ++id) ends.push_back(of_id(8, id));
    const auto ids_of_7 =
        std::vector(rows.ids.begin() + 7 * elements, rows.ids.begin() + 8 * elements);
    const ElementSamples samples(std::move(rows), Interpolation::linear);
    const auto just_before = samples.at(std::nextafter(8 * 0.1, 0)).fields[0];
    for (int e = 0; e < elements; ++e) {
        EXPECT_NEAR(just_before[std::size_t(e)], ends[std::size_t(ids_of_7[std::size_t(e)])],
                    1e-12);
    }
}

} // namespace
} // namespace isomotion::animation
