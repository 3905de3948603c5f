// A ball in the coordinates of a cube: which places these are, and the slopes by them.
#include "topology/field/ball_as_cube.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "topology/field/space_point.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

const SpacePoint centre{0.3, -0.2, 0.1};
constexpr double radius = 1.7;

BallAsCube ball_as_cube() {
    scene::BoundsAt ball;
    ball.centre = {centre[0], centre[1], centre[2]};
    ball.radius = radius;
    return BallAsCube(ball);
}

// By what the map takes the cube's walls to: the sphere, along rays from the middle.
SpacePoint place_of(const SpacePoint& y) {
    double rest = 1, squared = 0;
    for (const double k : y) {
        rest *= 1 - k * k;
        squared += k * k;
    }
    return along(centre, radius / std::sqrt(squared + rest), y);
}

class Chance {
public:
    explicit Chance(unsigned seed)
        : random_(seed) {}
    double in(double low, double high) {
        return low + (high - low) * double(random_()) / double(std::mt19937::max());
    }
    SpacePoint in_cube() { return {in(-1, 1), in(-1, 1), in(-1, 1)}; }
    // Of any size, often at walls, edges and corners, and a little beyond these.
    SpaceBox box() {
        SpaceBox made;
        const double size = std::exp(in(-16, 0)), beyond = in(0, 1) < 0.5 ? 0x1p-20 : 0;
        for (Interval& side : made) {
            const bool is_at_wall = in(0, 1) < 0.4, is_low = in(0, 1) < 0.5;
            const double low = is_at_wall ? (is_low ? -1 : 1 - size) : in(-1, 1 - size);
            side = {low, low + size};
            if (is_at_wall && in(0, 1) < 0.3) side = Interval(is_low ? -1 : 1);
            if (is_at_wall) (is_low ? side.lo : side.hi) += is_low ? -beyond : beyond;
        }
        return made;
    }
    SpacePoint in_box(const SpaceBox& box) {
        SpacePoint p;
        for (std::size_t k = 0; k < 3; ++k) {
            const double end = in(0, 1); // at corners is what is furthest off
            p[k] = end < 0.3 ? box[k].lo : end < 0.6 ? box[k].hi : in(box[k].lo, box[k].hi);
        }
        return p;
    }

private:
    std::mt19937 random_;
};

TEST(BallAsCube, TakesWallsToTheSphereAndNothingElse) {
    Chance chance(1);
    for (int trial = 0; trial < 500; ++trial) {
        SpacePoint y = chance.in_cube();
        EXPECT_LT(distance(place_of(y), centre), radius);
        // Along a ray the distance from the middle rises: it is one to one.
        EXPECT_LT(distance(place_of(along({}, 0.99, y)), centre), distance(place_of(y), centre));
        y[std::size_t(trial) % 3] = trial % 2 == 0 ? 1 : -1;
        EXPECT_NEAR(distance(place_of(y), centre), radius, 1e-12);
        const SpaceBox at = ball_as_cube().place(point_box(y));
        EXPECT_NEAR(distance(middle(at), place_of(y)), 0, 1e-12);
        EXPECT_LT(longest_side(at), 1e-13);
    }
}

TEST(BallAsCube, EnclosesThePlacesOfABox) {
    Chance chance(2);
    for (int trial = 0; trial < 3000; ++trial) {
        const SpaceBox box = chance.box();
        const SpaceBox place = ball_as_cube().place(box);
        SpaceBox found = point_box(place_of(middle(box)));
        for (int corner = 0; corner < 8; ++corner) {
            SpacePoint y;
            for (std::size_t k = 0; k < 3; ++k) y[k] = corner >> k & 1 ? box[k].hi : box[k].lo;
            found = hull_of(found, point_box(place_of(y)));
        }
        for (int point = 0; point < 10; ++point)
            found = hull_of(found, point_box(place_of(chance.in_box(box))));
        for (std::size_t k = 0; k < 3; ++k) {
            constexpr double slack = 1e-14; // the reference is rounded
            EXPECT_TRUE(contains(place[k], Interval(found[k].lo + slack, found[k].hi - slack)))
                << "trial " << trial;
            // Corners are the ends, but for boxes on both sides of 0.
            if (contains(box[0], 0.0) || contains(box[1], 0.0) || contains(box[2], 0.0)) continue;
            EXPECT_NEAR(width(place[k]), width(found[k]), 1e-12) << "trial " << trial;
        }
    }
}

