// What a timeline is of: its fingerprint changes with the surface and with nothing else.
#include "topology/timeline/timeline_header.h"

#include <fstream>

#include <gmock/gmock.h>

#include "scene/reading/load.h"
#include "unit/image/places.h"

namespace isomotion::topology {
namespace {

class SubjectOf : public testing::Test {
protected:
    SubjectOf() {
        std::ofstream(folder_ / "blobs.toml") << R"toml(title = "Blobs"
[time]
fps = 25
frames = 50
[surface]
formula = "sum(blobs, exp(-((x-cx)^2 + y^2 + z^2)/r^2)) - level"
bounds = { box = [[-2, -2, -2], [2, 2, "2 + 0.01*t"]] }
[parameters]
level = "0.5*speed"
speed = "0.1 + t"
[arrays.blobs]
count = 3
cx = "i - 1 + 0*random(i, 1)"
r = 0.5
[camera]
position = [9, "t", 0]
[[lights]]
direction = [1, 1, 1]
)toml";
    }
    scene::Scene load(const std::vector<scene::Override>& settings = {}) const {
        return scene::load((folder_ / "blobs.toml").string(), settings);
    }

    image::TemporaryFolder folder_;
};

TEST_F(SubjectOf, TheFingerprintKnowsWhatMovesTheSurface) {
    const std::string plain = fingerprint(load());
    EXPECT_EQ(plain, fingerprint(load()));
    EXPECT_EQ(plain.size(), 32u);
    for (const char* setting :
         {"level=0.5*speed+0", "speed=0.2", "arrays.blobs.r=0.6", "arrays.blobs.count=4",
          "arrays.blobs.cx=i", "time.seed=1", "surface.bounds={box=[[-2,-2,-2],[2,2,3]]}",
          "surface.bounds={sphere=3}",
          "surface.formula=\"sum(blobs, exp(-((x-cx)^2+y^2+z^2)/r^2))-level\""}) {
        EXPECT_NE(fingerprint(load({setting})), plain) << setting;
    }
}

TEST_F(SubjectOf, TheFingerprintKnowsNothingElse) {
    const std::string plain = fingerprint(load());
    for (const char* setting :
         {"camera.fov=20", "camera.position=[1,2,9]", "time.frames=99", "output.size=[9,9]",
          "surface.transform={scale=2}", "isolation.step=0.01"}) {
        EXPECT_EQ(fingerprint(load({setting})), plain) << setting;
    }
}

TEST_F(SubjectOf, BoundsAreThoseOfBothEnds) {
    const TimelineHeader header = header_of(load(), {0, 2});
    EXPECT_EQ(header.title, "Blobs");
    EXPECT_EQ(header.fps, (animation::FrameRate{25, 1}));
    EXPECT_EQ(header.shape, scene::Bounds::Shape::box);
    EXPECT_EQ(header.start_bounds[2], formula::Interval(-2, 2));
    EXPECT_EQ(header.end_bounds[2], formula::Interval(-2, 2.02));
    const TimelineHeader ball = header_of(load({"surface.bounds={sphere=3}"}), {0, 2});
    EXPECT_EQ(ball.shape, scene::Bounds::Shape::sphere);
    EXPECT_EQ(ball.end_bounds[1], formula::Interval(-3, 3));
}

} // namespace
} // namespace isomotion::topology
