// Betti numbers of grids: closed forms, and a count by definition over Kuhn's complex.
#include "topology/betti/sign_grid.h"

#include <gtest/gtest.h>

#include "topology/solids.h"
#include "unit/formula/testing.h"

namespace isomotion::topology {
namespace {

using Vertex = std::array<int, 3>;

// Simplices one by one, components by flooding.
class ByDefinition {
public:
    explicit ByDefinition(const SignGrid& grid)
        : grid_(grid)
        , side_(grid.side() + 2) {}

    Betti betti() const {
        Betti b;
        b.components = components(true);
        b.voids = components(false) - 1;
        b.tunnels = b.components + b.voids - euler();
        return b;
    }

private:
    bool solid(const Vertex& v) const { // with a layer around
        for (int c : v) {
            if (c < 1 || c > grid_.side()) return false;
        }
        return grid_.at(v[0] - 1, v[1] - 1, v[2] - 1);
    }

    int euler() const {
        int chi = 0;
        each([&](const Vertex& v) { chi += chains(v, 0); });
        return chi;
    }
    // Counts simplices that begin with v + corner and go on along chains of corners. Those of odd
    // dimension count as -1.
    int chains(const Vertex& v, int corner) const {
        const Vertex at{v[0] + (corner & 1), v[1] + (corner >> 1 & 1), v[2] + (corner >> 2)};
        if (!solid(at)) return 0;
        int chi = 1;
        for (int next = corner + 1; next < 8; ++next) {
            if ((next & corner) == corner) chi -= chains(v, next);
        }
        return chi;
    }

    int components(bool of_solid) const {
        std::vector<bool> seen(std::size_t(side_) * std::size_t(side_) * std::size_t(side_));
        const auto index = [&](const Vertex& v) {
            return (std::size_t(v[2]) * std::size_t(side_) + std::size_t(v[1])) *
                       std::size_t(side_) +
                   std::size_t(v[0]);
        };
        int count = 0;
        each([&](const Vertex& from) {
            if (solid(from) != of_solid || seen[index(from)]) return;
            ++count;
            std::vector<Vertex> stack{from};
            seen[index(from)] = true;
            while (!stack.empty()) {
                const Vertex v = stack.back();
                stack.pop_back();
                for (int corner = 1; corner < 8; ++corner) {
                    for (int sign : {-1, 1}) {
                        const Vertex to{v[0] + sign * (corner & 1), v[1] + sign * (corner >> 1 & 1),
                                        v[2] + sign * (corner >> 2)};
                        bool inside = true;
                        for (int c : to) inside &= c >= 0 && c < side_;
                        if (!inside || solid(to) != of_solid || seen[index(to)]) continue;
                        seen[index(to)] = true;
                        stack.push_back(to);
                    }
                }
            }
        });
        return count;
    }

    template<class Visit> void each(Visit&& visit) const {
        for (int z = 0; z < side_; ++z) {
            for (int y = 0; y < side_; ++y) {
                for (int x = 0; x < side_; ++x) visit(Vertex{x, y, z});
            }
        }
    }

    const SignGrid& grid_;
    int side_;
};

TEST(SignGrid, EmptyAndFull) {
    for (int side : {1, 2, 63, 64, 65, 128, 129}) {
        SignGrid grid(side);
        EXPECT_EQ(betti(grid), (Betti{0, 0, 0})) << side;
        for (int z = 0; z < side; ++z) {
            for (int y = 0; y < side; ++y) grid.set_run(0, side - 1, y, z);
        }
        EXPECT_EQ(betti(grid), (Betti{1, 0, 0})) << side;
        EXPECT_TRUE(grid.at(side - 1, side - 1, side - 1));
    }
}

TEST(SignGrid, RunsAreSetBitByBit) {
    formula::Random random(1);
    for (int trial = 0; trial < 200; ++trial) {
        const int side = 1 + random.below(140);
        int first = random.below(side), last = random.below(side);
        SignGrid by_run(side), by_bit(side);
        by_run.set_run(first, last, 0, side - 1);
        for (int x = first; x <= last; ++x) by_bit.set(x, 0, side - 1);
        EXPECT_EQ(by_run, by_bit) << side << ": " << first << " to " << last;
    }
}

TEST(SignGrid, AllSignsOfOneCube) {
    for (int signs = 0; signs < 256; ++signs) {
        SignGrid grid(2);
        for (int corner = 0; corner < 8; ++corner) {
            if (signs >> corner & 1) grid.set(corner & 1, corner >> 1 & 1, corner >> 2);
        }
        EXPECT_EQ(betti(grid), ByDefinition(grid).betti()) << signs;
    }
}

// The long diagonal is an edge, the other three are not.
TEST(SignGrid, DiagonalsOfACube) {
    for (int corner = 0; corner < 4; ++corner) {
        SignGrid grid(2);
        grid.set(corner & 1, corner >> 1, 0);
        grid.set(~corner & 1, ~corner >> 1 & 1, 1);
        EXPECT_EQ(betti(grid).components, corner == 0 ? 1 : 2);
    }
}

TEST(SignGrid, NoiseByDefinition) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        formula::Random random(seed);
        const int side = 3 + random.below(12);
        const double density = random.in(0.05, 0.95);
        SignGrid grid(side);
        for (int z = 0; z < side; ++z) {
            for (int y = 0; y < side; ++y) {
                for (int x = 0; x < side; ++x) {
                    if (random.in(0, 1) < density) grid.set(x, y, z);
                }
            }
        }
        EXPECT_EQ(betti(grid), ByDefinition(grid).betti()) << "seed " << seed;
    }
}

