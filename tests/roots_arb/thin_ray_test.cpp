// Searches where the roots are known, those included that a search for contradictions must find.
#include "thin_ray.h"

#include <cmath>

#include <gtest/gtest.h>

#include "formula/field.h"

namespace isomotion::roots_arb {
namespace {

Search along_x(std::string_view formula, double y = 0, double from = -2.5, double to = 2.5) {
    formula::Vocabulary names;
    names.inputs = formula::coordinate_names;
    const formula::Field field = formula::make_field(formula, names);
    const formula::EnclosurePrograms programs = formula::enclosure_programs(field);
    ThinRays rays(programs, {});
    return rays.search({{0, y, 0}, {1, 0, 0}}, from, to, 3000);
}

constexpr const char* sphere = "x^2 + y^2 + z^2 - 1";

TEST(ThinRay, FindsTheFirstOfTwoRoots) {
    const Search search = along_x(sphere, 0.5);
    ASSERT_TRUE(search.crosses);
    EXPECT_EQ(search.unproven, 0);
    EXPECT_LE(search.low, -std::sqrt(0.75));
    EXPECT_GE(search.high, -std::sqrt(0.75));
    EXPECT_LT(search.high - search.low, 1e-13);
}

// The least of F is +-2^-80, and doubles see 0 in 10^-8 around it.
TEST(ThinRay, TellsAMissFromAHitByLessThanDoublesHold) {
    const Search miss = along_x("x^2 + 1 - 2*x + y^5", 0x1p-16);
    EXPECT_FALSE(miss.crosses);
    EXPECT_EQ(miss.unproven, 0);
    const Search hit = along_x("x^2 + 1 - 2*x - y^4", 0x1p-20);
    EXPECT_TRUE(hit.crosses);
    EXPECT_EQ(hit.unproven, 0);
    EXPECT_NEAR(hit.low, 1 - 0x1p-40, 0x1p-46);
}

TEST(ThinRay, LeavesADoubleRootUnproven) {
    const Search search = along_x("(x^2 - 2)^2");
    EXPECT_FALSE(search.crosses);
    EXPECT_FALSE(search.budget_ended);
    EXPECT_GT(search.unproven, 1);
    EXPECT_NEAR(search.unproven_low, -std::sqrt(2), 1e-12);
    EXPECT_NEAR(search.unproven_high, std::sqrt(2), 1e-12);
}

TEST(ThinRay, FindsARootBehindOneThatTouches) {
    const Search search = along_x("(x + 1)^2*(x - 1)");
    EXPECT_TRUE(search.crosses);
    EXPECT_GT(search.unproven, 0);
    EXPECT_NEAR(search.unproven_low, -1, 1e-12);
    EXPECT_NEAR(search.high, 1, 1e-12);
}

TEST(ThinRay, FindsRootsAtTheEndsOfWhatItSearches) {
    const double root = std::nextafter(-std::sqrt(0.75), -2.0);
    EXPECT_FALSE(along_x(sphere, 0.5, -2, root).crosses);
    EXPECT_EQ(along_x(sphere, 0.5, -2, root).unproven, 0);
    EXPECT_TRUE(along_x(sphere, 0.5, -2, root + 0x1p-50).crosses);
    EXPECT_TRUE(along_x(sphere, 0.5, root, 0).crosses);
}

TEST(ThinRay, GivesUpWhereTheFieldIsZero) {
    const Search search = along_x("max(x^2 + y^2 - 1, 0)");
    EXPECT_FALSE(search.crosses);
    EXPECT_GT(search.unproven, 0);
    EXPECT_TRUE(search.budget_ended);
}

TEST(ThinRay, PassesKinksAndSumsOfCosines) {
    EXPECT_EQ(along_x("abs(x) + 0.001").unproven, 0);
    const Search search = along_x("cos(9*x) + abs(x)/3 - 1.5", 0, -4.5, 4.5);
    EXPECT_TRUE(search.crosses);
    EXPECT_EQ(search.unproven, 0);
}

} // namespace
} // namespace isomotion::roots_arb
