#include <cmath>
#include <random>

#include "api/error_code.h"

namespace isomotion {
namespace {

TEST(Formula, HasValuesAndGradientsOfClosedForms) {
    const Formula ball("x^2 + 2*y^2 + z^2 = r^2", {{"r", 2.0}});
    EXPECT_DOUBLE_EQ(ball.value({1, 1, 1}), 0);
    EXPECT_EQ(ball.gradient({1, 1, 3}), (Point{2, 4, 6}));
    EXPECT_DOUBLE_EQ(ball.with("r", 1).value({1, 1, 1}), 3);
    EXPECT_DOUBLE_EQ(ball.value({1, 1, 1}), 0); // it has not changed
    EXPECT_EQ(ball.with("r", 5).parameters().at("r"), 5);
}

TEST(Formula, StaysWhereItIsMovedFrom) {
    Formula from("x - 1");
    const Formula to = std::move(from);
    EXPECT_EQ(to.value({3, 0, 0}), 2);
    EXPECT_EQ(from.value({3, 0, 0}), 2); // NOLINT(bugprone-use-after-move)
}

TEST(Formula, HasTheValuesOfSinglePointsAtMany) {
    const Formula wave("z - a*sin(3*x)*cos(2*y)", {{"a", 0.3}});
    std::mt19937 random(4);
    std::uniform_real_distribution<double> coordinate(-2, 2);
    std::vector<Point> points(1001);
    for (Point& point : points)
        point = {coordinate(random), coordinate(random), coordinate(random)};
    const std::vector<double> values = wave.values(points);
    ASSERT_EQ(values.size(), points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
        const auto [x, y, z] = points[k];
        EXPECT_NEAR(values[k], z - 0.3 * std::sin(3 * x) * std::cos(2 * y), 1e-14);
    }
    EXPECT_TRUE(wave.values({}).empty());
}

TEST(Formula, BoundsHoldAllValuesOfTheirBoxes) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> coordinate(-2, 2), part(0, 1);
    for (const char* text : {"x*y - z^3", "sqrt(x^2 + y^2) - abs(z)", "max(sin(4*x), y) + exp(z)",
                             "floor(2*x) + y*z", "x/(0.1 + y^2)"}) {
        const Formula formula(text);
        SCOPED_TRACE(text);
        for (int k = 0; k < 100; ++k) {
            Box box;
            Point inside;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double a = coordinate(random), b = a + part(random);
                box[axis] = {a, b};
                inside[axis] = a + part(random) * (b - a);
            }
            const Interval bound = formula.bound(box);
            const double value = formula.value(inside);
            EXPECT_LE(bound.low, value);
            EXPECT_GE(bound.high, value);
        }
    }
}

TEST(Formula, HasNoBoundsWhereItHasNoValue) {
    const Interval bound = Formula("1/x").bound({{{-1, 1}, {0, 0}, {0, 0}}});
    EXPECT_EQ(bound.low, -INFINITY);
    EXPECT_EQ(bound.high, INFINITY);
}

TEST(Formula, TellsMistakes) {
    const Told unknown = told([] { Formula("x^2 + q"); });
    EXPECT_EQ(unknown.code, Error::Code::formula);
    EXPECT_NE(unknown.words.find("'q'"), std::string::npos) << unknown.words;
    EXPECT_EQ(told([] { Formula("x +"); }).code, Error::Code::formula);
    EXPECT_EQ(told([] { Formula("x - r", {{"x", 1.0}}); }).code, Error::Code::input);
    EXPECT_EQ(told([] { Formula("x - r", {{"r r", 1.0}}); }).code, Error::Code::input);
    EXPECT_EQ(told([] { Formula("x").with("r", 1); }).code, Error::Code::input);
    EXPECT_EQ(told([] { Formula("x*r", {{"r", NAN}}); }).code, Error::Code::input);
    EXPECT_EQ(told([] {
                  Formula("x*r", {{"r", 1.0}}).with("r", INFINITY);
              }).code,
              Error::Code::input);
    EXPECT_EQ(told([] {
                  Formula("x").bound({{{1, -1}, {0, 0}, {0, 0}}});
              }).code,
              Error::Code::input);
    EXPECT_EQ(told([] {
                  Formula("x").bound({{{NAN, 1}, {0, 0}, {0, 0}}});
              }).code,
              Error::Code::input);
}

} // namespace
} // namespace isomotion
