// Charts of a sphere: each point is in one's own part, and what they say of the surface is what the
// surface is there.
#include "topology/field/sphere_chart.h"

#include <random>

#include "topology/moving.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

std::vector<SpacePoint> directions() {
    std::vector<SpacePoint> all;
    for (const double x : {-1.0, 0.0, 1.0}) { // edges and corners of charts
        for (const double y : {-1.0, 0.0, 1.0}) {
            for (const double z : {-1.0, 0.0, 1.0}) {
                if (x != 0 || y != 0 || z != 0) all.push_back({x, y, z});
            }
        }
    }
    std::mt19937 random(27);
    std::normal_distribution<double> number;
    for (int k = 0; k < 500; ++k) all.push_back({number(random), number(random), number(random)});
    return all;
}

TEST(SphereChart, HasEachDirectionInSomeOwnPart) {
    for (const SpacePoint& p : directions()) {
        int own = 0;
        for (const SphereChart& chart : SphereChart::all()) {
            const auto at = chart.coordinates(point_box(p));
            if (!at) continue;
            const auto [u, v] = *at;
            own += !SphereChart::is_beyond(u, v);
            // There and back.
            const SpaceBox back = chart.direction(u, v);
            const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
            for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(middle(back[k]), p[k] / length, 1e-12);
        }
        EXPECT_GE(own, 1) << p[0] << " " << p[1] << " " << p[2];
        EXPECT_LE(own, 3);
    }
}

TEST(SphereChart, IsNotAheadOfWhatMayBeBehind) {
    const SphereChart up(2, true), down(2, false);
    const SpaceBox flat{Interval(1), Interval(0), Interval(-0.1, 0.1)};
    EXPECT_FALSE(up.coordinates(flat));
    EXPECT_FALSE(down.coordinates(flat));
    EXPECT_FALSE(up.coordinates(point_box({0, 0, -1})));
    EXPECT_TRUE(down.coordinates(point_box({0, 0, -1})));
}

// A sphere that moves and grows over a surface that moves: in each chart the field is that of the
// places in space, and its slope inwards along the radius.
TEST(SphereChart, MovesWithTheSphere) {
    const Moving moving{"sum(blobs, exp(-((x - cx)^2 + (y - cy)^2 + (z - cz)^2))) - T*x*y",
                        "{ sphere = \"1 + t/2\", centre = [\"0.3*t\", -0.2, 0.1] }",
                        "T = \"0.2 + t\"",
                        "[arrays.blobs]\ncount = 4\ncx = \"cos(i)\"\ncy = \"sin(i)*t\"\ncz = 0.1"};
    const Motions all = motions(moving.scene(), Side::positive, {0, 1}, Clock::time);
    ASSERT_EQ(all.pieces.size(), 1u);
    const Motion& in_space = all.pieces[0];
    const MovingField field(in_space, {});
    Enclosures inside(field);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> number(-1, 1);
    for (const SphereChart& chart : SphereChart::all()) {
        const Motion motion = chart.motion(in_space);
        const MovingField wall(motion, SphereChart::wall());
        Enclosures on_wall(wall);
        SpherePlaces places(in_space, chart);
        for (int k = 0; k < 50; ++k) {
            const double u = number(random), v = number(random), t = (1 + number(random)) / 2;
            const Box here{u, v, t};
            const SpaceBox place = places.at(u, v, t);
            const Box there{place[0], place[1], place[2], t};
            EXPECT_EQ(on_wall.place(here), Enclosures::Place::inside);
            EXPECT_EQ(inside.place(there), Enclosures::Place::unknown) << "it is on the sphere";
            const Jet<Interval> a = on_wall.jet(here), b = inside.jet(there);
            EXPECT_NEAR(middle(a.value), middle(b.value), 1e-12);
            const SpaceBox direction = chart.direction(u, v);
            double along = 0;
            for (std::size_t i = 0; i < 3; ++i)
                along += middle(b.gradient[i]) * middle(direction[i]);
            EXPECT_NEAR(middle(on_wall.inward(here)[0]), -along * (1 + t / 2), 1e-12);
        }
    }
}

} // namespace
} // namespace isomotion::topology
