// March and picture in one draw, or in passes: the same picture.
#include "render/drawing.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scene/reading/load.h"

namespace isomotion::render {
namespace {

class OneDraw : public Drawing {};
ISOMOTION_ON_EVERY_BACKEND(OneDraw);

// Once a ray has not ended in one draw, pictures after it go through passes: nothing shows.
TEST_P(OneDraw, TheNextFrameIsTheSameByEither) {
    // With a uniform of its own: the colour of the other side.
    const scene::Scene scene = scene::load("barth_sextic", {"look=none", "output.size=[40,30]"});
    const auto now = [&](int frame) { return scene::at_frame(scene, frame); };
    Renderer renderer(*context, scene, {40, 30, every_channel, MarchPlan{40, 30, 4}});
    const Picture first = renderer.draw(now(1)), again = renderer.draw(now(1));
    EXPECT_GT(again.passes, 1);
    EXPECT_EQ(first.passes, again.passes + 1); // the draw that did not suffice
    EXPECT_TRUE(same_bits(first.frame, again.frame));
    EXPECT_EQ(first.verdicts, again.verdicts);
    EXPECT_EQ(first.evaluations(), again.evaluations());
}

// Hardware is asked for all at once, software renderers part by part: of plain scenes with and
// without beams, of several tiles, and of scenes with passes.
TEST_P(OneDraw, IsReadBackTheSameAtOnceAndInParts) {
    for (const char* name : {"goursat", "chmutov_8", "superquadric", "chmutov_12_two_lights"}) {
        for (const bool tiles : {false, true}) {
            SCOPED_TRACE(fmt::format("{}{}", name, tiles ? " in tiles" : ""));
            const scene::Scene scene = scene::load(name, {"look=none", "output.size=[301,173]"});
            const auto read = [&](bool at_once) {
                RenderOptions options{301, 173, every_channel};
                if (tiles) options.plan = MarchPlan{128, 64, 60'000};
                options.reads_at_once = at_once;
                Renderer renderer(*context, scene, options);
                return renderer.draw(scene::at_frame(scene, 2));
            };
            const Picture at_once = read(true), in_parts = read(false);
            EXPECT_GT(count(at_once, Verdict::hit), 1000);
            EXPECT_TRUE(same_bits(at_once.frame, in_parts.frame));
            EXPECT_EQ(at_once.verdicts, in_parts.verdicts);
            EXPECT_EQ(at_once.evaluations(), in_parts.evaluations());
        }
    }
}

} // namespace
} // namespace isomotion::render
