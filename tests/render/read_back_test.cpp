// Pixels come to their places in a frame's planes, read strip by strip or all at once, by one
// thread or several.
#include "render/read_back.h"

#include <gtest/gtest.h>

#include "render/drawing.h"

namespace isomotion::render {
namespace {

class ReadBacks : public Drawing {};
ISOMOTION_ON_EVERY_BACKEND(ReadBacks);

constexpr int width = 301, height = 233; // of the frame; strips of 64 Ki floats are not whole
constexpr gpu::Rectangle tile{90, 20, 200, 190};

// What the attachments hold in a pixel of the tile, counted from below.
float number(int attachment, int component, int x, int y) {
    return float(1000 * (4 * attachment + component) + x) + float(y) / 256;
}

image::Frame blank() {
    image::Frame frame{width, height, {}, {}};
    for (const char* name : {"R", "G", "B", "A", "P.X", "P.Z"})
        frame.channels.push_back({name, std::vector<float>(std::size_t(width * height), -1.0f)});
    return frame;
}

TEST_P(ReadBacks, BringEachPixelToItsPlace) {
    const gpu::Target target(256, 192, 3); // larger than the tile
    const gpu::Program program = gpu::fullscreen_program(
        "layout(location = 0) out vec4 a; layout(location = 1) out vec4 never;"
        "layout(location = 2) out vec4 b;",
        "vec2 at = gl_FragCoord.xy - 0.5; float v = at.x + at.y / 256.0;"
        "a = v + vec4(0.0, 1000.0, 2000.0, 3000.0); never = vec4(7.0); b = a + 8000.0;");
    target.bind();
    program.use();
    gpu::Fullscreen().draw();
    const Planes planes(width, height);
    for (const int threads : {1, 2, 5}) {
        for (const bool at_once : {false, true}) {
            SCOPED_TRACE(fmt::format("{} threads, {}", threads, at_once ? "at once" : "in strips"));
            image::Frame frame = blank();
            const auto plane = [&](int k) { return &frame.channels[std::size_t(k)]; };
            const std::vector<Attachment> attachments{{0, {plane(0), plane(1), plane(2), plane(3)}},
                                                      {2, {plane(4), nullptr, plane(5)}}};
            ReadBack back(threads);
            if (at_once) {
                gpu::Transfer pixels(2 * 4 * sizeof(float) * 200 * 190);
                back.at_once(target, {0, 0}, attachments, tile, planes, pixels);
            } else {
                back.in_strips(target, {0, 0}, attachments, tile, planes);
            }
            const int components[] = {0, 1, 2, 3, 0, 2}, of[] = {0, 0, 0, 0, 2, 2};
            int wrong = 0;
            for (int k = 0; k < 6; ++k) {
                for (int row = 0; row < height; ++row) {
                    for (int column = 0; column < width; ++column) {
                        const int x = column - tile.x, y = height - 1 - row - tile.y;
                        const bool inside = x >= 0 && y >= 0 && x < tile.width && y < tile.height;
                        const float wanted = inside ? number(of[k], components[k], x, y) : -1.0f;
                        wrong += plane(k)->samples[std::size_t(row * width + column)] != wanted;
                    }
                }
            }
            EXPECT_EQ(wrong, 0);
        }
    }
}

// A ray that has not ended counts as none of the verdicts.
TEST(Records, TellHowManyRaysEndedHow) {
    constexpr std::uint32_t unfinished = 7;
    for (const bool further : {false, true}) {
        SCOPED_TRACE(further ? "further rays" : "one word");
        Record record(5 * 3, further);
        std::vector<std::uint32_t> words;
        const std::array<int, 5> of_verdict{5, 4, 2, 1, 1};
        std::int64_t evaluations = 0;
        const auto add = [&](std::uint32_t verdict, std::uint32_t count) {
            words.push_back(verdict | count << 3);
            // shadows, paths, and the rays of both that stay undecided, below samples of occlusion
            if (further) words.insert(words.end(), {1000 + verdict, 3, 255 | 2 << 8 | 5 << 16});
            evaluations += count;
        };
        for (std::uint32_t verdict = 0; verdict < 5; ++verdict) {
            for (int k = 0; k < of_verdict[verdict]; ++k) add(verdict, 0x1fffffff - verdict);
        }
        add(unfinished, 60'000);
        add(unfinished, 0);
        record.take(words, 5, 3);
        const Tally tally = record.tally();
        EXPECT_EQ(tally.ended(), 13);
        for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(tally.verdicts[k], of_verdict[k]) << k;
        const auto of = [&](RayKind kind) { return tally.rays[std::size_t(kind)]; };
        EXPECT_EQ(of(RayKind::eye).evaluations, evaluations);
        EXPECT_EQ(of(RayKind::eye).most, 0x1fffffff);
        EXPECT_EQ(of(RayKind::eye).undecided, 2 + 1);
        EXPECT_EQ(of(RayKind::shadow).most, further ? 1007 : 0);
        EXPECT_EQ(of(RayKind::shadow).undecided, further ? 15 * 255 : 0);
        EXPECT_EQ(of(RayKind::path).evaluations, further ? 15 * 3 : 0);
        EXPECT_EQ(of(RayKind::path).undecided, further ? 15 * 2 : 0);
        EXPECT_EQ(of(RayKind::occlusion).evaluations, further ? 15 * 5 : 0);
        EXPECT_EQ(record.verdict(0), 0);
        EXPECT_EQ(record.evaluations(13), 60'000);
    }
}

} // namespace
} // namespace isomotion::render
