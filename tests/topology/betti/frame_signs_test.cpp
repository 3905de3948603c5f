// Frames on grids, and which side of a surface is the solid.
#include "topology/betti/frame_signs.h"

#include <gtest/gtest.h>

#include "topology/scenes.h"
#include "topology/solids.h"

namespace isomotion::topology::frame_signs_test {
namespace {

struct Known {
    const char* formula;
    const char* bounds;
    Side side;
    Betti betti;
};

const Known known[] = {
    {"x^2 + y^2 + z^2 - 1", "{ sphere = 1.5 }", Side::negative, {1, 0, 0}},
    {"1 - x^2 - y^2 - z^2",
     "{ box = [[-1.2, -1.2, -1.2], [1.2, 1.3, 1.4]] }",
     Side::positive,
     {1, 0, 0}},
    {"(1 - sqrt(x^2 + y^2))^2 + z^2 - 0.16",
     "{ box = [[-1.65, -1.65, -1.65], [1.65, 1.65, 1.65]] }",
     Side::negative,
     {1, 1, 0}},
    // Eight blobs joined by twelve necks.
    {"x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + 11.8",
     "{ box = [[-2.5, -2.5, -2.5], [2.5, 2.5, 2.5]] }",
     Side::negative,
     {1, 5, 0}},
    // A plane touches the bounds with both sides; the solid is capped.
    {"x + 0.1", "{ sphere = 1 }", Side::negative, {1, 0, 0}},
    {"x^2 - 0.25", "{ box = [[-1, -1, -1], [1, 1, 1]] }", Side::negative, {1, 0, 0}},
    {"0.25 - x^2", "{ box = [[-1, -1, -1], [1, 1, 1]] }", Side::negative, {2, 0, 0}},
};

TEST(FrameSigns, Known) {
    for (const Known& one : known) {
        const scene::Scene scene = still(one.formula, one.bounds);
        EXPECT_EQ(solid_side(scene), one.side) << one.formula;
        const StillScene frame(scene, 0);
        for (int threads : {1, 3}) {
            const SignGrid grid = frame_signs(*scene.surfaces[0].field, frame.numbers, frame.bounds,
                                              one.side, 60, threads);
            EXPECT_EQ(betti(grid), one.betti) << one.formula;
        }
    }
}

TEST(FrameSigns, TheSameForAnyNumberOfThreads) {
    const scene::Scene scene = still("sin(5*x) + sin(6*y) + sin(7*z) - 0.3", "{ sphere = 2 }");
    const StillScene frame(scene, 0);
    const auto signs = [&](int threads) {
        return frame_signs(*scene.surfaces[0].field, frame.numbers, frame.bounds, Side::negative,
                           70, threads);
    };
    EXPECT_EQ(signs(1), signs(4));
}

// What evaluates is used again for the next frame, and keeps nothing of the one before.
TEST(FrameSigns, OfAFrameAfterOthersAreThoseOfTheFrameAlone) {
    const scene::Scene scene = animated("blobby75");
    const FrameSigns signs_of(*scene.surfaces[0].field);
    Work unlimited;
    for (const double time : {2.0, 0.0, 1.3, 0.4, 2.0}) {
        const StillScene frame(scene, time);
        for (const int threads : {2, 1}) {
            EXPECT_EQ(
                signs_of.at(frame.numbers, frame.bounds, Side::positive, 40, threads, unlimited),
                frame_signs(*scene.surfaces[0].field, frame.numbers, frame.bounds, Side::positive,
                            40, 1))
                << time;
        }
    }
}

TEST(FrameSigns, BlobbyFallsTogether) {
    const scene::Scene scene = animated("blobby75");
    EXPECT_EQ(solid_side(scene), Side::positive);
    for (const auto& [time, expected] :
         {std::pair{0.0, Betti{75, 0, 0}}, std::pair{2.0, Betti{1, 0, 0}}}) {
        const StillScene frame(scene, time);
        const SignGrid grid =
            frame_signs(*scene.surfaces[0].field, frame.numbers, frame.bounds, Side::positive, 96);
        EXPECT_EQ(betti(grid), expected) << time;
    }
}

// Elements that are found by place give the signs of all.
TEST(FrameSigns, OfManyElementsAreThoseOfAll) {
    const std::string square = "((x-cx)^2 + (y-cy)^2 + (z-cz)^2)";
    for (const std::string& formula :
         {"sum(p, exp(-900*" + square + ")) - 0.3",
          "sum(p, max(0, 1 - 300*" + square + ")^3) - 0.2", "least(p, sqrt(" + square + ") - 0.03)",
          "sum(p, max(0, 1 - 240*" + square + ")^2*cx) - 0.1*x",
          "min(0.3 - sum(p, exp(-700*" + square + ")), z + 0.2)"}) {
        const scene::Scene scene = scene_of(fmt::format(R"([surface]
formula = '''{}'''
bounds = {{ sphere = 1.3 }}
[arrays.p]
count = 3000
cx = "2*random(i, 1) - 1"
cy = "1.6*random(i, 2) - 0.8"
cz = "random(i, 3) - 0.5"
)",
                                                        formula));
        const scene::SceneAt now = scene::at_frame(scene, 1);
        const FrameSigns by_place(*scene.surfaces[0].field, scene.surfaces[0].animation.counts());
        Work of_near, of_all;
        const auto near = by_place.at(now.surfaces[0], Side::negative, 40, 2, of_near);
        const auto all = FrameSigns(*scene.surfaces[0].field)
                             .at(formula::convert<double>(now.surfaces[0].bindings),
                                 now.surfaces[0].bounds, Side::negative, 40, 2, of_all);
        EXPECT_EQ(near, all) << formula;
        EXPECT_LT(of_near.done(), of_all.done()) << formula;
    }
}

} // namespace
} // namespace isomotion::topology::frame_signs_test
