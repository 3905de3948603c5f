#include "every_backend.h"

#include "gpu/buffer.h"
#include "gpu/compute.h"
#include "gpu/depth_mask.h"
#include "gpu/query.h"
#include "gpu/rectangles.h"
#include "gpu/transfer.h"

#include <array>
#include <chrono>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>

namespace isomotion::gpu {
namespace {

class DrawingTest : public EveryBackend {};
ISOMOTION_ON_EVERY_BACKEND(DrawingTest);

TEST_P(DrawingTest, AttachmentsKeepFloatsExactly) {
    const Program program = fullscreen_program(
        "layout(location = 0) out vec4 a; layout(location = 1) out vec4 b;",
        "a = vec4(gl_FragCoord.xy, 1.0e-30, 16777215.0);"
        "b = vec4(uintBitsToFloat(0x7fc00000u), uintBitsToFloat(0xff800000u), -0.0, 0.1);");
    const Target target(5, 3, 2);
    target.bind();
    program.use();
    Fullscreen().draw();

    const auto a = target.read(0, 0, 0, 5, 3);
    ASSERT_EQ(a.size(), 5u * 3 * 4);
    for (std::size_t y = 0; y < 3; ++y) {
        for (std::size_t x = 0; x < 5; ++x) {
            const float* pixel = &a[(y * 5 + x) * 4];
            EXPECT_EQ(pixel[0], float(x) + 0.5f);
            EXPECT_EQ(pixel[1], float(y) + 0.5f);
            EXPECT_EQ(pixel[2], 1.0e-30f);
            EXPECT_EQ(pixel[3], 16777215.0f);
        }
    }
    const auto b = target.read(1, 4, 2, 1, 1);
    EXPECT_TRUE(std::isnan(b[0]));
    EXPECT_EQ(b[1], -std::numeric_limits<float>::infinity());
    EXPECT_EQ(b[2], 0.0f);
    EXPECT_EQ(b[3], 0.1f);
}

TEST_P(DrawingTest, AMaskKeepsDrawsToItsPixelsUntilItIsSetAnew) {
    const Target target(37, 5, 1);
    const DepthMask mask(target);
    const Program left = fullscreen_program(
        "out vec4 never;", "never = vec4(9.0); gl_FragDepth = gl_FragCoord.x < 18.0 ? 1.0 : 0.0;");
    const Program none = fullscreen_program("", "gl_FragDepth = 0.0;");
    const Program seven = fullscreen_program("out vec4 a;", "a = vec4(7.0);");
    const Fullscreen triangle;
    const auto draw = [&](const Program& program) {
        return [&] {
            program.use();
            triangle.draw();
        };
    };
    const auto sevens = [&] {
        int count = 0;
        const auto pixels = target.read(0, 0, 0, 37, 5);
        for (std::size_t k = 0; k < pixels.size(); k += 4) {
            const bool is_left = (k / 4) % 37 < 18;
            EXPECT_TRUE(pixels[k] == 1 || (pixels[k] == 7 && is_left))
                << k / 4 << ": " << pixels[k];
            count += pixels[k] == 7;
        }
        return count;
    };

    mask.set(draw(left));
    target.clear(0, glm::vec4(1));
    mask.apply(draw(seven));
    EXPECT_EQ(sevens(), 18 * 5);
    mask.set(draw(none));
    target.clear(0, glm::vec4(1));
    mask.apply(draw(seven));
    EXPECT_EQ(sevens(), 0);
    target.bind();
    draw(seven)();
    EXPECT_EQ(target.read(0, 36, 4, 1, 1)[0], 7) << "other draws know no mask";
}

// Later draws into the same target change nothing of what was asked for.
TEST_P(DrawingTest, ATransferBringsWhatWasThereWhenItWasAskedFor) {
    const std::array formats{Format::rgba32f, Format::r32ui};
    const Target target(5, 3, formats);
    target.clear(0, glm::vec4(0.1f, -2, 1e30f, 4));
    target.clear(1, 4000000000u);
    Transfer transfer(5 * 3 * 16 + 2 * 4);
    const std::size_t colors = transfer.ask(target, 0, {0, 0, 5, 3}, 0);
    EXPECT_EQ(colors, 5u * 3 * 16);
    EXPECT_EQ(transfer.ask(target, 1, {1, 1, 2, 1}, colors), colors + 8);
    EXPECT_THROW(transfer.ask(target, 1, {0, 0, 5, 3}, colors), std::length_error);
    EXPECT_THROW(transfer.read([](auto) {}), std::logic_error) << "nothing was sent";
    transfer.send();
    target.clear(0, glm::vec4(9));
    target.clear(1, 9u);
    bool shown = false;
    transfer.read([&](std::span<const std::byte> bytes) {
        shown = true;
        ASSERT_EQ(bytes.size(), 5u * 3 * 16 + 8);
        std::array<float, 5 * 3 * 4> floats{};
        std::array<std::uint32_t, 2> words{};
        std::memcpy(floats.data(), bytes.data(), sizeof floats);
        std::memcpy(words.data(), bytes.data() + colors, sizeof words);
        for (std::size_t k = 0; k < floats.size(); k += 4) {
            EXPECT_EQ(floats[k], 0.1f);
            EXPECT_EQ(floats[k + 1], -2);
            EXPECT_EQ(floats[k + 2], 1e30f);
            EXPECT_EQ(floats[k + 3], 4);
        }
        EXPECT_EQ(words, (std::array<std::uint32_t, 2>{4000000000u, 4000000000u}));
    });
    EXPECT_TRUE(shown);
    EXPECT_EQ(target.read(0, 0, 0, 1, 1)[0], 9) << "other reads know no buffer";
}

TEST_P(DrawingTest, WholeNumbersAreClearedToo) {
    const std::array formats{Format::r32f, Format::r32ui};
    const Target target(2, 2, formats);
    target.clear(1, 4294967294u);
    std::array<std::uint32_t, 4> numbers{};
    target.read(1, 0, 0, 2, 2, numbers);
    EXPECT_EQ(numbers,
              (std::array<std::uint32_t, 4>{4294967294u, 4294967294u, 4294967294u, 4294967294u}));
}

// Beside each other in one target, as what is counted of a pixel is beside its colour.
TEST_P(DrawingTest, AttachmentsOfSeveralFormats) {
    const Program program = fullscreen_program(
        "layout(location = 0) out vec4 a; layout(location = 1) out uvec4 b;"
        "layout(location = 2) out uint c; layout(location = 3) out float d;",
        "a = vec4(0.1); b = uvec4(4294967295u, gl_FragCoord.x, 3, 4); c = 16777217u; d = 0.3;");
    const std::array formats{Format::rgba32f, Format::rgba32ui, Format::r32ui, Format::r32f};
    const Target target(3, 2, formats);
    target.bind();
    program.use();
    Fullscreen().draw();
    std::array<std::uint32_t, 2 * 4> b{};
    target.read(1, 1, 1, 2, 1, b);
    EXPECT_EQ(b, (std::array<std::uint32_t, 8>{4294967295u, 1, 3, 4, 4294967295u, 2, 3, 4}));
    std::array<std::uint32_t, 6> c{};
    target.read(2, 0, 0, 3, 2, c);
    for (const std::uint32_t whole : c) EXPECT_EQ(whole, 16777217u); // no float
    EXPECT_EQ(target.read(0, 2, 1, 1, 1), std::vector<float>(4, 0.1f));
    EXPECT_EQ(target.read(3, 0, 0, 3, 2), std::vector<float>(6, 0.3f));
    std::array<float, 6> floats{};
    EXPECT_THROW(target.read(2, 0, 0, 3, 2, floats), std::invalid_argument);
    EXPECT_THROW(target.read(3, 0, 0, 3, 2, c), std::invalid_argument);
}

TEST_P(DrawingTest, ReadsARectangleFromTheLowerLeft) {
    const Program program =
        fullscreen_program("out vec4 color;", "color = vec4(floor(gl_FragCoord.xy), 0.0, 1.0);");
    const Target target(8, 6);
    target.bind();
    program.use();
    Fullscreen().draw();
    std::array<float, 2 * 2 * 4> pixels{};
    target.read(0, 5, 3, 2, 2, pixels);
    EXPECT_EQ(pixels, (std::array<float, 16>{5, 3, 0, 1, 6, 3, 0, 1, 5, 4, 0, 1, 6, 4, 0, 1}));
    EXPECT_THROW(target.read(0, 7, 0, 2, 1), std::out_of_range);
    EXPECT_THROW(target.read(1, 0, 0, 1, 1), std::out_of_range);
    EXPECT_THROW(target.read(0, 0, 0, 1, 1, pixels), std::invalid_argument);
}

TEST_P(DrawingTest, AScissorEndsWithItsScope) {
    const Program program = fullscreen_program("out vec4 color;", "color = vec4(1.0);");
    const Target target(4, 4);
    target.clear(0);
    target.bind();
    program.use();
    const Fullscreen fullscreen;
    const auto covered = [&] {
        float sum = 0;
        for (const float value : target.read(0, 0, 0, 4, 4)) sum += value;
        return sum / 4;
    };
    {
        const Scissor scissor({1, 1, 2, 3});
        fullscreen.draw();
    }
    EXPECT_EQ(covered(), 6.0f);
    fullscreen.draw();
    EXPECT_EQ(covered(), 16.0f);
}

TEST_P(DrawingTest, BuffersReachTheShader) {
    const Program program = fullscreen_program(
        "layout(std140) uniform Values { vec4 scale; }; uniform samplerBuffer points;"
        "out vec4 color;",
        "color = scale.y * texelFetch(points, textureSize(points) - 1);");
    UniformBuffer block(32);
    TextureBuffer points(100);
    program.bind_block("Values", 3);
    program.bind_sampler("points", 2);
    block.bind(3);
    points.bind(2);

    for (const float factor : {2.0f, 5.0f}) {
        const std::array scale = {glm::vec4(0, factor, 0, 0)};
        std::array<glm::vec4, 100> texels{};
        texels.back() = {1.5f, 0, 0, 0};
        block.update(std::as_bytes(std::span(scale)));
        points.update(texels);
        EXPECT_EQ(draw_one(program), 1.5f * factor);
    }
    const std::array<glm::vec4, 101> too_long{};
    EXPECT_THROW(points.update(too_long), std::length_error);
    EXPECT_THROW(block.update(std::as_bytes(std::span(too_long))), std::length_error);
}

TEST_P(DrawingTest, TexturesReachTheShader) {
    const Program program = fullscreen_program(
        "uniform sampler2D image; out vec4 color;",
        "color = vec4(texelFetch(image, ivec2(1, 0), 0).r + texelFetch(image, ivec2(0, 1), 0).g);");
    const std::array<float, 8> texels = {0, 0, 10, 0, 0, 0.5f, 0, 0};
    Texture texture(Format::rg32f, 2, 2, texels);
    program.bind_sampler("image", 1);
    texture.bind(1);
    EXPECT_EQ(draw_one(program), 10.5f);
    texture.update(std::array<float, 8>{0, 0, 20, 0, 0, 0.5f, 0, 0});
    texture.bind(1);
    EXPECT_EQ(draw_one(program), 20.5f);
    texture.update_rows(1, std::array<float, 4>{0, 3, 0, 0});
    texture.bind(1);
    EXPECT_EQ(draw_one(program), 23.0f);
    EXPECT_THROW(texture.update_rows(2, std::array<float, 4>{}), std::invalid_argument);
    EXPECT_THROW(texture.update_rows(0, std::array<float, 3>{}), std::invalid_argument);
    EXPECT_THROW(Texture(Format::r32f, 2, 2, texels), std::invalid_argument);
}

TEST_P(DrawingTest, ASamplesQuerySeesWhetherAnythingWasWritten) {
    const Program program = fullscreen_program("uniform int drop; out vec4 color;",
                                               "if (drop != 0) discard; color = vec4(1.0);");
    const Target target(64, 64);
    target.bind();
    const Fullscreen fullscreen;
    SamplesQuery query;
    for (const int drop : {0, 1, 0}) {
        program.set("drop", drop);
        query.begin();
        fullscreen.draw();
        query.end();
        EXPECT_EQ(query.passed() > 0, drop == 0);
        EXPECT_TRUE(query.ready());
    }
}

// Each pixel of a rectangle is drawn once, also on the diagonal of its two triangles.
TEST_P(DrawingTest, RectanglesHoldTheirPixelsOnce) {
    std::ifstream file(ISOMOTION_SOURCE_DIR "/shaders/fullscreen.vert");
    const std::string vertex = "#version 330 core\n#define RECTANGLES\n" +
                               std::string(std::istreambuf_iterator<char>(file), {});
    const Program program(vertex,
                          "#version 330 core\nout vec4 color;\nvoid main() { color = vec4(1.0); }",
                          "rectangles");
    const Target target(37, 23);
    const std::vector<Rectangle> areas{
        {0, 0, 1, 1}, {3, 2, 16, 16}, {36, 22, 1, 1}, {20, 5, 17, 3}};
    Rectangles rectangles;
    rectangles.set(areas);
    target.clear(0);
    target.bind();
    program.bind_sampler("rectangles", 0);
    rectangles.words().bind(0);
    program.set("pixel_of_viewport", glm::vec2(2.0f / 37, 2.0f / 23));
    program.use();
    SamplesQuery query;
    query.begin();
    rectangles.draw();
    query.end();
    int pixels = 0;
    std::vector<int> expected(37 * 23);
    for (const Rectangle& area : areas) {
        pixels += area.width * area.height;
        for (int y = area.y; y < area.y + area.height; ++y)
            for (int x = area.x; x < area.x + area.width; ++x)
                expected[std::size_t(y * 37 + x)] = 1;
    }
    EXPECT_EQ(query.passed(), std::uint32_t(pixels));
    const auto drawn = target.read(0, 0, 0, 37, 23);
    for (std::size_t k = 0; k < expected.size(); ++k)
        EXPECT_EQ(int(drawn[4 * k]), expected[k]) << k;

    rectangles.set({});
    query.begin();
    rectangles.draw();
    query.end();
    EXPECT_EQ(query.passed(), 0u);
}

TEST_P(DrawingTest, ATimerAgreesWithTheClock) {
    using Clock = std::chrono::steady_clock;
    const Program program = fullscreen_program(
        "out vec4 color;", "float a = 0.0;"
                           "for (int i = 0; i < 100; ++i) a = sin(a + gl_FragCoord.x);"
                           "color = vec4(a);");
    const Target target(512, 512);
    target.bind();
    program.use();
    const Fullscreen fullscreen;
    Timer timer;
    for (int draw = 0; draw < 3; ++draw) { // the first one also compiles
        finish();
        const auto before = Clock::now();
        timer.begin();
        fullscreen.draw();
        timer.end();
        const auto reported = double(timer.nanoseconds());
        finish();
        const std::chrono::duration<double, std::nano> wall = Clock::now() - before;
        EXPECT_TRUE(timer.ready());
        EXPECT_LE(reported, wall.count());
        if (context->info().software) {
            EXPECT_GE(reported, 0.5 * wall.count());
        }
    }
}

TEST_P(DrawingTest, TooMuchIsAResourceError) {
    const int limit = context->info().max_texture_size;
    EXPECT_THROW(Texture(Format::r32f, limit + 1, 1), ResourceError);
    EXPECT_THROW(Texture(Format::r32f, 0, 1), ResourceError);
    EXPECT_THROW(Target(4, 4, 1000), ResourceError);
    EXPECT_THROW(UniformBuffer(std::size_t(context->info().max_uniform_block_size) + 1),
                 ResourceError);
    EXPECT_THROW(TextureBuffer(std::size_t(context->info().max_texture_buffer_size) + 1),
                 ResourceError);
}

TEST_P(DrawingTest, RunningOutOfMemoryIsAResourceError) {
    if (context->info().renderer.find("llvmpipe") == std::string::npos)
        GTEST_SKIP() << "only llvmpipe's limit of one resource is known";
    try {
        const Target target(16384, 16384);
        GTEST_SKIP() << "this version allows it";
    } catch (const ResourceError& error) {
        EXPECT_NE(std::string(error.what()).find("16384 x 16384"), std::string::npos);
    }
}

} // namespace
} // namespace isomotion::gpu
