// The sheet of pictures that the gallery opens with shows every installed animation in its place.
#include "player/ui/gallery_sheet.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "image/decode.h"
#include "render/drawing.h"
#include "scene/data_folder.h"
#include "scene/reading/load.h"

namespace isomotion::player {
namespace {

constexpr int side = gallery_sheet::side;
const char* const colors[] = {"R", "G", "B"};

TEST(GallerySheet, HasAPlaceForEveryAnimation) {
    const image::Frame sheet = image::decode(scene::media_file("gallery.png"));
    EXPECT_EQ((std::array{sheet.width, sheet.height}),
              gallery_sheet::size(scene::animation_names().size()))
        << "tools/gallery draws the sheet";
}

// The mean difference between a picture of the sheet, without its rim, and the animation's poster.
double difference(const image::Frame& sheet, std::size_t picture, const image::Frame& poster) {
    constexpr int rim = 8;
    const auto [left, top] = gallery_sheet::corner(picture);
    double sum = 0;
    for (const char* color : colors) {
        const auto &there = sheet.find(color)->samples, &here = poster.find(color)->samples;
        for (int y = rim; y < side - rim; ++y) {
            for (int x = rim; x < side - rim; ++x) {
                const auto of_sheet = std::size_t((top + y) * sheet.width + left + x);
                sum += std::abs(double(there[of_sheet]) - double(here[std::size_t(y * side + x)]));
            }
        }
    }
    return sum / (3 * (side - 2 * rim) * (side - 2 * rim));
}

TEST(GallerySheet, ShowsThePosterInEachPlace) {
    const image::Frame sheet = image::decode(scene::media_file("gallery.png"));
    const auto names = scene::animation_names();
    const auto context = gpu::Context::create();
    for (const char* name : {"barth_sextic", "heart", "torus", "wyvill_soft_objects"}) {
        const auto at = std::size_t(std::ranges::find(names, name) - names.begin());
        ASSERT_LT(at, names.size()) << name;
        const scene::Scene scene = scene::load(name, {"output.size=[128,128]", "output.samples=4"});
        render::Renderer renderer(*context, scene, {side, side, {}, {}});
        const image::Frame poster =
            renderer.draw(scene::at_frame(scene, scene.output.poster)).frame;
        EXPECT_LE(difference(sheet, at, poster), 0.02) << name;
        EXPECT_GE(difference(sheet, (at + 1) % names.size(), poster), 0.04) << name;
    }
}

} // namespace
} // namespace isomotion::player
