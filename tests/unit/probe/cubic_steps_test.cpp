// Which frames tell how long steps of cubics may be.
#include "probe/cubic_steps.h"

#include <fmt/format.h>

#include "unit/scene/testing.h"

namespace isomotion::probe {
namespace {

using namespace scene;

class CubicStepsOfScenes : public Scenes {
protected:
    // A lattice of waves k long, of size a.
    formula::CubicSteps steps_of(int frames, const char* k, const char* a) const {
        return loaded(fmt::format("[time]\nfps = 30\nframes = {}\n[surface]\n"
                                  "formula = \"a*sin(k*x)*sin(k*y)*sin(k*z) - 0.6\"\n"
                                  "bounds = {{ sphere = 2 }}\n[parameters]\nk = {}\na = {}\n",
                                  frames, k, a))
            .surfaces[0]
            .measured.cubic_steps;
    }
};

TEST_F(CubicStepsOfScenes, AreThoseOfTheShortestWavesOfAnyFrame) {
    const formula::CubicSteps still = steps_of(1, "60", "1");
    EXPECT_LT(still.longest, 0.5);
    EXPECT_EQ(steps_of(1, "2", "1"), formula::CubicSteps{});
    for (const char* k : {
             "\"60*t\"",                                     // at the end
             "\"60 - 55*t\"",                                // at the beginning
             "{ keys = [[1, 5], [1.2, 60], [1.4, 5]] }",     // at one frame of 241
             "{ keys = [[3, 5], [3.1, 60]], ease = 'hold' }" // until the end
         }) {
        const formula::CubicSteps moving = steps_of(k[0] == '"' ? 31 : 241, k, "1");
        EXPECT_LE(moving.longest, 2 * still.longest) << k;
        EXPECT_LE(moving.first, 2 * still.first) << k;
    }
}

// In the mean of both frames there are none.
TEST_F(CubicStepsOfScenes, AreNotThoseOfTheMeanOfFrames) {
    EXPECT_LT(steps_of(2, "40", "\"60*t - 1\"").longest, 0.5);
}

} // namespace
} // namespace isomotion::probe