// Rows of more than one word, runs across the words' ends.
TEST(SignGrid, NoiseInLongRows) {
    for (int side : {64, 65, 70}) {
        formula::Random random{std::uint64_t(side)};
        SignGrid grid(side);
        for (int z = 0; z < side; ++z) {
            for (int y = 0; y < side; ++y) {
                for (int x = 0; x < side; ++x) {
                    if (random.in(0, 1) < 0.4) grid.set(x, y, z);
                }
            }
        }
        EXPECT_EQ(betti(grid), ByDefinition(grid).betti()) << side;
    }
}

struct ClosedForm {
    const char* name;
    Betti betti;
    bool (*is_solid)(const glm::dvec3&);
};

const ClosedForm closed_forms[] = {
    {"ball",
     {1, 0, 0},
     [](const glm::dvec3& p) {
         return in_ball(p, {0.1, 0, 0}, 0.7);
     }},
    {"torus",
     {1, 1, 0},
     [](const glm::dvec3& p) {
         return in_torus(p, {0, 0.1, 0}, 0.6, 0.2);
     }},
    {"shell",
     {1, 0, 1},
     [](const glm::dvec3& p) { return in_ball(p, {}, 0.8) && !in_ball(p, {}, 0.5); }},
    {"nested shells",
     {3, 0, 2},
     [](const glm::dvec3& p) {
         const double r = glm::length(p);
         return r < 0.2 || (0.35 < r && r < 0.55) || (0.7 < r && r < 0.9);
     }},
    {"shell with a torus for its void",
     {1, 1, 1},
     [](const glm::dvec3& p) { return in_ball(p, {}, 0.95) && !in_torus(p, {}, 0.5, 0.2); }},
    {"genus 2",
     {1, 2, 0},
     [](const glm::dvec3& p) {
         return in_torus(p, {-0.4, 0, 0}, 0.35, 0.15) || in_torus(p, {0.4, 0, 0}, 0.35, 0.15);
     }},
    {"two linked rings",
     {2, 2, 0},
     [](const glm::dvec3& p) {
         const glm::dvec3 turned(p.x, p.z, p.y);
         return in_torus(p, {-0.25, 0, 0}, 0.5, 0.12) || in_torus(turned, {0.25, 0, 0}, 0.5, 0.12);
     }},
    {"trefoil", {1, 1, 0}, [](const glm::dvec3& p) { return in_torus_knot(p, 3, 2, 0.1); }},
    {"cinquefoil", {1, 1, 0}, [](const glm::dvec3& p) { return in_torus_knot(p, 5, 2, 0.08); }},
    {"what is left by a trefoil",
     {1, 1, 1},
     [](const glm::dvec3& p) { return in_ball(p, {}, 0.99) && !in_torus_knot(p, 3, 2, 0.1); }},
    {"cut off by the bounds",
     {1, 0, 0},
     [](const glm::dvec3& p) {
         return in_ball(p, {1, 1, 0}, 0.9);
     }},
    // Three pipes from wall to wall leave the middle of a cube: a solid of genus 5.
    {"cube with pipes",
     {1, 5, 0},
     [](const glm::dvec3& p) {
         const double r = 0.3;
         return std::hypot(p.x, p.y) > r && std::hypot(p.y, p.z) > r && std::hypot(p.z, p.x) > r;
     }},
};

TEST(SignGrid, ClosedForms) {
    for (const ClosedForm& form : closed_forms) {
        for (int side : {40, 57}) {
            EXPECT_EQ(betti(grid_of(side, form.is_solid)), form.betti) << form.name << ' ' << side;
        }
    }
}

// The solid and its complement trade components for voids: of a shell around both.
TEST(SignGrid, Duality) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        formula::Random random(seed);
        SignGrid solid(14), rest(14);
        for (int z = 0; z < 14; ++z) {
            for (int y = 0; y < 14; ++y) {
                for (int x = 0; x < 14; ++x) {
                    const bool inside = x % 13 && y % 13 && z % 13;
                    (inside && random.in(0, 1) < 0.5 ? solid : rest).set(x, y, z);
                }
            }
        }
        const Betti a = betti(solid), b = betti(rest);
        EXPECT_EQ(a.components, b.voids) << "seed " << seed;
        EXPECT_EQ(a.voids + 1, b.components) << "seed " << seed;
        EXPECT_EQ(a.tunnels, b.tunnels) << "seed " << seed;
    }
}

} // namespace
} // namespace isomotion::topology
