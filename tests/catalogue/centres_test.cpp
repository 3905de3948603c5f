// The 75 centres of the blobs, from the rule they are made by.
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "surface_file.h"

namespace isomotion::catalogue {
namespace {

// Shells of spheres, on each of which the centres wind down by the golden angle.
std::vector<glm::dvec3> golden_shells() {
    const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
    std::vector<glm::dvec3> centres;
    for (const auto& [count, radius] : {std::pair(50, 1.0), {20, 0.62}, {5, 0.28}}) {
        for (int i = 0; i < count; ++i) {
            const double height = 1 - (2 * i + 1) / double(count);
            const double ring = std::sqrt(1 - height * height);
            centres.push_back(radius * glm::dvec3(ring * std::cos(i * golden), height,
                                                  ring * std::sin(i * golden)));
        }
    }
    return centres;
}

TEST(Centres, OfAllBlobbiesAreTheGoldenShells) {
    const auto expected = golden_shells();
    for (const char* surface : {"blinn_blobby", "blinn_inverse_square", "wyvill_soft_objects"}) {
        for (const double s : {1.0, 0.3, 2.2}) {
            SCOPED_TRACE(testing::Message() << surface << " at s = " << s);
            const auto blobs = used(surface, {{"s", s}}).at.surfaces[0].bindings.arrays.at(0);
            ASSERT_EQ(blobs.count, 75);
            for (std::size_t k = 0; k < expected.size(); ++k) {
                // The fields cx, cy, cz come first; the files give six decimals.
                for (int axis = 0; axis < 3; ++axis) {
                    EXPECT_NEAR(blobs.fields[std::size_t(axis)][k], s * expected[k][axis],
                                s * 7e-7);
                }
            }
        }
    }
}

} // namespace
} // namespace isomotion::catalogue
