// Nodes and cusps: the gradient is zero where the ray ends, and the pixel still has a verdict and a
// normal of unit length.
#include "stability/hard_case.h"

#include <fmt/format.h>

namespace isomotion::stability {
namespace {

using scene::Method;

class SingularPoints : public Stability {};

TEST_P(SingularPoints, KeepWithinTheirBounds) { expect_bounds(GetParam()); }

HardCase both(const std::string& name, const std::string& file, double sign, double taylor) {
    return {name, surface(file), {{Method::amp_sign, sign}, {Method::amp_taylor, taylor}}};
}

INSTANTIATE_TEST_SUITE_P(Surfaces, SingularPoints,
                         testing::Values(both("Barth sextic", "barth_sextic", 520, 0),
                                         both("Barth decic", "barth_decic", 1900, 7700),
                                         both("Endrass octic", "endrass_octic", 0, 390),
                                         both("Labs septic", "labs_septic", 0, 520),
                                         both("Sarti dodecic", "sarti_dodecic", 390, 390),
                                         both("dervish", "dervish", 0, 0),
                                         both("ding-dong", "ding_dong", 0, 0),
                                         both("teardrop", "teardrop", 0, 0)),
                         test_name);

// The middle ray of an odd number of pixels runs exactly into the singular point at the origin.
struct Point {
    std::string name, formula;
    bool signs_see_it; // along the camera's ray
};
void PrintTo(const Point& point, std::ostream* out) { *out << point.name; }

class MiddleRay : public testing::TestWithParam<Point> {};

TEST_P(MiddleRay, EndsAtASingularPoint) {
    const HardCase a_case{GetParam().name + ", middle ray",
                          fmt::format(R"(
[surface]
formula = "{}"
bounds = {{ sphere = 1 }}
[camera]
position = [3, 0, 0]
target = [0, 0, 0]
up = [0, 0, 1]
[isolation]
step = 0.013
[output]
size = [97, 97]
)",
                                      GetParam().formula),
                          {}};
    for (const Method method :
         {Method::hermite, Method::marching, Method::amp_sign, Method::amp_taylor}) {
        SCOPED_TRACE(std::string(scene::name(method)));
        const Looked looked = look(a_case, method);
        EXPECT_EQ(looked.crooked, 0);
        EXPECT_EQ(looked.errors.nan, 0);
        EXPECT_EQ(looked.errors.step_limit, 0);
        const auto verdict =
            render::Verdict(int(looked.picture.frame.find("verdict")->samples[97 * 48 + 48]));
        const bool hit =
            verdict == render::Verdict::hit || verdict == render::Verdict::zero_gradient;
        const bool by_signs = method == Method::marching || method == Method::amp_sign;
        EXPECT_TRUE(hit || (by_signs && !GetParam().signs_see_it));
    }
}

INSTANTIATE_TEST_SUITE_P(
    Stability, MiddleRay,
    testing::Values(Point{"cone", "y^2 + z^2 - x^2", false},           // touched from inside
                    Point{"upright cone", "x^2 + y^2 - z^2", false},   // touched at its apex
                    Point{"cusp", "y^2 + z^2 + x^3", true},            //
                    Point{"isolated point", "x^2 + y^2 + z^2", false}, //
                    Point{"monkey saddle", "x^3 - 3*x*y^2 + z^3", true},
                    Point{"triple plane", "x^3", true}, Point{"double plane", "x^2", false}),
    [](const auto& tested) {
        std::string name = tested.param.name;
        std::replace(name.begin(), name.end(), ' ', '_');
        return name;
    });

} // namespace
} // namespace isomotion::stability
