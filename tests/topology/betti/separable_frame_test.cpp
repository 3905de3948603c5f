// Betti numbers of sums of functions of one coordinate each: closed forms, other proofs' numbers,
// and what must not be proved.
#include "topology/betti/separable_frame.h"

#include <random>

#include <gtest/gtest.h>

#include "topology/betti/cell_frame.h"
#include "topology/scenes.h"

namespace isomotion::topology {
namespace {

const std::string larger_box = "{ box = [[-1.1, -1.1, -1.1], [1.1, 1.1, 1.1]] }";

CertifiedFrame separable(const std::string& formula, const std::string& bounds = larger_box,
                         Side side = Side::negative) {
    const scene::Scene scene = still(formula, bounds);
    const StillScene frame(scene, 0);
    return certify_separable(frame.formula(side), frame.bounds);
}

std::string chmutov(int degree, double c) {
    return fmt::format("chebyshev({0}, x) + chebyshev({0}, y) + chebyshev({0}, z) + {1}", degree,
                       c);
}

TEST(SeparableFrame, OfChmutovsSurfacesAreThoseOfALatticeOfBlobs) {
    for (const int degree : {6, 22, 50}) {
        // T has n minima and n - 1 maxima: n^3 blobs, joined by necks along the edges of a lattice,
        // later by films across its squares.
        const int n = degree / 2, blobs = n * n * n, necks = 3 * n * n * (n - 1);
        const int films = 3 * n * (n - 1) * (n - 1), cells = (n - 1) * (n - 1) * (n - 1);
        EXPECT_EQ(separable(chmutov(degree, 2)).betti, (Betti{blobs, 0, 0})) << degree;
        EXPECT_EQ(separable(chmutov(degree, 0.3)).betti, (Betti{1, necks - blobs + 1, 0}))
            << degree;
        EXPECT_EQ(separable(chmutov(degree, -2)).betti, (Betti{1, 0, cells})) << degree;
        EXPECT_EQ(separable(chmutov(degree, -3.1)).betti, (Betti{1, 0, 0})) << degree;
        EXPECT_EQ(separable(chmutov(degree, 3.1)).betti, (Betti{0, 0, 0})) << degree;
        EXPECT_EQ(necks - blobs + 1 - films, -cells);
    }
}

// Those of the boxes that cut the surface, on either side of it.
TEST(SeparableFrame, OfRandomSumsAreThoseByCells) {
    int proved = 0;
    for (unsigned seed = 1; seed <= 12; ++seed) {
        std::mt19937_64 random(seed);
        const auto number = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(random);
        };
        std::string formula = fmt::format("{:.3f}", number(-1.5, 1.5));
        for (const char* x : {"x", "y", "z"}) {
            formula +=
                fmt::format(" + {:.3f}*sin({:.3f}*{} + {:.3f}) + {:.3f}*{}", number(0.5, 1.5),
                            number(1, 6), x, number(-3, 3), number(-0.3, 0.3), x);
        }
        const std::string bounds = "{ box = [[-1.3, -1.2, -1], [1.4, 1.1, 1.2]] }";
        const scene::Scene scene = still(formula, bounds);
        const StillScene frame(scene, 0);
        for (const Side side : {Side::negative, Side::positive}) {
            const CertifiedFrame found = separable(formula, bounds, side);
            if (!found.betti) continue;
            ++proved;
            const CertifiedFrame by_cells = certify_by_cells(frame.formula(side), frame.bounds, {});
            ASSERT_TRUE(by_cells.betti) << by_cells.why;
            EXPECT_EQ(*found.betti, *by_cells.betti) << "seed " << seed << ": " << formula;
        }
    }
    EXPECT_GT(proved, 20);
}

TEST(SeparableFrame, IsNoneOfWhatIsSingularOrNoSum) {
    for (const std::string& formula :
         {chmutov(6, 1), chmutov(6, -1), std::string("x^2 + y^2 - z^2"),
          std::string("x^2 + y^2 + z^2 - 1.21"), // touches the walls
          std::string("x*y + z"), std::string("x^3 + y + z"),
          std::string("floor(3*x) + y + z + 0.5"), std::string("(x + y)^2 + z - 0.1"),
          std::string("1/x + y + z")}) {
        EXPECT_FALSE(separable(formula).betti) << formula;
    }
    // A sphere of bounds cuts what is a sum within it.
    EXPECT_FALSE(separable("x^2 + y^2 + z^2 - 1", "{ sphere = 2 }").betti);
}

} // namespace
} // namespace isomotion::topology
