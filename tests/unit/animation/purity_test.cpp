// Values are a function of the frame's number and of nothing else, bit for bit.
#include <algorithm>
#include <bit>
#include <numeric>

#include "animation/animation.h"
#include "animation/timeline.h"
#include "testing.h"

namespace isomotion::animation {
namespace {

constexpr int frames = 900;
constexpr Timeline timeline{{30000, 1001}, frames};

Animation busy_animation() {
    const Keys keys{{{0, 0}, {3.3, 2.5}, {11, -4}, {29, 1}}, Ease::cubic};
    std::vector<Track> tracks{track("m", "3 + 2*sin(2*pi*t/4)*k"),
                              {"k", keys},
                              track("camera.fov", "40 + exp(-t)*m"),
                              {"fixed", 1.0 / 3}};
    std::vector<Array> arrays{{"blobs",
                               20,
                               {field("cx", "1.2*(2*random(i,0)-1)*(1-t/4)"),
                                field("cy", "cx^3 + tan(t)*random(i, floor(t))"),
                                {"w", 0.1}}}};
    return Animation(std::move(tracks), std::move(arrays), 42);
}

std::vector<std::uint64_t> bits(const Values& values) {
    std::vector<std::uint64_t> all{std::bit_cast<std::uint64_t>(values.time)};
    const auto append = [&](const std::vector<double>& numbers) {
        for (const double number : numbers) all.push_back(std::bit_cast<std::uint64_t>(number));
    };
    append(values.tracks);
    for (const auto& array : values.arrays) {
        for (const auto& column : array.fields) append(column);
    }
    return all;
}

TEST(Purity, AFrameAloneIsTheFrameOfTheSequence) {
    const Animation sequence = busy_animation();
    for (int frame = 1; frame < 812; ++frame) sequence.at(timeline.time(frame));
    EXPECT_EQ(bits(busy_animation().at(timeline.time(812))), bits(sequence.at(timeline.time(812))));
}

TEST(Purity, TheOrderOfFramesDoesNotMatter) {
    const Animation animation = busy_animation();
    std::vector<std::vector<std::uint64_t>> in_order;
    for (int frame = 1; frame <= frames; ++frame)
        in_order.push_back(bits(animation.at(timeline.time(frame))));
    std::vector<int> order(frames);
    std::iota(order.begin(), order.end(), 1);
    std::mt19937 engine(7);
    std::shuffle(order.begin(), order.end(), engine);
    for (const int frame : order) {
        ASSERT_EQ(bits(animation.at(timeline.time(frame))), in_order[std::size_t(frame - 1)])
            << frame;
    }
}

TEST(Purity, OtherTracksDoNotMatter) {
    const Animation all = busy_animation();
    const Animation few({all.tracks()[1], all.tracks()[0]}, {}, 42);
    for (int frame = 1; frame <= frames; ++frame) {
        const double time = timeline.time(frame);
        ASSERT_EQ(std::bit_cast<std::uint64_t>(value(all, "m", time)),
                  std::bit_cast<std::uint64_t>(value(few, "m", time)));
    }
}

TEST(EqualValues, AreEqualWhateverTheTime) {
    const Animation still({{"m", 2.0}, {"k", Keys{{{1, 0}, {2, 5}}, Ease::linear}}},
                          {{"blobs", 2, {field("r", "i")}}});
    EXPECT_TRUE(still.at(0) == still.at(0.75));
    EXPECT_TRUE(still.at(3) == still.at(99));
    EXPECT_FALSE(still.at(0) == still.at(1.5));
}

TEST(EqualValues, CompareTracksAndEveryElement) {
    const Animation animation({{"m", 1.0}}, {{"blobs", 3, {field("r", "i"), field("s", "2*i")}}});
    const Values values = animation.at(0);
    Values other = values;
    EXPECT_TRUE(values == other);
    other.tracks[0] = std::nextafter(1.0, 2.0);
    EXPECT_FALSE(values == other);
    other = values;
    other.arrays[0].fields[1][2] += 1;
    EXPECT_FALSE(values == other);
    other = values;
    other.arrays[0].count = 2;
    EXPECT_FALSE(values == other);
    other = values;
    other.arrays.clear();
    EXPECT_FALSE(values == other);
    other = values;
    other.tracks.push_back(0);
    EXPECT_FALSE(values == other);
}

} // namespace
} // namespace isomotion::animation
