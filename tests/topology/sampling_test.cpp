// Frames on grids that get coarser where all of them would take too much.
#include "topology/sampling.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "topology/analyse.h"
#include "topology/scenes.h"

namespace isomotion::topology {
namespace {

// Two balls that touch after half of a second, in a formula of so many terms.
scene::Scene balls(int terms, int frames) {
    return scene_of(fmt::format(
        "[surface]\n"
        "formula = 'min((x-0.6)^2, (x+0.6)^2) + y^2 + z^2 - r^2 + sum(b, 1e-12*sin(k*x))'\n"
        "bounds = {{ box = [[-1.5, -1.5, -1.5], [1.5, 1.5, 1.5]] }}\n"
        "[parameters]\nr = '0.4 + 0.4*t'\n"
        "[arrays.b]\ncount = {}\nk = 'i'\n"
        "[time]\nframes = {}\nfps = {}\n",
        terms, frames, frames - 1));
}

Sampling all(const scene::Scene& scene) {
    Sampling sampling;
    sampling.last = scene.timeline.frames;
    return sampling;
}

std::string grid_of(const Timeline& timeline) {
    const std::string& text = timeline.doubts.front();
    const auto at = text.find("grid of ") + 8;
    return text.substr(at, text.find(',') - at);
}

TEST(Sampling, TellsBetweenWhichFramesSomethingChanges) {
    const scene::Scene scene = balls(1, 31);
    const Timeline timeline = sampled(scene, Side::negative, all(scene));
    EXPECT_EQ(grid_of(timeline), "64x64x64");
    EXPECT_EQ(timeline.start, (Betti{2, 0, 0}));
    EXPECT_EQ(timeline.end, (Betti{1, 0, 0}));
    ASSERT_EQ(timeline.unresolved.size(), 1u);
    // They touch at 0.5 s. A cube of the grid, 0.05 wide, is as much as the radius changes in 0.12
    // s.
    const formula::Interval time = timeline.unresolved[0].time;
    EXPECT_NEAR(mid(time), 0.5, 0.12);
    EXPECT_NEAR(time.hi - time.lo, 1.0 / 30, 1e-9);
}

TEST(Sampling, GetsCoarserWhereItWouldTakeLong) {
    const scene::Scene scene = balls(100, 4);
    Sampling sampling = all(scene);
    std::vector<std::string> grids;
    for (sampling.most_operations = 1e10;; sampling.most_operations /= 2) {
        try {
            const std::string grid = grid_of(sampled(scene, Side::negative, sampling));
            if (grids.empty() || grids.back() != grid) grids.push_back(grid);
        } catch (const std::invalid_argument& error) {
            EXPECT_NE(std::string(error.what()).find("search fewer --frames"), std::string::npos);
            break;
        }
    }
    EXPECT_EQ(grids, (std::vector<std::string>{"64x64x64", "32x32x32", "16x16x16"}));
}

TEST(Sampling, AGridThatIsAskedForIsTaken) {
    const scene::Scene scene = balls(2, 2);
    Sampling sampling = all(scene);
    sampling.most_operations = 1;
    EXPECT_THROW(sampled(scene, Side::negative, sampling), std::invalid_argument);
    sampling.grid = 8;
    EXPECT_EQ(grid_of(sampled(scene, Side::negative, sampling)), "8x8x8");
}

// Sums of kernels are found by place; seeds would sum all of them at each step.
TEST(Sampling, TakesElementsThatSeedsCannot) {
    const scene::Scene scene =
        scene_of("[surface]\n"
                 "formula = 'sum(p, max(0, 1 - 900*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))^3) - 0.3'\n"
                 "bounds = { sphere = 1.8 }\n"
                 "[arrays.p]\ncount = 60000\n"
                 "cx = '2*random(i, 1) - 1'\ncy = '2*random(i, 2) - 1'\ncz = '2*random(i, 3) - 1'\n"
                 "[time]\nframes = 2\n");
    AnalyseOptions how;
    how.certify = Certify::off;
    const Timeline timeline = analyse(scene, how);
    EXPECT_EQ(grid_of(timeline), "64x64x64");
    ASSERT_TRUE(timeline.start);
    EXPECT_GT(timeline.start->components, 10);
    how.certify = Certify::fast;
    try {
        analyse(scene, how);
        FAIL() << "took all";
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("take --certify off"), std::string::npos);
    }
}

TEST(Sampling, InterruptedIsSaid) {
    const scene::Scene scene = balls(1, 31);
    Sampling sampling = all(scene);
    int asked = 0;
    sampling.stopped = [&] { return ++asked > 50; };
    sampling.threads = 1;
    const Timeline timeline = sampled(scene, Side::negative, sampling);
    EXPECT_EQ(timeline.doubts.back(), "interrupted");
    EXPECT_EQ(timeline.start, (Betti{2, 0, 0}));
    EXPECT_TRUE(timeline.unresolved.empty());
}

} // namespace
} // namespace isomotion::topology