// To more digits than doubles have.
TEST(BallAsCube, EnclosesPlacesOfPoints) {
    Chance chance(5);
    const BallAsCube ball{scene::BoundsAt{}};
    for (int trial = 0; trial < 5000; ++trial) {
        const SpacePoint y = chance.in_cube();
        const SpaceBox at = ball.place(point_box(y));
        long double rest = 1, squared = 0;
        for (const long double k : y) {
            rest *= 1 - k * k;
            squared += k * k;
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const long double place = y[k] / std::sqrt(squared + rest);
            EXPECT_TRUE(at[k].lo <= place && place <= at[k].hi);
            EXPECT_LT(width(at[k]), 1e-14);
        }
    }
}

// A function of places, with its slopes.
double wave(const SpacePoint& p) { return std::sin(1.1 * p[0] + 0.4 * p[1]) + p[1] * p[2] * p[2]; }
SpaceBox gradient_at(const SpacePoint& p) {
    const double c = std::cos(1.1 * p[0] + 0.4 * p[1]);
    return {1.1 * c, 0.4 * c + p[2] * p[2], 2 * p[1] * p[2]};
}
SpaceHessian hessian_at(const SpacePoint& p) {
    const double s = -std::sin(1.1 * p[0] + 0.4 * p[1]);
    return {{{1.21 * s, 0.44 * s, 0.0}, {0.44 * s, 0.16 * s, 2 * p[2]}, {0.0, 2 * p[2], 2 * p[1]}}};
}

double of_cube(const SpacePoint& y) { return wave(place_of(y)); }
SpacePoint moved(SpacePoint y, std::size_t k, double by) {
    y[k] += by;
    return y;
}

TEST(BallAsCube, HasTheSlopesOfAFunctionOfPlaces) {
    Chance chance(3);
    for (int trial = 0; trial < 300; ++trial) {
        const SpacePoint y = chance.in_cube(), p = place_of(y);
        const BallAsCube::Slopes slopes = ball_as_cube().slopes(point_box(y));
        const SpaceBox gradient = slopes.gradient(gradient_at(p));
        const SpaceHessian hessian = slopes.hessian(gradient_at(p), hessian_at(p));
        constexpr double h = 1e-3;
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_LT(width(gradient[k]), 1e-12);
            EXPECT_NEAR(mid(gradient[k]),
                        (of_cube(moved(y, k, h)) - of_cube(moved(y, k, -h))) / (2 * h), 2e-5);
            for (std::size_t l = 0; l < 3; ++l) {
                const auto across = [&](double by) {
                    const SpacePoint there = moved(y, l, by);
                    return (of_cube(moved(there, k, h)) - of_cube(moved(there, k, -h))) / (2 * h);
                };
                EXPECT_LT(width(hessian[k][l]), 1e-11);
                EXPECT_NEAR(mid(hessian[k][l]), (across(h) - across(-h)) / (2 * h), 2e-4)
                    << "trial " << trial << ", " << k << " " << l;
            }
        }
    }
}

// What holds over a box of the cube holds what is at its points.
TEST(BallAsCube, EnclosesSlopesOverBoxes) {
    Chance chance(4);
    const SpacePoint slope{0.7, -0.4, 0.5};
    for (int trial = 0; trial < 3000; ++trial) {
        const SpaceBox box = chance.box();
        const auto over = ball_as_cube().slopes(box);
        const SpaceBox gradient = over.gradient(point_box(slope));
        const SpaceHessian hessian = over.hessian(point_box(slope), {});
        const auto at = ball_as_cube().slopes(point_box(chance.in_box(box)));
        const SpaceBox gradient_there = at.gradient(point_box(slope));
        const SpaceHessian hessian_there = at.hessian(point_box(slope), {});
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_TRUE(contains(gradient[k], mid(gradient_there[k]))) << "trial " << trial;
            for (std::size_t l = 0; l < 3; ++l)
                EXPECT_TRUE(contains(hessian[k][l], mid(hessian_there[k][l]))) << "trial " << trial;
        }
    }
}

} // namespace
} // namespace isomotion::topology
