// Pictures that were looked at. They pin what no closed form does; ISOMOTION_BLESS=1 writes them
// anew, to be looked at again before they are committed.
//
// Pixels on a silhouette may fall to either side on another processor: the software renderer makes
// its code for the one it runs on.
#include "base/file.h"
#include "image/decode.h"
#include "image/encode.h"
#include "render/drawing.h"
#include "unit/image/compare.h"

#include <cstdlib>

#include <gtest/gtest.h>

namespace isomotion::render {
namespace {

class Reference : public Drawing {};
ISOMOTION_ON_EVERY_BACKEND(Reference);

TEST_P(Reference, GalleryFramesLookAsTheyDid) {
    const std::filesystem::path folder =
        std::filesystem::path(ISOMOTION_SOURCE_DIR) / "tests/render/reference";
    for (const auto& [name, frame] :
         std::vector<std::pair<std::string, int>>{{"blobby75", 1},
                                                  {"blobby75", 31},
                                                  {"blobby75", 61},
                                                  {"twisting_superquadric", 1},
                                                  {"twisting_superquadric", 31}}) {
        const auto file = folder / (name + "." + std::to_string(frame) + ".png");
        SCOPED_TRACE(file.filename().string());
        const scene::Scene scene = scene::load(name, {"look=none", "output.size=[96,96]"});
        const Picture picture = draw(*context, scene, frame);
        image::Frame drawn = picture.frame;
        drawn.channels.resize(4); // R G B A: what a PNG holds
        if (std::getenv("ISOMOTION_BLESS")) {
            base::write_whole(file, image::encode(drawn, image::Format::png8));
        }
        // Both are 8 bits of sRGB, decoded to linear light: one step is at most 0.009.
        const image::Frame expected = image::decode(file);
        const auto shown = std::filesystem::temp_directory_path() /
                           ("isomotion-shown-" + std::to_string(getpid()) + ".png");
        base::write_whole(shown, image::encode(drawn, image::Format::png8));
        const image::Comparison difference = image::compare(expected, image::decode(shown), 0.02);
        std::filesystem::remove(shown);
        ASSERT_TRUE(difference.same_size);
        ASSERT_TRUE(difference.only_in_first.empty() && difference.only_in_second.empty());
        for (const auto& channel : difference.channels) {
            EXPECT_LE(channel.over_tolerance, 20u) << channel.name;
            EXPECT_LE(channel.mean, 0.002) << channel.name;
            EXPECT_EQ(channel.not_finite, 0u) << channel.name;
        }
        EXPECT_EQ(count(picture, Verdict::nan) + count(picture, Verdict::step_limit), 0);
    }
}

} // namespace
} // namespace isomotion::render
