// Solving along the ray: polynomials whose first root is known in closed form.
#include "render/drawing.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "formula/graph/degree.h"

namespace isomotion::render {
namespace {

constexpr int across = 24;

class Chebyshev : public Drawing {
protected:
    // Parallel rays from x = 1 to x = -1 in a box.
    Picture look(const std::string& formula) {
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
method = "chebyshev"
)",
                                                   formula, across, across)));
    }
};
ISOMOTION_ON_EVERY_BACKEND(Chebyshev);

// The largest x of every pixel's hit, if all hit.
std::vector<float> depths(const Picture& picture) {
    EXPECT_EQ(count(picture, Verdict::hit), across * across);
    return picture.frame.find("P.X")->samples;
}

// All degrees that the method takes: T_n(x) = c first at x = cos(acos(c)/n).
TEST_P(Chebyshev, FindsTheFirstRootOfEveryDegree) {
    for (int degree = 1; degree <= 12; ++degree) {
        for (const double level : {-0.9, -0.3, 0.0, 0.3, 0.9}) {
            SCOPED_TRACE(fmt::format("T_{} = {}", degree, level));
            const Picture picture = look(fmt::format("chebyshev({}, x) - ({})", degree, level));
            const double root = std::cos(std::acos(level) / degree);
            for (const float x : depths(picture)) ASSERT_NEAR(x, root, 1e-4);
        }
    }
}

// Roots of one ray that lie close together, and the first of them.
TEST_P(Chebyshev, TellsNearRootsApart) {
    for (const double apart : {0.1, 1e-2, 1e-3}) {
        SCOPED_TRACE(apart);
        const Picture picture = look(fmt::format("(x - 0.3)*(x - 0.3 + {})*(x + 0.7)", apart));
        for (const float x : depths(picture)) ASSERT_NEAR(x, 0.3, 1e-4);
    }
}

TEST_P(Chebyshev, MissesWhatHasNoRoot) {
    for (const char* formula : {"x^2 + y^2 + 0.01", "(x^2 - 0.25)^2 + 1e-3", "x^12 + 0.5", "3 + 1e-30*x"}) {
        const Picture picture = look(formula);
        EXPECT_EQ(count(picture, Verdict::hit), 0) << formula;
        EXPECT_EQ(count(picture, Verdict::miss), across * across) << formula;
    }
}

} // namespace
} // namespace isomotion::render
