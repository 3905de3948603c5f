// Elements from a file, drawn: as many as there are at a time, none included.
#include "render/drawing.h"
#include "unit/image/places.h"

namespace isomotion::render {
namespace {

class DrawnElements : public Drawing {
protected:
    // Spheres of radius 0.3 about the drops of a table, seen along the x axis.
    scene::Scene spheres(const std::string& table) const {
        std::ofstream(folder_ / "drops.csv") << table;
        std::ofstream(folder_ / "scene.toml") << R"(
[time]
fps = 10
frames = 4
[surface]
formula = "sum(drops, exp(-40*(x^2 + (y-cy)^2 + (z-cz)^2 - 0.09))) - 1"
bounds = { sphere = 2 }
[arrays.drops]
file = "drops.csv"
count = 9
[camera]
position = [5, 0, 0]
projection = "orthographic"
height = 4
[output]
size = [80, 80]
)";
        return scene::load((folder_ / "scene.toml").string());
    }
    image::TemporaryFolder folder_;
};
ISOMOTION_ON_EVERY_BACKEND(DrawnElements);

TEST_P(DrawnElements, AreThoseOfTheFrame) {
    const scene::Scene scene = spheres("frame,cy,cz\n1,-1,0\n2,-1,0\n2,1,0\n2,0,1\n3,,\n4,1,1\n");
    Renderer renderer(*context, scene, {80, 80, every_channel, {}});
    const auto draw_frame = [&](int frame) { return renderer.draw(scene::at_frame(scene, frame)); };
    const auto hits = [&](int frame) { return count(draw_frame(frame), Verdict::hit); };
    const std::int64_t one = hits(1);
    EXPECT_NEAR(double(one), M_PI * 6 * 6, 12); // a disc of six pixels' radius
    EXPECT_NEAR(double(hits(2)), 3.0 * double(one), 6);
    const Picture none = draw_frame(3);
    EXPECT_EQ(count(none, Verdict::miss), 80 * 80);
    EXPECT_NEAR(double(hits(4)), double(one), 6);
    // Frame 4 alone is frame 4 after the others: nothing of them is left in the buffers.
    Renderer fresh(*context, scene, {80, 80, every_channel, {}});
    EXPECT_TRUE(same_bits(fresh.draw(scene::at_frame(scene, 4)).frame, draw_frame(4).frame));
}

TEST_P(DrawnElements, AChangedFileIsAnotherPicture) {
    const auto print = [&](const std::string& table) {
        const scene::Scene scene = spheres(table);
        Renderer renderer(*context, scene, {80, 80, {}, {}});
        return renderer.prepare(scene, 1).fingerprint;
    };
    const std::string first = print("cy,cz\n0,0\n");
    EXPECT_EQ(print("cy,cz\n0,0\n"), first);
    EXPECT_NE(print("cy,cz\n0,0.001\n"), first);
    EXPECT_NE(print("cy,cz\n0,0\n0,0\n"), first);
}

} // namespace
} // namespace isomotion::render
