// No frame of any animation has a pixel that is not a number, nor more than one in a thousand that
// ran out of steps.
#include "gallery/animations.h"
#include "render/drawing.h"

namespace isomotion::render {
namespace {

class GalleryVerdicts : public EveryAnimation {
protected:
    std::unique_ptr<gpu::Context> context = gpu::Context::create();
};
ISOMOTION_ON_EVERY_ANIMATION(GalleryVerdicts);

TEST_P(GalleryVerdicts, AreMissAndHitOnEveryFrame) {
    constexpr int side = 48;
    for (const std::string& name : animations_of(GetParam())) {
        const scene::Scene scene = scene::load(name, {"output.size=[48,48]"});
        Renderer renderer(*context, scene, {side, side, {}, {}});
        std::int64_t most_hits = 0, least_hits = side * side;
        for (int frame = 1; frame <= scene.timeline.frames; ++frame) {
            const Picture picture = renderer.draw(scene::at(scene, scene.timeline.values(frame)));
            EXPECT_EQ(count(picture, Verdict::nan), 0) << name << " frame " << frame;
            EXPECT_LE(count(picture, Verdict::step_limit), side * side / 1000)
                << name << " frame " << frame;
            const std::int64_t hits = count(picture, Verdict::hit);
            most_hits = std::max(most_hits, hits);
            least_hits = std::min(least_hits, hits);
        }
        // Something is there to be seen, and it is framed: neither a speck nor a wall.
        EXPECT_GE(most_hits, side * side / 12) << name;
        EXPECT_LE(least_hits, side * side * 9 / 10) << name;
    }
}

} // namespace
} // namespace isomotion::render
