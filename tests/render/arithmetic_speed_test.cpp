#include "render/arithmetic_speed.h"

#include "gpu/compute.h"
#include "render/drawing.h"

namespace isomotion::render::arithmetic_speed_test {
namespace {

class Speed : public gpu::EveryBackend {};
ISOMOTION_ON_EVERY_BACKEND(Speed);

// A processor does more than a million operations a second, and no machine 10^17.
TEST_P(Speed, OfArithmeticIsMeasuredInBothStages) {
    const ArithmeticSpeed speed = measure_arithmetic_speed();
    EXPECT_GT(speed.in_fragments, 1e6);
    EXPECT_LT(speed.in_fragments, 1e17);
    if (gpu::has_compute(context->info())) {
        EXPECT_GT(speed.in_compute, 1e6);
        EXPECT_LT(speed.in_compute, 1e17);
    } else {
        EXPECT_EQ(speed.in_compute, 0);
    }
}

// Renderers on software don't wait for it.
TEST_P(Speed, IsThatOfHardwareAlone) {
    const bool known = arithmetic_speed(context->info()).in_fragments > 0;
    EXPECT_NE(known, context->info().software);
}

// What chains tend to is 1, and no chain may be left out: their sum is their number.
TEST_P(Speed, IsThatOfChainsWhichAreAllComputed) {
    for (const int chains : {1, 2, 3, 4, 8}) {
        for (const int unrolled : {16, 32}) {
            const gpu::Program program =
                speed_program(shader::Stage::fragment, {.chains = chains, .unrolled = unrolled});
            const gpu::Target target(8, 8);
            target.bind();
            set_rounds(program, 20'000 / unrolled);
            gpu::Fullscreen().draw();
            const float place = 7.5f * 1e-3f + 0.5f;
            float sum = float(chains); // and those that stay where they began
            for (int k = chains; k < 8; ++k) sum += place + float(k);
            EXPECT_NEAR(target.read(0, 7, 7, 1, 1)[0], sum, 1e-3) << chains << ", " << unrolled;
        }
    }
}

} // namespace
} // namespace isomotion::render::arithmetic_speed_test
