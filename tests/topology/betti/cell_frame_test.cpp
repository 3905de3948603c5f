// Frames proved by cells: closed forms of solids with edges, corners, needles and cones, and at
// random the same numbers as grids prove.
#include "topology/betti/cell_frame.h"

#include <random>

#include <gtest/gtest.h>

#include "cut_solids.h"
#include "topology/scenes.h"
#include "topology/solids.h"

namespace isomotion::topology {
namespace {

const std::string cube = "{ box = [[-2, -2, -2], [2, 2, 2]] }";

CertifiedFrame by_cells(const scene::Scene& scene) {
    const StillScene frame(scene, 0);
    return certify_by_cells(frame.formula(solid_side(scene)), frame.bounds, {});
}

TEST(CellFrame, ProvesClosedForms) {
    const struct {
        const char* formula;
        Betti betti;
    } known[] = {
        {"x^2 + y^2 + z^2 - 1", {1, 0, 0}},
        {"x^2 + y^2 + z^2 + 1", {0, 0, 0}},
        {"max(max(abs(x), abs(y)), abs(z)) - 1", {1, 0, 0}},
        {"max(max(abs(0.6*x + 0.8*y), abs(0.8*x - 0.6*y)), abs(z)) - 1", {1, 0, 0}},
        {"max(max(abs(2*x+2*y+z), abs(x-2*y+2*z)), abs(2*x-y-2*z)) - 2", {1, 0, 0}},
        {"abs(x) + abs(y) + abs(z) - 1", {1, 0, 0}},
        {"abs(x)^0.7 + abs(y)^0.7 + abs(z)^0.7 - 1", {1, 0, 0}},
        {"(sqrt(x^2 + y^2) - 1)^2 + z^2 - 0.1", {1, 1, 0}},
        {"(sqrt(x^2 + y^2) - 0.2)^2 + z^2 - 0.09", {1, 0, 0}},
        {"abs(sqrt(x^2 + y^2 + z^2) - 1) - 0.2", {1, 0, 1}},
        {"min(x^2 + y^2 + (z-0.5)^2 - 0.5, x^2 + y^2 + (z+0.5)^2 - 0.5)", {1, 0, 0}},
        {"max(x^2 + y^2 + z^2 - 1, 0.3 - x^2 - y^2)", {1, 1, 0}},
        // A cube with three holes that meet in its middle.
        {"max(max(max(abs(x), abs(y)), abs(z)) - 1, "
         "max(0.16 - x^2 - y^2, max(0.16 - y^2 - z^2, 0.16 - z^2 - x^2)))",
         {1, 5, 0}},
        {"max(max(max(abs(x), abs(y)), abs(z)) - 1, 0.6 - max(max(abs(x), abs(y)), abs(z)))",
         {1, 0, 1}},
        {"max(abs(z) - 0.2, sqrt(x^2 + y^2) - 1)", {1, 0, 0}},
        {"sqrt(x^2 + y^2) + abs(z) - 1", {1, 0, 0}},
    };
    for (const auto& [formula, betti] : known) {
        SCOPED_TRACE(formula);
        const CertifiedFrame frame = by_cells(still(formula, cube));
        ASSERT_TRUE(frame.betti) << fmt::format(
            "{} at [{}, {}] [{}, {}] [{}, {}]", frame.why, frame.where[0].lo, frame.where[0].hi,
            frame.where[1].lo, frame.where[1].hi, frame.where[2].lo, frame.where[2].hi);
        EXPECT_EQ(*frame.betti, betti);
    }
}

TEST(CellFrame, TakesTheSolidToTheWalls) {
    EXPECT_EQ(by_cells(still("max(z - 0.3, 0.3 - x^2 - y^2)", cube)).betti, (Betti{1, 1, 0}));
    EXPECT_EQ(by_cells(still("max(z - 0.3, -z - 0.35)", cube)).betti, (Betti{1, 0, 0}));
    EXPECT_EQ(by_cells(still("x^2 + y^2 + z^2 - 1", "{ sphere = 1.5 }")).betti, (Betti{1, 0, 0}));
}

TEST(CellFrame, TakesTheSolidToASphere) {
    std::vector<CutSolid> known(std::begin(cut_solids), std::end(cut_solids));
    known.insert(known.end(), {
                                  {"0.2 - abs(z - 0.1*x)", {2, 0, 0}},
                                  {"abs(z - 0.1*x) - 0.2", {1, 0, 0}},
                                  {"max(abs(z) - 0.2, 0.1 - x^2 - y^2)", {1, 1, 0}},
                              });
    for (const auto& [formula, betti] : known) {
        SCOPED_TRACE(formula);
        const StillScene frame(still(formula, "{ sphere = 1.2 }"), 0);
        const CertifiedFrame proved =
            certify_by_cells(frame.formula(Side::negative), frame.bounds, {});
        ASSERT_TRUE(proved.betti) << proved.why;
        EXPECT_EQ(*proved.betti, betti);
    }
}

// The same solid as the greater of two functions in a box.
TEST(CellFrame, TakesASphereForAWall) {
    for (unsigned seed = 1; seed <= 6; ++seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> number(-1, 1);
        std::string formula = fmt::format("{:.3f}", 0.1 * number(random));
        for (int wave = 0; wave < 4; ++wave) {
            formula += fmt::format(" + {:.3f}*sin({:.3f}*x + {:.3f}*y + {:.3f}*z + {:.3f})",
                                   number(random), 2 * number(random), 2 * number(random),
                                   2 * number(random), 3 * number(random));
        }
        SCOPED_TRACE(fmt::format("seed {}: {}", seed, formula));
        const StillScene in_ball(still(formula, "{ sphere = 1.7, centre = [0.1, -0.2, 0] }"), 0);
        const StillScene in_box(
            still(fmt::format("max({}, (x - 0.1)^2 + (y + 0.2)^2 + z^2 - 1.7^2)", formula), cube),
            0);
        const CertifiedFrame a =
            certify_by_cells(in_ball.formula(Side::negative), in_ball.bounds, {});
        const CertifiedFrame b =
            certify_by_cells(in_box.formula(Side::negative), in_box.bounds, {});
        ASSERT_TRUE(a.betti) << a.why;
        ASSERT_TRUE(b.betti) << b.why;
        EXPECT_EQ(*a.betti, *b.betti);
    }
}

TEST(CellFrame, ProvesNothingOfSingularPoints) {
    for (const char* formula : {"x^2 + y^2 - z^2", "min((x-0.7)^2 + y^2 + z^2 - 0.49, "
                                                   "(x+0.7)^2 + y^2 + z^2 - 0.49)"})
        EXPECT_FALSE(by_cells(still(formula, cube)).betti) << formula;
}

TEST(CellFrame, IsNotWrongOfFormulasThatJump) {
    for (const char* formula :
         {"sign((x-0.3)^2 + y^2 + z^2 - 0.01)", "floor(1 + 4*((x-0.3)^2 + y^2 + z^2 - 0.01)) - 0.5",
          "x^2 + y^2 + z^2 - 0.5 + 0.3*sign((x-0.3)^2 + (y-0.2)^2 + z^2 - 0.01)"}) {
        const CertifiedFrame frame = by_cells(still(formula, cube));
        if (frame.betti) {
            EXPECT_EQ(*frame.betti, (Betti{1, 0, 0})) << formula;
        }
    }
}

// Next to 10^8 doubles are further apart than values of this plane: no corner has a sign.
TEST(CellFrame, ProvesNothingOfSignsLostInRounding) {
    const CertifiedFrame frame =
        by_cells(still("(1e8 + 1e-10*(x + 0.3*y + 0.2*z - 0.01)) - 1e8", cube));
    EXPECT_FALSE(frame.betti) << frame.depth;
}

// Along y this rises everywhere; where it jumps, it is no less unknown.
TEST(CellFrame, SettlesNothingAcrossAJump) {
    EXPECT_FALSE(by_cells(still("y + 0.3 + 0.4*sign(x - 0.1)", cube)).betti);
    EXPECT_TRUE(by_cells(still("y + 0.3 + 0.4*atan(x - 0.1)", cube)).betti);
}

// Two proofs that have little in common.
TEST(CellFrame, AgreesWithGrids) {
    int compared = 0;
    for (unsigned seed = 1; seed <= 16; ++seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> number(-1, 1);
        std::string formula = fmt::format("{:.3f}", 0.2 * number(random));
        for (int wave = 0; wave < 5; ++wave) {
            formula += fmt::format(" + {:.3f}*sin({:.3f}*x + {:.3f}*y + {:.3f}*z + {:.3f})",
                                   number(random), 2 * number(random), 2 * number(random),
                                   2 * number(random), 3 * number(random));
        }
        SCOPED_TRACE(fmt::format("seed {}: {}", seed, formula));
        const StillScene frame(still(formula, cube), 0);
        // The walls are off the cells' own: both prove the same part of the surface.
        const auto solid = frame.formula(Side::negative);
        const CertifiedFrame cells = certify_by_cells(solid, frame.bounds, {});
        const CertifiedFrame grid = certify_frame(solid, frame.bounds, {});
        if (!cells.betti || !grid.betti) continue;
        EXPECT_EQ(*cells.betti, *grid.betti);
        ++compared;
    }
    EXPECT_GE(compared, 10);
}

} // namespace
} // namespace isomotion::topology
