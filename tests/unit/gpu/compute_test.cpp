#include "gpu/compute.h"

#include "every_backend.h"

#include "gpu/error.h"

#include <gmock/gmock.h>

namespace isomotion::gpu {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class Compute : public EveryBackend {
protected:
    void SetUp() override {
        EveryBackend::SetUp();
        if (context && !has_compute(context->info())) GTEST_SKIP() << context->info().version;
    }
};
ISOMOTION_ON_EVERY_BACKEND(Compute);

std::string source(const std::string& body) {
    return "#version 430 core\n"
           "layout(local_size_x = 8, local_size_y = 8) in;\n"
           "layout(rgba32f, binding = 1) writeonly uniform image2D stored;\n"
           "uniform sampler2D earlier;\n"
           "void main() {\n"
           "    ivec2 at = ivec2(gl_GlobalInvocationID.xy);\n"
           "    " +
           body + "\n}\n";
}

TEST_P(Compute, StoresWhatIsRead) {
    const Program program = Program::compute(
        source("imageStore(stored, at, vec4(vec2(at), 1.0e-30, 16777215.0));"), "places");
    const Target target(19, 5); // of 3 x 1 groups: what lies outside is dropped
    bind_image(target.texture(0), 1);
    program.use();
    dispatch({3, 1});
    const std::vector<float> texels = target.read(0, 0, 0, 19, 5);
    for (int y = 0; y < 5; ++y) {
        for (int x = 0; x < 19; ++x) {
            const float* texel = texels.data() + 4 * (y * 19 + x);
            ASSERT_EQ(texel[0], float(x));
            ASSERT_EQ(texel[1], float(y));
            ASSERT_EQ(texel[2], 1.0e-30f);
            ASSERT_EQ(texel[3], 16777215.0f);
        }
    }
}

// Stores, fetches and draws in turn: each sees what the one before left.
TEST_P(Compute, StoresAndDrawsTakeTurns) {
    const Program counts =
        Program::compute(source("imageStore(stored, at, texelFetch(earlier, at, 0) + 1.0);"), "up");
    const Program doubles =
        fullscreen_program("uniform sampler2D earlier; out vec4 color;",
                           "color = 2.0 * texelFetch(earlier, ivec2(gl_FragCoord.xy), 0);");
    counts.bind_sampler("earlier", 3);
    doubles.bind_sampler("earlier", 3);
    const Target a(8, 8), b(8, 8);
    a.bind();
    a.clear(0);
    float expected = 0;
    for (int turn = 0; turn < 6; ++turn) {
        a.texture(0).bind(3);
        bind_image(b.texture(0), 1);
        counts.use();
        dispatch({1, 1});
        b.texture(0).bind(3);
        a.bind();
        doubles.use();
        Fullscreen().draw();
        expected = 2 * (expected + 1);
    }
    for (const float value : a.read(0, 0, 0, 8, 8)) ASSERT_EQ(value, expected);
}

TEST_P(Compute, ErrorsNameTheStage) {
    try {
        Program::compute(source("undeclared = 1.0;"), "broken");
        FAIL();
    } catch (const CompileError& error) {
        EXPECT_EQ(error.stage(), "compute");
        EXPECT_THAT(error.what(),
                    AllOf(HasSubstr("broken"), HasSubstr("> "), HasSubstr("undeclared = 1.0;")));
    }
}

TEST(ComputeVersion, Is43) {
    ContextInfo info;
    info.renderer = "some driver";
    info.major = 4, info.minor = 2;
    EXPECT_FALSE(has_compute(info));
    EXPECT_THROW(expect_compute(info, "this"), ResourceError);
    info.minor = 3;
    EXPECT_TRUE(has_compute(info));
    EXPECT_NO_THROW(expect_compute(info, "this"));
    info.major = 3, info.minor = 9;
    EXPECT_FALSE(has_compute(info));
}

} // namespace
} // namespace isomotion::gpu
