#include "formula/graph/walls.h"

#include <cmath>

#include <fmt/format.h>

#include "formula/graph/derivative.h"
#include "testing.h"

namespace isomotion::formula::walls_test {
namespace {

constexpr double distance = 0x1p-15;

Point gradient_at(const std::string& text, const Point& p) {
    Graph graph;
    const NodeId root = parse(graph, text);
    const std::array<NodeId, 3> gradient = wall_gradient(graph, root, distance);
    Point slopes;
    for (std::size_t k = 0; k < 3; ++k) slopes[k] = value_of(graph, gradient[k], p);
    return slopes;
}

Point normal_at(const std::string& text, const Point& p) {
    Point g = gradient_at(text, p);
    const double length = std::hypot(g[0], g[1], g[2]);
    for (double& slope : g) slope /= length;
    return g;
}

testing::Matcher<Point> is_near(const Point& wanted, double tolerance = 1e-6) {
    using testing::DoubleNear;
    return testing::ElementsAre(DoubleNear(wanted[0], tolerance), DoubleNear(wanted[1], tolerance),
                                DoubleNear(wanted[2], tolerance));
}

struct Wall {
    const char* formula;
    Point at, normal; // towards larger F
};

TEST(Walls, HaveTheNormalOfWhatJumps) {
    const double half = std::sqrt(0.5);
    for (const Wall& wall : {
             Wall{"sign(x - 0.25)", {0.25, 3, -2}, {1, 0, 0}},
             Wall{"3 - 5*sign(x - 0.25)", {0.25, 3, -2}, {-1, 0, 0}},
             Wall{"floor(2*x) - 0.5", {0.5, 0.3, 0.1}, {1, 0, 0}},
             Wall{"0.5 - floor(2*x + 2*y)", {0.25, 0.25, 7}, {-half, -half, 0}},
             Wall{"1/(z - 1)", {0.3, 0.2, 1}, {0, 0, 1}},
             Wall{"2 - (z - 1)^-3", {0.3, 0.2, 1 + 1e-6}, {0, 0, -1}},
             Wall{"sign(x^2 + y^2 - 25)", {3, 4, 1}, {0.6, 0.8, 0}},
             // The nearer of two.
             Wall{"sign(x) + sign(y)", {0, 0.01, 0}, {1, 0, 0}},
             Wall{"sign(x) - 3*sign(y)", {0.01, 0, 0}, {0, -1, 0}},
             Wall{"sum(blobs, sign(z - 9)) - 1", {1, 1, 9}, {0, 0, 1}},
         }) {
        EXPECT_THAT(normal_at(wall.formula, wall.at), is_near(wall.normal, 1e-3)) << wall.formula;
    }
}

// On either side of the wall, and on it, wherever it lies.
TEST(Walls, RandomPlanes) {
    constexpr std::uint64_t seed = 23;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    for (int k = 0; k < 200; ++k) {
        Point normal = random.point(1);
        const double length = std::hypot(normal[0], normal[1], normal[2]);
        for (double& n : normal) n /= length;
        const double offset = random.in(-2, 2), way = random.below(2) ? 1 : -1;
        const std::string text = fmt::format("{}*sign({}*x + {}*y + {}*z - {}) + 0.001*x*y", way,
                                             normal[0], normal[1], normal[2], offset);
        const double aside = random.in(-0.4, 0.4) * distance;
        const Point p{normal[0] * (offset + aside), normal[1] * (offset + aside),
                      normal[2] * (offset + aside)};
        EXPECT_THAT(normal_at(text, p),
                    is_near({way * normal[0], way * normal[1], way * normal[2]}))
            << text;
    }
}

TEST(Walls, TheGradientFartherOff) {
    constexpr std::uint64_t seed = 24;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    for (int k = 0; k < 100; ++k) {
        const Point p{random.in(0.1, 0.9), random.point(2)[1], random.point(2)[2]};
        EXPECT_THAT(gradient_at("x^2*y + z*floor(x) + sign(x)*z^2", p),
                    is_near({2 * p[0] * p[1], p[0] * p[0], 2 * p[2]}));
    }
    EXPECT_THAT(gradient_at("x^2 + 3*y", {0, 0, 0}), is_near({0, 3, 0})); // nothing jumps
}

} // namespace
} // namespace isomotion::formula::walls_test
