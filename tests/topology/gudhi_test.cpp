// Betti numbers of grids against GUDHI's persistent homology of a cubical complex.
//
// GUDHI's cells are closed cubes, which meet in corners too: not Kuhn's complex. Bricks are: of
// size 4 by 2 by 1, each layer shifted against the one below, they meet exactly where vertices are
// neighbours, and boxes that meet pairwise have a point in common. So the bricks of a solid have
// the homotopy type of its complex (nerve theorem), for any grid, and are cubes four times as many.
#include <numbers>

#include <gtest/gtest.h>

// Its headers' warnings are theirs.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Woverloaded-virtual"
#include <gudhi/Bitmap_cubical_complex.h>
#include <gudhi/Bitmap_cubical_complex_base.h>
#include <gudhi/Persistent_cohomology.h>
#pragma GCC diagnostic pop

#include "topology/sign_grid.h"
#include "topology/solids.h"
#include "unit/formula/testing.h"

namespace isomotion::topology {
namespace {

// Of the union of closed cubes whose value is 0; x runs fastest.
Betti betti_of_cubes(const std::vector<unsigned>& sizes, const std::vector<double>& cubes) {
    using Complex = Gudhi::cubical_complex::Bitmap_cubical_complex<
        Gudhi::cubical_complex::Bitmap_cubical_complex_base<double>>;
    Complex complex(sizes, cubes);
    Gudhi::persistent_cohomology::Persistent_cohomology<Complex,
                                                        Gudhi::persistent_cohomology::Field_Zp>
        cohomology(complex);
    cohomology.init_coefficients(2);
    cohomology.compute_persistent_cohomology(-1);
    const std::vector<int> b = cohomology.persistent_betti_numbers(0, 0.5);
    return {b.at(0), b.at(1), b.at(2)};
}

Betti betti_by_bricks(const SignGrid& grid) {
    const int n = grid.side();
    // Brick (x, y, z) begins at (4x - 2y - z, 2y - z, z).
    const int nx = 4 * n + 2 * n + n + 2, ny = 2 * n + n + 2, nz = n + 2;
    std::vector<double> cubes(std::size_t(nx) * std::size_t(ny) * std::size_t(nz), 1.0);
    for (int z = 0; z < n; ++z) {
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                if (!grid.at(x, y, z)) continue;
                const int i = 1 + 4 * x + 2 * (n - 1 - y) + (n - 1 - z);
                const int j = 1 + 2 * y + (n - 1 - z), k = 1 + z;
                for (int dy = 0; dy < 2; ++dy) {
                    for (int dx = 0; dx < 4; ++dx) {
                        cubes[(std::size_t(k) * std::size_t(ny) + std::size_t(j + dy)) *
                                  std::size_t(nx) +
                              std::size_t(i + dx)] = 0;
                    }
                }
            }
        }
    }
    return betti_of_cubes({unsigned(nx), unsigned(ny), unsigned(nz)}, cubes);
}

TEST(Gudhi, Noise) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        formula::Random random(seed);
        const double density = random.in(0.1, 0.9);
        const SignGrid grid =
            grid_of(11, [&](const glm::dvec3&) { return random.in(0, 1) < density; });
        EXPECT_EQ(betti(grid), betti_by_bricks(grid)) << "seed " << seed;
    }
}

// Waves in all directions, cut off by a ball.
TEST(Gudhi, Waves) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        formula::Random random(seed);
        struct Wave {
            glm::dvec3 vector;
            double phase;
        };
        std::vector<Wave> waves(8);
        for (Wave& wave : waves) {
            const auto v = random.point(8);
            wave = {{v[0], v[1], v[2]}, random.in(0, 2 * std::numbers::pi)};
        }
        const SignGrid grid = grid_of(15, [&](const glm::dvec3& p) {
            double f = 0;
            for (const Wave& wave : waves) f += std::sin(glm::dot(wave.vector, p) + wave.phase);
            return f < -0.3 && glm::length(p) < 0.95;
        });
        EXPECT_EQ(betti(grid), betti_by_bricks(grid)) << "seed " << seed;
    }
}

} // namespace
} // namespace isomotion::topology
