// Polynomials whose first root is known in closed form, with beams and without.
#include "render/drawing.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace isomotion::render {
namespace {

constexpr int across = 24;

class PolynomialRoots : public Drawing {
protected:
    // Parallel rays from x = 1 to x = -1 in a box.
    Picture look(const std::string& formula, bool beam) {
        return draw(*context, scene_of(fmt::format(R"([surface]
formula = "{}"
bounds = {{ box = [[-1, -1, -1], [1, 1, 1]] }}
[camera]
position = [5, 0, 0]
projection = "orthographic"
height = 1.5
[output]
size = [{}, {}]
[isolation]
beam = {}
)",
                                                   formula, across, across, beam)));
    }
};
ISOMOTION_ON_EVERY_BACKEND(PolynomialRoots);

// The largest x of every pixel's hit, if all hit.
std::vector<float> depths(const Picture& picture) {
    EXPECT_EQ(count(picture, Verdict::hit), across * across);
    return picture.frame.find("P.X")->samples;
}

// T_n(x) = c first at x = cos(acos(c)/n).
TEST_P(PolynomialRoots, AreTheFirstOfEveryDegree) {
    for (int degree = 1; degree <= 12; ++degree) {
        for (const double level : {-0.9, -0.3, 0.0, 0.3, 0.9}) {
            for (const bool beam : {false, true}) {
                SCOPED_TRACE(fmt::format("T_{} = {}, beam {}", degree, level, beam));
                const Picture picture =
                    look(fmt::format("chebyshev({}, x) - ({})", degree, level), beam);
                const double root = std::cos(std::acos(level) / degree);
                for (const float x : depths(picture)) ASSERT_NEAR(x, root, 1e-4);
            }
        }
    }
}

// Roots of one ray that lie close together, and the first of them.
TEST_P(PolynomialRoots, AreToldApart) {
    for (const double apart : {0.1, 1e-2, 1e-3}) {
        for (const bool beam : {false, true}) {
            SCOPED_TRACE(fmt::format("{} apart, beam {}", apart, beam));
            const Picture picture =
                look(fmt::format("(x - 0.3)*(x - 0.3 + {})*(x + 0.7)", apart), beam);
            for (const float x : depths(picture)) ASSERT_NEAR(x, 0.3, 1e-4);
        }
    }
}

TEST_P(PolynomialRoots, AreNotFoundWhereNoneIs) {
    for (const char* formula :
         {"x^2 + y^2 + 0.01", "(x^2 - 0.25)^2 + 1e-3", "x^12 + 0.5", "3 + 1e-30*x"}) {
        for (const bool beam : {false, true}) {
            SCOPED_TRACE(fmt::format("{}, beam {}", formula, beam));
            const Picture picture = look(formula, beam);
            EXPECT_EQ(count(picture, Verdict::hit), 0);
            EXPECT_EQ(count(picture, Verdict::miss), across * across);
        }
    }
}

} // namespace
} // namespace isomotion::render
