// Betti numbers of grids against GUDHI's persistent homology, of two complexes.
//
// One is Kuhn's, as a simplex tree of the solid's simplices alone: edges between neighbours, and
// all that these make, for its simplices are the sets of vertices any two of which are neighbours.
//
// The other one doesn't know of Kuhn's.
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
#include <gudhi/Simplex_tree.h>
#pragma GCC diagnostic pop

#include "thorough.h"
#include "topology/betti/sign_grid.h"
#include "topology/solids.h"
#include "unit/formula/testing.h"

namespace isomotion::topology {
namespace {

// The Betti numbers of the union of closed cubes whose value is 0; x runs fastest.
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

Betti betti_by_simplices(const SignGrid& grid) {
    const int n = grid.side();
    Gudhi::Simplex_tree<> tree;
    const auto is_in = [&](int x, int y, int z) {
        return x < n && y < n && z < n && grid.at(x, y, z);
    };
    const auto vertex = [&](int x, int y, int z) { return (z * n + y) * n + x; };
    for (int z = 0; z < n; ++z) {
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                if (is_in(x, y, z)) tree.insert_simplex(std::array{vertex(x, y, z)});
            }
        }
    }
    for (int z = 0; z < n; ++z) {
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                if (!is_in(x, y, z)) continue;
                for (int step = 1; step < 8; ++step) {
                    const int i = x + (step & 1), j = y + (step >> 1 & 1), k = z + (step >> 2);
                    if (is_in(i, j, k))
                        tree.insert_simplex(std::array{vertex(x, y, z), vertex(i, j, k)});
                }
            }
        }
    }
    tree.expansion(3);
    Gudhi::persistent_cohomology::Persistent_cohomology<Gudhi::Simplex_tree<>,
                                                        Gudhi::persistent_cohomology::Field_Zp>
        cohomology(tree, /*persistence_dim_max=*/true);
    cohomology.init_coefficients(2);
    cohomology.compute_persistent_cohomology();
    return {cohomology.betti_number(0), cohomology.betti_number(1), cohomology.betti_number(2)};
}

// Waves in all directions, cut off by a ball.
SignGrid waves(int side, std::uint64_t seed, double reach, double level) {
    formula::Random random(seed);
    struct Wave {
        glm::dvec3 vector;
        double phase;
    };
    std::vector<Wave> waves(8);
    for (Wave& wave : waves) {
        const auto v = random.point(reach);
        wave = {{v[0], v[1], v[2]}, random.in(0, 2 * std::numbers::pi)};
    }
    return grid_of(side, [&](const glm::dvec3& p) {
        double f = 0;
        for (const Wave& wave : waves) f += std::sin(glm::dot(wave.vector, p) + wave.phase);
        return f < level && glm::length(p) < 0.95;
    });
}

TEST(Gudhi, Noise) {
    for (std::uint64_t seed = 1; seed <= std::uint64_t(trials(4, 10)); ++seed) {
        formula::Random random(seed);
        const double density = random.in(0.1, 0.9);
        const SignGrid grid =
            grid_of(11, [&](const glm::dvec3&) { return random.in(0, 1) < density; });
        EXPECT_EQ(betti(grid), betti_by_bricks(grid)) << "seed " << seed;
    }
}

TEST(Gudhi, Waves) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const SignGrid grid = waves(15, seed, 8, -0.3);
        const Betti expected = betti_by_bricks(grid);
        EXPECT_EQ(betti(grid), expected) << "seed " << seed;
        EXPECT_EQ(betti_by_simplices(grid), expected) << "seed " << seed;
    }
}

// Ten of noise and ten of waves, with hundreds of components, tunnels and voids.
TEST(Gudhi, LargeGrids) {
    constexpr int side = 48;
    Betti most{};
    const auto expect_same = [&](const SignGrid& grid) {
        const Betti found = betti(grid);
        EXPECT_EQ(found, betti_by_simplices(grid));
        most.components = std::max(most.components, found.components);
        most.tunnels = std::max(most.tunnels, found.tunnels);
        most.voids = std::max(most.voids, found.voids);
    };
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        formula::Random random(seed);
        const double density = random.in(0.05, 0.4);
        expect_same(grid_of(side, [&](const glm::dvec3&) { return random.in(0, 1) < density; }));
        expect_same(waves(side, seed, 30, random.in(-3, 0)));
    }
    EXPECT_GT(most.components, 100);
    EXPECT_GT(most.tunnels, 100);
    EXPECT_GT(most.voids, 0);
}

} // namespace
} // namespace isomotion::topology
