// How many nodes the catalogue's surfaces have, and where: counted, not believed.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "nodes/census.h"

namespace isomotion {
namespace {

using std::sqrt;
using std::numbers::phi;

// So many nodes at radii in [from, to].
struct Shell {
    int count;
    double from, to;
};

Shell at(int count, double radius) {
    const double slack = 1e-8 * (1 + radius);
    return {count, radius - slack, radius + slack};
}

// An isolated singular point that is no node, and the rank of the Hessian there.
struct Degenerate {
    int rank;
    glm::dvec3 position;
};

struct Expected {
    std::string surface; // of the catalogue; else what a formula is called here
    std::vector<scene::Override> settings = {};
    std::vector<Shell> nodes = {}; // all of them
    int solitary = 0;              // how many of them are isolated points of the surface
    std::vector<Degenerate> degenerate = {};
    bool curves = false; // of singular points: only nodes are counted
    std::string formula = {};
};

void PrintTo(const Expected& expected, std::ostream* to) {
    *to << expected.surface;
    for (const auto& setting : expected.settings) *to << ' ' << setting;
}

std::string test_name(const testing::TestParamInfo<Expected>& info) {
    std::string name = info.param.surface;
    for (const auto& setting : info.param.settings) name += '_' + setting;
    std::string result;
    for (const char c : name) {
        if (c == '-') result += "minus";
        result += std::isalnum(c) ? c : '_';
    }
    return result;
}

class SingularPoints : public testing::TestWithParam<Expected> {};

TEST_P(SingularPoints, AreThoseExpected) {
    const Expected& expected = GetParam();
    const Census census =
        expected.formula.empty()
            ? census_of("use = '" + expected.surface + "'", expected.settings)
            : census_of("formula = '''" + expected.formula + "'''\nbounds = { sphere = 2 }");
    SCOPED_TRACE(testing::PrintToString(expected) + ": found " + describe(census));
    ASSERT_TRUE(census.settled) << "some nodes were reached from few starts: there may be more";

    std::size_t nodes = 0;
    for (const Shell& shell : expected.nodes) {
        nodes += std::size_t(shell.count);
        const auto inside =
            std::count_if(census.nodes.begin(), census.nodes.end(), [&](const SingularPoint& node) {
                return node.radius() >= shell.from && node.radius() <= shell.to;
            });
        EXPECT_EQ(inside, shell.count)
            << fmt::format("nodes at radius {:.9g} to {:.9g}", shell.from, shell.to);
    }
    EXPECT_EQ(census.nodes.size(), nodes);
    EXPECT_EQ(std::count_if(census.nodes.begin(), census.nodes.end(),
                            [](const SingularPoint& node) { return node.solitary(); }),
              expected.solitary)
        << "solitary nodes";
    for (const SingularPoint& node : census.nodes) { // no near thing between node and cusp
        const glm::dvec3 sizes = glm::abs(node.curvatures);
        EXPECT_GT(std::min({sizes.x, sizes.y, sizes.z}), 1e-3) << "at radius " << node.radius();
    }

    if (expected.curves) return;
    EXPECT_EQ(census.degenerate.size(), expected.degenerate.size());
    for (const Degenerate& point : expected.degenerate) {
        EXPECT_TRUE(std::any_of(census.degenerate.begin(), census.degenerate.end(),
                                [&](const SingularPoint& found) {
                                    return found.rank == point.rank &&
                                           glm::distance(found.position(), point.position) < 1e-2;
                                }))
            << fmt::format("none of rank {} at ({}, {}, {})", point.rank, point.position.x,
                           point.position.y, point.position.z);
    }
    if (expected.degenerate.empty()) { // nor between singular and regular
        EXPECT_GT(census.nearest_miss, 1e-9);
    }
}

// How far from the origin a node of Sarti's surface is: where the line of (p, w) meets w = 1. Here
// (p, w) is a sum of three neighbours among the 600-cell's vertices, and its length is sqrt(3) phi.
double sarti_radius(double w) { return sqrt(3 * phi * phi / (w * w) - 1); }

const std::vector<Expected> nodal{
    {.surface = "ding_dong", .nodes = {at(1, 0)}},
    {.surface = "cayley", .nodes = {at(1, 0), at(3, 0.4)}},
    {.surface = "nordstrand", // and 3 at infinity
     .nodes = {at(1, 0), at(3, 0.4 / sqrt(3)), at(6, 0.4), at(1, 0.4 * sqrt(3))}},
    {.surface = "kummer", .nodes = {at(12, sqrt(2))}}, // and 4 at infinity
    // 12 where the edges of a tetrahedron pierce the sphere of radius mu, if they do.
    {.surface = "kummer_tetrahedral", .nodes = {at(12, 1.3), at(4, 0.69 * sqrt(0.75))}},
    {.surface = "kummer_tetrahedral", .settings = {"mu=0.9"}, .nodes = {at(4, 0.19 * sqrt(0.75))}},
    {.surface = "tooth", .nodes = {at(1, 0)}, .solitary = 1},
    {.surface = "goursat", .settings = {"b=-1", "c=0"}, .nodes = {at(1, 0)}, .solitary = 1},
    {.surface = "tangle", .settings = {"c=6.25"}, .nodes = {at(6, sqrt(2.5))}},
    {.surface = "tangle", .settings = {"c=12.5"}, .nodes = {at(12, sqrt(5))}},
    {.surface = "tangle", .settings = {"c=18.75"}, .nodes = {at(8, sqrt(7.5))}, .solitary = 8},
    {.surface = "torus_quartic", .settings = {"R=0.4", "r=0.6"}, .nodes = {at(2, sqrt(0.2))}},
    {.surface = "dervish", .nodes = {{26, 0, 5}, {5, 9.17, 9.18}}},
    // Six planes meet in 15 lines, which pierce the sphere; 20 more are alpha's.
    {.surface = "barth_sextic", .nodes = {at(15 * 2, 1), at(20, sqrt(3))}}, // and 15 at infinity
    {.surface = "barth_sextic", .settings = {"alpha=1.3"}, .nodes = {at(15 * 2, 1)}},
    {.surface = "labs_septic", .nodes = {{57, 0, 2}, {35, 2, 6}, {7, 15.77, 15.78}}},
    {.surface = "endrass_octic", // and 16 at infinity
     .nodes = {{112, 0, 3}, {16, 3.23, 3.24}}},
    {.surface = "endrass_octic_plus", // and 24 at infinity
     .nodes = {{128, 0, 3.1}, {16, 3.91, 3.92}}},
    // Ten planes meet in 45 lines, which pierce two spheres; 120 more are alpha's.
    {.surface = "barth_decic", // and 45 at infinity
     .nodes = {at(45 * 2, 1), at(45 * 2, 1 / phi), at(60, sqrt(5 - 2 * sqrt(5))),
               at(60, sqrt(phi + 2))}},
    {.surface = "barth_decic",
     .settings = {"alpha=1.3"},
     .nodes = {at(45 * 2, 1), at(45 * 2, 1 / phi)}},
    {.surface = "sarti_dodecic", // and 40 at infinity
     .nodes = {at(30, 1 / (phi * phi)), at(20, 1 / sqrt(3)), at(60, sarti_radius(phi + 0.5)),
               at(60, sarti_radius(phi / 2 + 1)), at(60, sqrt(2)),
               at(60, sarti_radius(phi / 2 + 0.5)), at(30, phi* phi), at(120, sqrt(11)),
               at(60, sarti_radius(0.5)), at(60, sarti_radius(0.5 / phi))}},
};

const std::vector<Expected> smooth{{.surface = "clebsch"},       {.surface = "goursat"},
                                   {.surface = "torus_quartic"}, {.surface = "tangle"},
                                   {.surface = "mitchell"},      {.surface = "peninsula"},
                                   {.surface = "chmutov_6"},     {.surface = "chmutov_8"}};

const std::vector<Expected> degenerate{
    {.surface = "cushion", .nodes = {at(1, 0)}, .degenerate = {{1, {1, 0, 1}}, {1, {-1, 0, 1}}}},
    {.surface = "piriform", .degenerate = {{2, {0, 0, 0}}}},
    {.surface = "cassini", .degenerate = {{2, {1, 0, 0}}, {2, {-1, 0, 0}}}},
    {.surface = "kiss", .degenerate = {{2, {0, 0, 0}}}},
    {.surface = "teardrop", .degenerate = {{2, {0, 0, 0}}}},
    {.surface = "peninsula", .settings = {"c=0"}, .degenerate = {{1, {0, 0, 0}}}},
    {.surface = "hunt", .nodes = {at(2, sqrt(10))}, .curves = true},
    {.surface = "miter", .curves = true},
    {.surface = "cross_cap", .curves = true},
    {.surface = "steiner", .curves = true},
    {.surface = "klein_bottle", .curves = true},
    {.surface = "heart", .curves = true},
    {.surface = "heart_taubin", .curves = true},
    {.surface = "high_silhouette", .curves = true},
    {.surface = "nonisol", .curves = true},
};

// Nodes opened by a part in a million, and by the rounding of 22/243 to float, are none.
const std::vector<Expected> opened{
    {.surface = "cayley", .settings = {"c=1e-6"}},
    {.surface = "tooth", .settings = {"c=1e-6"}},
    {.surface = "tangle", .settings = {"c=12.50001"}},
    {.surface = "barth_sextic", .settings = {"alpha=1.000001"}, .nodes = {at(15 * 2, 1)}},
    {.surface = "barth_decic",
     .settings = {"alpha=0.999999"},
     .nodes = {at(45 * 2, 1), at(45 * 2, 1 / phi)}},
    {.surface = "sarti_dodecic", .settings = {"lam=0.09053497761487961"}},
};

// Formulas as they are found in print or in transcriptions: their nodes tell them from the surfaces
// they are meant to be.
const std::vector<Expected> misprints{
    {.surface = "ding_dong", .formula = "x^2 + y^2 - z*(1 - z^2)"},
    {.surface = "kiss", .formula = "x^2 + y^2 - z*(1 - z^4)"},
    {.surface = "cayley",
     .degenerate = {{2, {0, 0, 0}}},
     .formula = "-5*(x^2*(y+z) + y^2*(x+z) + z^2*(x+y)) + 2*(x*y + y*x + x*z)"},
    {.surface = "nordstrand",
     .nodes = {{1, 0.09, 0.1}},
     .degenerate = {{2, {0, 0, 0}}},
     .formula = "25*(x^3*(y+z) + y^3*(x+z) + z^3*(x+y)) + 50*(x^2*y^2 + x^2*z^2 + y^2*z^2) "
                "- 125*(x^2*y*z + y^2*x*z + z^2*x*y) - 4*(x*y + y*x + x*z) + 60*x*y*z"},
    {.surface = "cassini", .nodes = {at(2, 1)}, .formula = "((x+1)^2 + y^2)*((x-1)^2 + y^2) - z^2"},
    {.surface = "dervish",
     .formula = "a = sqrt(5 - sqrt(5)); 64*(x-1)*(x^4 - 4*x^3 - 10*x^2*y^2 - 4*x^2 + 16*x "
                "- 20*x*y^2 + 5*y^4 + 16 - 20*y^2) "
                "- 5*a*(2*z-a)*(4*(x^2 + y^2 + z^2) + 1 + 3*sqrt(5))^2"},
    {.surface = "labs_septic",
     .nodes = {{63, 0, 6}},
     .formula = "a = (sqrt(1/196 + 1/27) - 1/14)^(1/3) - (sqrt(1/196 + 1/27) + 1/14)^(1/3); "
                "a1 = -12/7*a^2 - 384/49*a - 8/7; a2 = -32/7*a^2 + 24/49*a - 4; "
                "a3 = -4*a^2 + 24/49*a - 4; a4 = -8/7*a^2 + 8/49*a - 8/7; a5 = -a^2/(1 + a^2); "
                "r2 = x^2 + y^2; x^7 - 21*x^5*y^2 + 35*x^3*y^4 - 7*x*y^6 "
                "+ 7*z*(r2^3 - 8*z^2*r2^2 + 16*z^4*r2) - 64*z^7 "
                "- (z + a5)*((z+1)*r2 + a1*z^3 + a2*z^2 + a3*z + a4)^2"},
    {.surface = "endrass_octic", // and 8 at infinity
     .nodes = {{112, 0, 2.92}},
     .formula = "s = sqrt(2); 64*(x^2-1)*(y^2-1)*((x+y)^2-2)*((x-y)^2-2) "
                "- (-4*(1-s)*(x^2+y^2)^2 + 8*(2-s)*z^2 + 2*(2-7*s)*(x^2+y^2) "
                "- 16*z^4 + 8*(1+2*s)*z^2 - (1-12*s))^2"},
    {.surface = "barth_decic", // (2 - phi)^2 for 2 - phi
     .nodes = {at(45 * 2, 1), at(45 * 2, 1 / (phi * phi))},
     .formula = "p = (1 + sqrt(5))/2; r2 = x^2 + y^2 + z^2; "
                "8*(x^2 - p^4*y^2)*(y^2 - p^4*z^2)*(z^2 - p^4*x^2) "
                "*(x^4 + y^4 + z^4 - 2*x^2*y^2 - 2*x^2*z^2 - 2*y^2*z^2) "
                "+ (3 + 5*p)*(r2 - 1)^2*(r2 - (2 - p)^2)^2"},
};

INSTANTIATE_TEST_SUITE_P(Nodal, SingularPoints, testing::ValuesIn(nodal), test_name);
INSTANTIATE_TEST_SUITE_P(Smooth, SingularPoints, testing::ValuesIn(smooth), test_name);
INSTANTIATE_TEST_SUITE_P(Degenerate, SingularPoints, testing::ValuesIn(degenerate), test_name);
INSTANTIATE_TEST_SUITE_P(Opened, SingularPoints, testing::ValuesIn(opened), test_name);
INSTANTIATE_TEST_SUITE_P(Misprinted, SingularPoints, testing::ValuesIn(misprints), test_name);

} // namespace
} // namespace isomotion
