// Singular points that stay, curves of them, and what is neither.
#include "topology/search/singular_set.h"

#include "topology/field/motion.h"
#include "topology/moving.h"

namespace isomotion::topology {
namespace {

const char* const walls = "{ box = [[-2.1, -2.2, -2.3], [2.4, 2.5, 2.2]] }";

// Of a place in the stratum and a time near which the surface is singular; T = t - 0.5.
std::optional<SingularSet> set_at(const std::string& formula, const std::vector<double>& place,
                                  double time, const Stratum& stratum = {},
                                  const char* bounds = walls) {
    const Moving moving{formula, bounds, "T = \"t - 0.5\"", ""};
    const MovingField field(
        motions(moving.scene(), Side::negative, {0, 1}, Clock::time).pieces.at(0), stratum);
    Box box{};
    for (std::size_t k = 0; k < place.size(); ++k) box[k] = {place[k] - 1e-5, place[k] + 2e-5};
    box[place.size()] = {time - 2e-6, time + 1e-6};
    return singular_set(field, box);
}

void expect_set(const std::optional<SingularSet>& set, int dimension, bool lasts) {
    ASSERT_TRUE(set);
    EXPECT_EQ(set->dimension, dimension);
    EXPECT_EQ(set->lasts, lasts);
}

TEST(SingularSet, IsAPoint) {
    expect_set(set_at("x^2 + y^2 - z^2 - T", {0, 0, 0}, 0.5), 0, false);
    expect_set(set_at("x^4 + y^2 + z^2 - T", {0, 0, 0}, 0.5), 0, false);
    expect_set(set_at("x^3 + 0.7*y^2 - z^2 + T", {0, 0, 0}, 0.5), 0, false);
    // A saddle of three valleys: all second derivatives but one are 0.
    expect_set(set_at("x^3 - 3*x*y^2 + z^2 + T", {0, 0, 0}, 0.5), 0, false);
}

TEST(SingularSet, IsACurveAtAMoment) {
    // A ring without thickness, a line, and one that runs askew.
    expect_set(set_at("(x^2 + y^2 - 1)^2 + z^2 - T", {1, 0, 0}, 0.5), 1, false);
    expect_set(set_at("(x^2 + y^2 - 1)^2 + z^2 - T", {0.6, 0.8, 0}, 0.5), 1, false);
    expect_set(set_at("x*y - T", {0, 0, 1}, 0.5), 1, false);
    expect_set(set_at("(x + 2*y - z)^2 + (y + z)^2 - T", {0.9, -0.3, 0.3}, 0.5), 1, false);
    // Two lines that cross.
    expect_set(set_at("x^2*y^2 + z^2 - T", {0, 0, 0}, 0.5), 1, false);
}

TEST(SingularSet, IsASurfaceAtAMoment) {
    expect_set(set_at("(x^2 + y^2 + z^2 - 1)^2 - T", {0.6, 0.8, 0}, 0.5), 2, false);
}

TEST(SingularSet, Lasts) {
    // A cone that moves; two sheets that touch where the circle's radius puts them; planes.
    expect_set(set_at("(x - T)^2 + y^2 - (z + 2*T)^2", {0.25, 0, -0.5}, 0.75), 0, true);
    expect_set(set_at("((x + 1 + T)^2 + y^2)*((x - 1 - T)^2 + y^2) - z^4", {1.25, 0, 0}, 0.75), 0,
               true);
    expect_set(set_at("(x - T)*(y + x*T)", {0.25, -0.0625, 1}, 0.75), 1, true);
}

// In a wall at 3.14159 the lattice's lines are singular but for 3e-6.
TEST(SingularSet, IsNearlyACurveInAWall) {
    const char* const formula = "sin(z)*cos(x - y) + cos(z)*sin(x + y) - 2*T";
    const char* const bounds =
        "{ box = [[-3.14159, -3.14159, -3.14159], [3.14159, 3.14159, 3.14159]] }";
    const Stratum wall{{Stratum::End::high, Stratum::End::free, Stratum::End::free}};
    expect_set(set_at(formula, {-1, -M_PI / 2 + 1}, 1, wall, bounds), 1, false);
}

// A box as a search leaves it around all sixteen nodes, at all times.
TEST(SingularSet, IsFoundInALargeBox) {
    const std::string kummer =
        "lam = (3*mu^2 - 1)/(3 - mu^2); (x^2 + y^2 + z^2 - mu^2)^2 - lam*(1 - z - "
        "sqrt(2)*x)*(1 - z + sqrt(2)*x)*(1 + z + sqrt(2)*y)*(1 + z - sqrt(2)*y)";
    // In the middle of the second one nodes meet along three lines.
    for (const char* mu : {"mu = \"1.2 + 0.3*t\"", "mu = \"0.8 + 0.4*t\""}) {
        SCOPED_TRACE(mu);
        const scene::Scene scene = Moving{kummer, "{ sphere = 2.6 }", mu}.scene();
        const MovingField field(motions(scene, Side::negative, {0, 1}, Clock::time).pieces.at(0),
                                {});
        expect_set(singular_set(field, field.domain()), 0, true);
    }
}

TEST(SingularSet, IsNoneOfARegularSurface) {
    EXPECT_FALSE(set_at("x^2 + y^2 + z^2 - 1 - T", {1, 0, 0}, 0.5));
    EXPECT_FALSE(set_at("x + y*z - T", {0.3, 0, 0}, 0.8));
}

} // namespace
} // namespace isomotion::topology
