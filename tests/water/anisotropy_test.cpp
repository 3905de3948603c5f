#include "anisotropy.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace water {
namespace {

constexpr float spacing = 0.1F;

// A lattice in the middle of a tank far larger.
Fluid lattice(int nx, int ny, int nz) {
    Tank tank;
    tank.inside = {{0, 0, 0}, {6, 6, 6}};
    Settings settings;
    settings.spacing = spacing;
    std::vector<Vec3> points;
    for (int k = 0; k < nz; ++k) {
        for (int j = 0; j < ny; ++j) {
            for (int i = 0; i < nx; ++i)
                points.push_back(Vec3{3, 3, 3} + spacing * Vec3{float(i), float(j), float(k)});
        }
    }
    std::vector<Vec3> still(points.size());
    return {tank, settings, std::move(points), std::move(still)};
}

double field(const std::vector<Blob>& blobs, Vec3 p) {
    double sum = 0;
    for (const Blob& blob : blobs) {
        const Vec3 d = p - blob.centre;
        const float* g = blob.g;
        const Vec3 s{g[0] * d.x + g[1] * d.y + g[2] * d.z, g[1] * d.x + g[3] * d.y + g[4] * d.z,
                     g[2] * d.x + g[4] * d.y + g[5] * d.z};
        const double rest = std::max(0.0, 1 - double(dot(s, s)));
        sum += double(blob.weight) * rest * rest * rest;
    }
    return sum;
}

TEST(Anisotropy, TheFieldIsOneWithinTheWater) {
    const std::vector<Blob> blobs = blobs_of(lattice(15, 15, 15), {});
    for (const float x : {0.0F, 0.25F, 0.5F}) {
        const Vec3 p = Vec3{3, 3, 3} + spacing * Vec3{7 + x, 7 + x / 2, 7 - x};
        EXPECT_NEAR(field(blobs, p), 1, 0.05);
    }
    EXPECT_EQ(field(blobs, {2, 3, 3}), 0);
}

TEST(Anisotropy, AParticleAloneIsABall) {
    const Blob blob = blobs_of(lattice(1, 1, 1), {})[0];
    const float expected = 1 / (SurfaceSettings{}.alone * SurfaceSettings{}.kernel * spacing);
    for (const int k : {0, 3, 5}) EXPECT_NEAR(blob.g[k], expected, 1e-4F * expected);
    for (const int k : {1, 2, 4}) EXPECT_NEAR(blob.g[k], 0, 1e-4F * expected);
    EXPECT_EQ(blob.centre.x, 3);
}

TEST(Anisotropy, ASheetIsFlatAndHasNoHoles) {
    const std::vector<Blob> blobs = blobs_of(lattice(15, 15, 1), {});
    const Blob& middle = blobs[7 * 15 + 7];
    EXPECT_NEAR(middle.g[5] / middle.g[0], SurfaceSettings{}.most_stretch, 0.01F);
    EXPECT_NEAR(middle.g[1], 0, 1e-3F * middle.g[0]);
    for (const float x : {0.0F, 0.5F}) {
        const Vec3 p = Vec3{3, 3, 3} + spacing * Vec3{7 + x, 7 + x, 0};
        EXPECT_GT(field(blobs, p), 0.5);
        EXPECT_LT(field(blobs, p + Vec3{0, 0, spacing}), 0.5);
    }
}

} // namespace
} // namespace water
