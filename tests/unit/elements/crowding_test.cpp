// Counts are never too small, and of clouds that are even not much too large.
#include "elements/crowding.h"

#include <random>

#include <gtest/gtest.h>

namespace isomotion::elements {
namespace {

double most_by_brute_force(const std::vector<glm::dvec3>& middles, double distance) {
    double most = 0;
    for (const glm::dvec3& at : middles) {
        double near = 0;
        for (const glm::dvec3& other : middles) near += glm::distance(at, other) <= distance;
        most = std::max(most, near);
    }
    return most;
}

TEST(Crowding, CountsAtLeastWhatIsNear) {
    std::mt19937 engine(9);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (const double flat : {1.0, 1e-3, 0.0}) {
        std::vector<glm::dvec3> middles;
        for (int k = 0; k < 900; ++k)
            middles.emplace_back(unit(engine), flat * unit(engine), unit(engine));
        const Crowding crowding(middles);
        for (const double distance : {0.0, 0.01, 0.1, 0.4, 5.0}) {
            const double counted = crowding.most_within(distance);
            EXPECT_GE(counted, most_by_brute_force(middles, distance)) << flat << " " << distance;
            EXPECT_LE(counted, 900) << flat << " " << distance;
        }
        EXPECT_LT(crowding.most_within(0.05), 200) << flat;
        EXPECT_EQ(crowding.most_within(10), 900);
    }
}

TEST(Crowding, OfNoneOneAndAllAtOnePoint) {
    EXPECT_EQ(Crowding({}).most_within(1), 0);
    const std::vector<glm::dvec3> one{glm::dvec3(3)};
    EXPECT_EQ(Crowding(one).most_within(0), 1);
    const std::vector<glm::dvec3> many(50, glm::dvec3(-2, 0, 1));
    EXPECT_EQ(Crowding(many).most_within(0), 50);
}

} // namespace
} // namespace isomotion::elements
