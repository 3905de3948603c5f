// What the animations promise, from their fields on the CPU: no GL.
#include "scene/data_folder.h"
#include "scene/load.h"
#include "scene/scene_at.h"

#include <numeric>

#include <gtest/gtest.h>

namespace isomotion::scene {
namespace {

// Connected components of {F > 0} on a grid of n^3 samples, 6-neighbours.
int components(const Scene& scene, int frame, int n) {
    const SceneAt now = at(scene, scene.timeline.values(frame));
    const auto count = std::size_t(n) * std::size_t(n) * std::size_t(n);
    std::vector<float> x(count), y(count), z(count), f(count);
    for (std::size_t k = 0; k < count; ++k) {
        const auto coordinate = [&](std::size_t index, int axis) {
            return float(now.bounds.min[axis] +
                         (double(index) + 0.5) / n * (now.bounds.max[axis] - now.bounds.min[axis]));
        };
        x[k] = coordinate(k % std::size_t(n), 0);
        y[k] = coordinate(k / std::size_t(n) % std::size_t(n), 1);
        z[k] = coordinate(k / std::size_t(n * n), 2);
    }
    const std::array<std::span<const float>, 3> inputs{x, y, z};
    const std::array<std::span<float>, 1> outputs{f};
    formula::Evaluator<float>(scene.surface.field->value).points(now.bindings, inputs, outputs);

    std::vector<std::size_t> parent(count);
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&](std::size_t k) {
        while (parent[k] != k) k = parent[k] = parent[parent[k]];
        return k;
    };
    int found = 0;
    for (std::size_t k = 0; k < count; ++k) {
        if (!(f[k] > 0)) continue;
        ++found;
        const std::size_t steps[] = {1, std::size_t(n), std::size_t(n * n)};
        const std::size_t index[] = {k % std::size_t(n), k / std::size_t(n) % std::size_t(n),
                                     k / std::size_t(n * n)};
        for (int axis = 0; axis < 3; ++axis) {
            if (index[axis] == 0 || !(f[k - steps[axis]] > 0)) continue;
            const std::size_t a = root(k), b = root(k - steps[axis]);
            if (a == b) continue;
            parent[a] = b;
            --found;
        }
    }
    return found;
}

TEST(Gallery, TheBlobbyFallsFrom75SpheresToOneBodyAndBack) {
    const Scene scene = load("blobby75");
    EXPECT_EQ(scene.timeline.frames, 120);
    EXPECT_EQ(components(scene, 1, 110), 75);
    EXPECT_EQ(components(scene, 61, 110), 1);
    EXPECT_EQ(components(scene, 120, 110), 75);
}

} // namespace
} // namespace isomotion::scene
