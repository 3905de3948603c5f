// Curvatures against closed forms.
#include "formula/curvature.h"

#include <cmath>

#include "formula/hessian.h"
#include "testing.h"

namespace isomotion::formula {
namespace {

Curvatures curvatures_of(const std::string& text, const Point& p) {
    const Field field = make_field(text, {});
    std::array<double, 6> second{};
    const Program program = hessian(field);
    Evaluator<double>(program).point({}, p, second);
    return curvatures(FieldEvaluator<double>(field).gradient({}, p), second);
}

void expect_curvatures(const std::string& text, const Point& p, double mean, double gaussian) {
    SCOPED_TRACE(text + " at " + testing::PrintToString(p));
    const Curvatures c = curvatures_of(text, p);
    EXPECT_NEAR(c.mean, mean, 1e-12 * (1 + std::abs(mean)));
    EXPECT_NEAR(c.gaussian, gaussian, 1e-12 * (1 + std::abs(gaussian)));
}

TEST(Curvature, OfAVanishingGradientIsNoNumber) {
    const Curvatures apex = curvatures_of("x^2 + y^2 - z^2", {0, 0, 0});
    EXPECT_TRUE(std::isnan(apex.mean) && std::isnan(apex.gaussian));
}

TEST(Curvature, OfAPlaneIsZero) { expect_curvatures("x - 2*y + z/3", {1, 2, 3}, 0, 0); }

TEST(Curvature, OfSpheresIsOneByTheRadiusWhereTheyBendAwayFromTheRisingSide) {
    constexpr std::uint64_t seed = 31;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    for (const double r : {1e-3, 0.5, 1.0, 7.0}) {
        const std::string square = std::to_string(r) + "^2";
        std::vector<Point> points{{r, 0, 0}, {0, -r, 0}, {0, 0, r}};
        for (int k = 0; k < 20; ++k) {
            Point p = random.point(1);
            const double length = std::hypot(p[0], p[1], p[2]);
            for (double& c : p) c *= r / length;
            points.push_back(p);
        }
        for (const Point& p : points) {
            expect_curvatures("x^2 + y^2 + z^2 - " + square, p, 1 / r, 1 / (r * r));
            expect_curvatures(square + " - x^2 - y^2 - z^2", p, -1 / r, 1 / (r * r));
            // Another field of the same surface has the same.
            expect_curvatures("1e9*(sqrt(x^2 + y^2 + z^2) - " + std::to_string(r) + ")", p, 1 / r,
                              1 / (r * r));
        }
    }
}

TEST(Curvature, OfACylinderIsHalfOfItsCircles) {
    for (const double angle : {0.0, 0.7, 2.0, 5.5}) {
        expect_curvatures("x^2 + y^2 - 4", {2 * std::cos(angle), 2 * std::sin(angle), 3}, 0.25, 0);
        expect_curvatures("z^2 + y^2 - 4", {3, 2 * std::cos(angle), 2 * std::sin(angle)}, 0.25, 0);
    }
}

// z = x y: K = -1/(1 + x^2 + y^2)^2 and H = x y/(1 + x^2 + y^2)^(3/2).
TEST(Curvature, OfASaddle) {
    expect_curvatures("z - x*y", {0, 0, 0}, 0, -1);
    for (const auto& [x, y] : {std::pair{1.0, 0.0}, {0.5, -2.0}, {3.0, 3.0}}) {
        const double w = 1 + x * x + y * y;
        expect_curvatures("z - x*y", {x, y, x * y}, x * y / std::pow(w, 1.5), -1 / (w * w));
    }
}

// R = 2, r = 1/2: at the angle v around the tube K = cos v / (r (R + r cos v)) and
// 2 H = 1/r + cos v / (R + r cos v).
TEST(Curvature, OfATorusChangesSignFromOutsideToInside) {
    const std::string torus = "(sqrt(x^2 + y^2) - 2)^2 + z^2 - 0.25";
    for (int k = 0; k < 16; ++k) {
        const double v = 2 * M_PI * k / 16, u = 0.3 + k;
        const double from_axis = 2 + 0.5 * std::cos(v);
        const Point p{from_axis * std::cos(u), from_axis * std::sin(u), 0.5 * std::sin(v)};
        const double around = std::cos(v) / from_axis;
        expect_curvatures(torus, p, (2 + around) / 2, 2 * around);
    }
}

// Scherk's and the catenoid: minimal surfaces.
TEST(Curvature, OfMinimalSurfacesHasNoMean) {
    for (const auto& [x, y] : {std::pair{0.1, 0.2}, {-0.7, 1.1}, {1.2, 0.0}}) {
        const Point p{x, y, std::log(std::cos(x) / std::cos(y))};
        EXPECT_NEAR(curvatures_of("exp(z)*cos(y) - cos(x)", p).mean, 0, 1e-12);
        EXPECT_LT(curvatures_of("exp(z)*cos(y) - cos(x)", p).gaussian, 0);
        const double r = std::cosh(x);
        EXPECT_NEAR(
            curvatures_of("y^2 + z^2 - cosh(x)^2", {x, r * std::cos(y), r * std::sin(y)}).mean, 0,
            1e-12);
    }
}

} // namespace
} // namespace isomotion::formula
