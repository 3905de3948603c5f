// One frame of every animation, as it was looked at. ISOMOTION_BLESS=1 writes them anew, to be
// looked at again before they are committed; hits_test.cpp checks what they show.
//
// Pixels on a silhouette may fall to either side on another processor: the software renderer makes
// its code for the one it runs on.
#include <cstdlib>

#include "base/file.h"
#include "gallery/animations.h"
#include "image/decode.h"
#include "image/encode.h"
#include "render/drawing.h"
#include "unit/image/compare.h"

namespace isomotion::render {
namespace {

class GalleryReference : public EveryAnimation {
protected:
    std::unique_ptr<gpu::Context> context = gpu::Context::create();
};
ISOMOTION_ON_EVERY_ANIMATION(GalleryReference);

TEST_P(GalleryReference, PostersLookAsTheyDid) {
    const auto folder = std::filesystem::path(ISOMOTION_SOURCE_DIR) / "tests/gallery/reference";
    for (const std::string& name : animations_of(GetParam())) {
        SCOPED_TRACE(name);
        const scene::Scene scene = scene::load(name, {"look=none", "output.size=[96,96]"});
        image::Frame drawn = draw(*context, scene, scene.output.poster).frame;
        drawn.channels.resize(4); // R G B A: what a PNG holds
        const auto file = folder / (name + ".png");
        if (std::getenv("ISOMOTION_BLESS")) {
            base::write_whole(file, image::encode(drawn, image::Format::png8));
        }
        ASSERT_TRUE(std::filesystem::exists(file));
        const auto shown = std::filesystem::temp_directory_path() /
                           ("isomotion-poster-" + std::to_string(getpid()) + ".png");
        base::write_whole(shown, image::encode(drawn, image::Format::png8));
        // Both are 8 bits of sRGB, decoded to linear light: one step is at most 0.009.
        const image::Comparison difference =
            image::compare(image::decode(file), image::decode(shown), 0.02);
        std::filesystem::remove(shown);
        ASSERT_TRUE(difference.same_size);
        ASSERT_TRUE(difference.only_in_first.empty() && difference.only_in_second.empty());
        for (const auto& channel : difference.channels) {
            EXPECT_LE(channel.over_tolerance, 40u) << channel.name; // of 9216
            EXPECT_LE(channel.mean, 0.002) << channel.name;
            EXPECT_EQ(channel.not_finite, 0u) << channel.name;
        }
    }
}

TEST(GalleryReferences, AreThoseOfTheAnimationsThereAre) {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(
             std::filesystem::path(ISOMOTION_SOURCE_DIR) / "tests/gallery/reference")) {
        found.push_back(entry.path().stem().string());
    }
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, scene::animation_names());
}

} // namespace
} // namespace isomotion::render
