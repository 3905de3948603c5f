// How many pieces surfaces are in where their critical values say so, counted on a grid: no GL.
#include "scene/data_folder.h"
#include "scene/reading/load.h"
#include "scene/scene_at.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numeric>

#include <gtest/gtest.h>
#include <unistd.h>

namespace isomotion::scene {
namespace {

// Connected components of {sign * F > 0} in the bounds, on a grid of n^3 samples, 6-neighbours.
int components(const Scene& scene, int frame, int n, float sign) {
    const SceneAt now = at_frame(scene, frame);
    const auto count = std::size_t(n) * std::size_t(n) * std::size_t(n);
    std::vector<float> x(count), y(count), z(count), f(count);
    for (std::size_t k = 0; k < count; ++k) {
        const auto coordinate = [&](std::size_t index, int axis) {
            return float(now.surfaces[0].bounds.min[axis] +
                         (double(index) + 0.5) / n *
                             (now.surfaces[0].bounds.max[axis] - now.surfaces[0].bounds.min[axis]));
        };
        x[k] = coordinate(k % std::size_t(n), 0);
        y[k] = coordinate(k / std::size_t(n) % std::size_t(n), 1);
        z[k] = coordinate(k / std::size_t(n * n), 2);
    }
    const std::array<std::span<const float>, 3> inputs{x, y, z};
    const std::array<std::span<float>, 1> outputs{f};
    formula::Evaluator<float>(scene.surfaces[0].field->value)
        .points(now.surfaces[0].bindings, inputs, outputs);

    std::vector<std::size_t> parent(count);
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&](std::size_t k) {
        while (parent[k] != k) k = parent[k] = parent[parent[k]];
        return k;
    };
    int found = 0;
    for (std::size_t k = 0; k < count; ++k) {
        if (!(sign * f[k] > 0)) continue;
        ++found;
        const std::size_t steps[] = {1, std::size_t(n), std::size_t(n * n)};
        const std::size_t index[] = {k % std::size_t(n), k / std::size_t(n) % std::size_t(n),
                                     k / std::size_t(n * n)};
        for (int axis = 0; axis < 3; ++axis) {
            if (index[axis] == 0 || !(sign * f[k - steps[axis]] > 0)) continue;
            const std::size_t a = root(k), b = root(k - steps[axis]);
            if (a == b) continue;
            parent[a] = b;
            --found;
        }
    }
    return found;
}

TEST(Components, TheBlobbyFallsFrom75SpheresToOneBodyAndBack) {
    const Scene scene = load("blobby75");
    EXPECT_EQ(scene.timeline.frames, 120);
    EXPECT_EQ(components(scene, 1, 110, 1), 75);
    EXPECT_EQ(components(scene, 61, 110, 1), 1);
    EXPECT_EQ(components(scene, 120, 110, 1), 75);
}

TEST(Components, DropsGatherInOnePool) {
    const Scene scene = load("falling_drops");
    EXPECT_EQ(scene.surfaces[0].animation.at(scene.timeline.time(1)).arrays[0].count, 60);
    EXPECT_EQ(scene.surfaces[0].animation.at(scene.timeline.time(61)).arrays[0].count, 300);
    const int at_first = components(scene, 1, 120, 1);
    EXPECT_GT(at_first, 20);
    EXPECT_LE(at_first, 60);
    EXPECT_EQ(components(scene, 120, 120, 1), 1);
}

// The data is what the script beside it makes, to the byte.
TEST(Components, DropsAreThoseOfTheirScript) {
    if (std::system("python3 -c pass") != 0) GTEST_SKIP() << "python3 is not installed";
    const std::string data = ISOMOTION_SOURCE_DIR "/animations/data/falling_drops.";
    const std::string made = (std::filesystem::temp_directory_path() /
                              ("isomotion-drops-" + std::to_string(getpid()) + ".csv"))
                                 .string();
    ASSERT_EQ(std::system(("python3 " + data + "py " + made).c_str()), 0);
    const auto text = [](const std::string& file) {
        std::ifstream stream(file, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(stream), {});
    };
    const std::string committed = text(data + "csv");
    EXPECT_GT(committed.size(), 100'000u);
    EXPECT_TRUE(text(made) == committed);
    std::filesystem::remove(made);
}

struct Level {
    const char* animation;
    std::vector<Override> settings;
    int pieces;
    int grid = 80;
    float sign = -1;
};

// Either side of every critical value that parts or joins pieces.
TEST(Components, ChangeAtTheCriticalValues) {
    // The animation cuts it open.
    const Override whole = "surface.bounds={box=[[-1.2,-1.2,-1.2],[1.2,1.2,1.2]]}";
    for (const Level& level : std::initializer_list<Level>{
             {"ding_dong", {"a=-0.05"}, 1},
             {"ding_dong", {"a=0.02"}, 2},
             {"ding_dong", {"a=0.14"}, 2},
             {"ding_dong", {"a=0.16"}, 1}, // the drop vanished at 4/27
             {"kiss", {"c=-0.02"}, 1},
             {"kiss", {"c=0.02"}, 2},
             {"kiss", {"c=0.09"}, 1}, // at 0.08192
             {"tangle", {"c=6"}, 1},
             {"tangle", {"c=12.4"}, 1},
             {"tangle", {"c=12.6"}, 8},
             {"tangle", {"c=18.6"}, 8},
             {"tangle", {"c=18.8"}, 0},
             {"goursat", {"c=0.3", "b=-0.8"}, 1},
             {"tooth", {"c=0.45", whole}, 1},
             {"tooth", {"c=0.55", whole}, 8},
             {"tooth", {"c=0.76", whole}, 0},
             {"mitchell", {"c=-2"}, 1},
             {"mitchell", {"c=1"}, 3}, // the ring and the two caps, parted at -1
             {"steiner", {"c=0.01"}, 4},
             {"steiner", {"c=0.07"}, 0},
             {"miter", {"c=0.01"}, 2},
             {"miter", {"c=0.26"}, 0},
             {"chmutov_6", {"c=0.9"}, 1},
             {"chmutov_6", {"c=1.2"}, 27},
             {"chmutov_6", {"c=2.9"}, 27, 120},
             {"chmutov_6", {"c=3.1"}, 0},
             {"chmutov_8", {"c=0.9"}, 1, 120},
             {"chmutov_8", {"c=1.3"}, 64, 120},
             {"chmutov_12", {"c=1.4"}, 216, 160},
             {"blinn_inverse_square", {"R=0.06", "s=1"}, 75, 110, 1},
             {"blinn_inverse_square", {"R=0.1", "s=1"}, 1, 110, 1},
         }) {
        SCOPED_TRACE(std::string(level.animation) + " " + level.settings[0]);
        EXPECT_EQ(components(load(level.animation, level.settings), 1, level.grid, level.sign),
                  level.pieces);
    }
}

} // namespace
} // namespace isomotion::scene
