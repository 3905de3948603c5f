#include "every_backend.h"

#include "gpu/query.h"

#include <glad/gl.h>

#include <cfenv>
#include <stdexcept>

namespace isomotion::gpu {
namespace {

TEST(BackendName, ReadsBackWhatItWrites) {
    for (const Backend backend : {Backend::automatic, Backend::egl, Backend::osmesa, Backend::glfw})
        EXPECT_EQ(parse_backend(name(backend)), backend);
    try {
        parse_backend("vulkan");
        FAIL() << "an unknown name was accepted";
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(),
                     "unknown back end 'vulkan': it is one of auto, egl, osmesa, glfw");
    }
}

class ContextTest : public EveryBackend {};
ISOMOTION_ON_EVERY_BACKEND(ContextTest);

TEST_P(ContextTest, DescribesItself) {
    const ContextInfo& info = context->info();
    EXPECT_TRUE(info.backend.starts_with(name(GetParam()))) << info.backend;
    EXPECT_FALSE(info.vendor.empty());
    EXPECT_FALSE(info.renderer.empty());
    EXPECT_FALSE(info.version.empty());
    EXPECT_FALSE(info.glsl_version.empty());
    EXPECT_GE(info.major * 10 + info.minor, 33);
    EXPECT_GE(info.max_texture_size, 1024);
    EXPECT_GE(info.max_uniform_block_size, 16384);
    EXPECT_GE(info.max_texture_buffer_size, 65536);
    EXPECT_EQ(info.software, info.renderer.find("pipe") != std::string::npos);
}

TEST_P(ContextTest, IsCurrentFromCreationToRelease) {
    EXPECT_EQ(Context::current(), context.get());
    context->release();
    EXPECT_EQ(Context::current(), nullptr);
    EXPECT_THROW(Fullscreen(), std::logic_error);
    context->make_current();
    EXPECT_EQ(Context::current(), context.get());
    context.reset();
    EXPECT_EQ(Context::current(), nullptr);
}

TEST_P(ContextTest, ObjectsOutliveTheirContextHarmlessly) {
    auto target = std::make_unique<Target>(4, 4, 2);
    const Program program = fullscreen_program("out vec4 color;", "color = vec4(1.0);");
    context.reset();
    target.reset();
    context = Context::create(GetParam());
    EXPECT_EQ(draw_one(fullscreen_program("out vec4 color;", "color = vec4(0.5);")), 0.5f);
}

TEST_P(ContextTest, AnObjectDroppedElsewhereLeavesOthersAlone) {
    auto dropped = std::make_unique<Target>(1, 1);
    const unsigned number = dropped->id();
    const auto second = Context::create(GetParam());
    const Target kept(1, 1); // the first of its context, as `dropped` is of the other: same numbers
    ASSERT_EQ(kept.id(), number);
    kept.clear(0, {0.25f, 0, 0, 1});
    dropped.reset();
    EXPECT_EQ(kept.read(0, 0, 0, 1, 1).front(), 0.25f);
    EXPECT_TRUE(glIsFramebuffer(number));
    context->make_current();
    EXPECT_FALSE(glIsFramebuffer(number)) << "it was not removed when its context came back";
    second->make_current(); // where `kept` is at home
}

TEST_P(ContextTest, DrawsTheSameUnderAnotherRounding) {
    const auto body = "color = vec4(gl_FragCoord.x * 0.1 + gl_FragCoord.y * 0.7);";
    const float expected = draw_one(fullscreen_program("out vec4 color;", body));
    context.reset();
    std::fesetround(FE_UPWARD);
    context = Context::create(GetParam());
    EXPECT_EQ(std::fegetround(), FE_UPWARD) << "the caller's rounding is not ours to change";
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(draw_one(fullscreen_program("out vec4 color;", body)), expected);
}

/// Two back ends in one process, each current in turn.
TEST(TwoBackends, DrawEachIntoItsOwn) {
    const auto first = open_if_available(Backend::egl);
    const auto second = open_if_available(Backend::osmesa);
    if (!first || !second) GTEST_SKIP() << "two back ends are needed";

    first->make_current();
    const Target in_first(1, 1);
    second->make_current();
    const Target in_second(1, 1);

    for (int round = 0; round < 3; ++round) {
        const auto marker = float(round);
        first->make_current();
        in_first.clear(0, {0.25f + marker, 0, 0, 1});
        second->make_current();
        in_second.clear(0, {0.75f + marker, 0, 0, 1});
        first->make_current();
        EXPECT_EQ(in_first.read(0, 0, 0, 1, 1).front(), 0.25f + marker);
        second->make_current();
        EXPECT_EQ(in_second.read(0, 0, 0, 1, 1).front(), 0.75f + marker);
    }
    first->make_current();
    EXPECT_EQ(draw_one(fullscreen_program("out vec4 color;", "color = vec4(3.0);")), 3.0f);
}

TEST(TwoBackends, ContextsOfOneDisplayOutliveEachOther) {
    auto first = open_if_available(Backend::egl);
    if (!first) GTEST_SKIP() << "egl is not available here";
    auto second = Context::create(Backend::egl);
    first.reset();
    EXPECT_EQ(draw_one(fullscreen_program("out vec4 color;", "color = vec4(2.0);")), 2.0f);
}

} // namespace
} // namespace isomotion::gpu
