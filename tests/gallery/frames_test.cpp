// Every frame of every animation, small: no pixel that is not a number, at most one in a thousand
// that ran out of steps, and loops that close.
#include "gallery/animations.h"
#include "render/drawing.h"

namespace isomotion::render {
namespace {

class GalleryFrames : public EveryAnimation {
protected:
    std::unique_ptr<gpu::Context> context = gpu::Context::create();
};
ISOMOTION_ON_EVERY_ANIMATION(GalleryFrames);

constexpr int side = 48;

// How much two pictures differ: the mean over all pixels and colours.
double difference(const image::Frame& a, const image::Frame& b) {
    double sum = 0;
    for (const char* name : {"R", "G", "B"}) {
        const auto &x = a.find(name)->samples, &y = b.find(name)->samples;
        for (std::size_t k = 0; k < x.size(); ++k) sum += std::abs(double(x[k]) - double(y[k]));
    }
    return sum / (3 * side * side);
}

TEST_P(GalleryFrames, AreMissesAndHitsAndLoopsClose) {
    for (const std::string& name : animations_of(GetParam())) {
        SCOPED_TRACE(name);
        const scene::Scene scene = scene::load(name, {"look=none", "output.size=[48,48]"});
        const int frames = scene.timeline.frames;
        Renderer renderer(*context, scene, {side, side, {}, {}});
        std::int64_t most_hits = 0, least_hits = side * side;
        double largest_change = 0;
        image::Frame first, last;
        for (int frame = 1; frame <= frames; ++frame) {
            const Picture picture = renderer.draw(scene::at_frame(scene, frame));
            EXPECT_EQ(count(picture, Verdict::nan), 0) << "frame " << frame;
            EXPECT_LE(count(picture, Verdict::step_limit), side * side / 1000) << "frame " << frame;
            most_hits = std::max(most_hits, count(picture, Verdict::hit));
            least_hits = std::min(least_hits, count(picture, Verdict::hit));
            if (frame == 1) {
                first = picture.frame;
            } else {
                largest_change = std::max(largest_change, difference(last, picture.frame));
            }
            last = picture.frame;
        }
        // Something is there to be seen, and it is framed: neither a speck nor a wall.
        EXPECT_GE(most_hits, side * side / 12);
        EXPECT_LE(least_hits, side * side * 9 / 10);
        EXPECT_GT(largest_change, 0) << "nothing moves";
        if (!scene.timeline.loops) continue;
        // The step from the last frame to the first is one like the others, and the frame after the
        // last is the first but for rounding (a turn by a symmetry of the surface may close it).
        EXPECT_LE(difference(last, first), 1.5 * largest_change);
        const auto after = renderer.draw(scene::at_frame(scene, frames + 1));
        EXPECT_LE(difference(after.frame, first), 0.001);
    }
}

} // namespace
} // namespace isomotion::render
