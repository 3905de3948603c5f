// Betti numbers counted over cells: of solids made of whole cells, against their closed forms.
#include "topology/betti/cell_complex.h"

#include <gtest/gtest.h>

#include "topology/solids.h"

namespace isomotion::topology {
namespace {

// S is what is inside of cells of a level by a predicate of their number along each axis.
template<class Predicate> std::optional<Betti> betti_of(int level, Predicate&& is_solid) {
    CellComplex complex([&](const CellKey& key) {
        CellFact fact;
        if (key.level < level) return fact;
        // Lower cells are in S where all cells about them are: S is open.
        const int length = CellKey::whole >> level;
        bool is_inside = true;
        for (int x = -1; x <= 0; ++x) {
            for (int y = -1; y <= 0; ++y) {
                for (int z = -1; z <= 0; ++z) {
                    std::array<int, 3> cell{};
                    bool counts = true;
                    for (std::size_t k = 0; k < 3; ++k) {
                        const int step = k == 0 ? x : k == 1 ? y : z;
                        const bool is_face = !key.is_along(k) && key.at[k] % length == 0;
                        if (step != 0 && !is_face) counts = false;
                        cell[k] = key.at[k] / length + step;
                        if (cell[k] < 0 || cell[k] >= 1 << level) counts = false;
                    }
                    if (counts) is_inside = is_inside && is_solid(cell);
                }
            }
        }
        fact.kind = is_inside ? CellFact::Kind::inside : CellFact::Kind::outside;
        return fact;
    });
    return complex.betti({});
}

TEST(CellComplex, CountsComponentsTunnelsAndVoids) {
    EXPECT_EQ(betti_of(2, [](auto) { return false; }), (Betti{0, 0, 0}));
    EXPECT_EQ(betti_of(2, [](auto) { return true; }), (Betti{1, 0, 0}));
    EXPECT_EQ(betti_of(3, [](auto c) { return c[0] % 2 == 0; }), (Betti{4, 0, 0}));
    const auto in = [](std::array<int, 3> c, int low, int high) {
        return std::ranges::all_of(c, [&](int k) { return k >= low && k < high; });
    };
    EXPECT_EQ(betti_of(3, [&](auto c) { return !in(c, 3, 5); }), (Betti{1, 0, 1}));
    EXPECT_EQ(betti_of(3, [&](auto c) { return in(c, 1, 7) && !in(c, 3, 5); }), (Betti{1, 0, 1}));
    // A hole from wall to wall, and three that cross.
    const auto is_hole = [](int a, int b) { return a >= 3 && a < 5 && b >= 3 && b < 5; };
    EXPECT_EQ(betti_of(3, [&](auto c) { return !is_hole(c[0], c[1]); }), (Betti{1, 1, 0}));
    EXPECT_EQ(betti_of(3,
                       [&](auto c) {
                           return !is_hole(c[0], c[1]) && !is_hole(c[1], c[2]) &&
                                  !is_hole(c[2], c[0]);
                       }),
              (Betti{1, 5, 0}));
    // Two that touch along an edge alone: S is open, they are apart.
    EXPECT_EQ(betti_of(2, [](auto c) { return c[0] / 2 == c[1] / 2; }), (Betti{2, 0, 0}));
}

// A cell's facets are those of its neighbours where these are smaller.
TEST(CellComplex, IsRegularWhereSizesMeet) {
    CellComplex complex([](const CellKey& key) {
        CellFact fact;
        const bool is_corner = std::ranges::all_of(key.at, [](int at) { return at == 0; });
        if (key.axes == 7 && is_corner && key.level < 6) return fact;
        fact.kind = CellFact::Kind::inside;
        return fact;
    });
    EXPECT_EQ(complex.betti({}), (Betti{1, 0, 0}));
    EXPECT_EQ(complex.depth(), 6);
}

// What holds of closed cells is told to their faces, edges and corners, smaller ones too.
TEST(CellComplex, AsksForNothingThatACellBesideTells) {
    int asked = 0, lower = 0;
    CellComplex complex([&](const CellKey& key) {
        ++asked;
        lower += key.axes != 7;
        CellFact fact;
        const bool is_corner = std::ranges::all_of(key.at, [](int at) { return at == 0; });
        if (key.axes == 7 && is_corner && key.level < 3) return fact;
        fact.kind = CellFact::Kind::inside;
        fact.holds_of_closed_cell = !is_corner;
        return fact;
    });
    // No other box has the corner itself, nor the edges and faces that only the last box has.
    EXPECT_EQ(complex.betti({}), (Betti{1, 0, 0}));
    EXPECT_EQ(asked - lower, 1 + 3 * 8);
    EXPECT_EQ(lower, 7);
}

// S is a prism along x over squares of the plane across: boxes sink to a facet, whatever they have
// there, and so do faces along x to an edge. Squares are settled once they are so small.
template<class Predicate> std::optional<Betti> betti_of_prism(int level, Predicate&& is_in) {
    CellComplex complex([&](const CellKey& key) {
        CellFact fact;
        if (key.is_along(0)) {
            fact.kind = CellFact::Kind::sinking;
            fact.sinks_to[0] = -1;
            return fact;
        }
        if (key.axes != 0 && key.level < level) return fact;
        // S is open: an edge or a corner is in it where the squares about it are.
        const int length = CellKey::whole >> level;
        bool is_inside = true;
        for (const int dy : {-1, 0}) {
            for (const int dz : {-1, 0}) {
                const bool is_beside = (dy != 0 && (key.is_along(1) || key.at[1] % length != 0)) ||
                                       (dz != 0 && (key.is_along(2) || key.at[2] % length != 0));
                if (is_beside) continue;
                const double unit = 1.0 / (1 << level);
                is_inside &= is_in((key.at[1] / length + dy + 0.5) * unit,
                                   (key.at[2] / length + dz + 0.5) * unit);
            }
        }
        fact.kind = is_inside ? CellFact::Kind::inside : CellFact::Kind::outside;
        return fact;
    });
    return complex.betti({});
}

TEST(CellComplex, DividesWhatIsNotContractible) {
    const auto two_discs = [](double y, double z) {
        return std::hypot(y - 0.2, z - 0.3) < 0.15 || std::hypot(y - 0.4, z - 0.1) < 0.1;
    };
    EXPECT_EQ(betti_of_prism(6, two_discs), (Betti{2, 0, 0}));
}

TEST(CellComplex, DividesWhatHasAHole) {
    const auto ring = [](double y, double z) {
        return std::abs(std::hypot(y - 0.25, z - 0.25) - 0.15) < 0.05;
    };
    EXPECT_EQ(betti_of_prism(6, ring), (Betti{1, 1, 0}));
}

// Stripes: each box has one in its plane across x, or parts of two.
TEST(CellComplex, DividesFacesToo) {
    const auto is_striped = [](double x) {
        return std::abs(x - 0.3) < 0.05 || std::abs(x - 0.4) < 0.03;
    };
    CellComplex complex([&](const CellKey& key) {
        CellFact fact;
        // All sinks to what is along x alone.
        for (const std::size_t k : {2u, 1u}) {
            if (!key.is_along(k)) continue;
            fact.kind = CellFact::Kind::sinking;
            fact.sinks_to[k] = -1;
            return fact;
        }
        if (key.axes != 0 && key.level < 7) return fact;
        const double unit = 1.0 / CellKey::whole;
        const double half = key.is_along(0) ? key.length() * unit / 2 : 0;
        const bool is_inside = key.is_along(0) ? is_striped(key.at[0] * unit + half)
                                               : is_striped(key.at[0] * unit - 0x1p-8) &&
                                                     is_striped(key.at[0] * unit + 0x1p-8);
        fact.kind = is_inside ? CellFact::Kind::inside : CellFact::Kind::outside;
        return fact;
    });
    EXPECT_EQ(complex.betti({}), (Betti{2, 0, 0}));
}

TEST(CellComplex, SaysWhereItsLimitsEnd) {
    CellComplex complex([](const CellKey&) { return CellFact{}; });
    EXPECT_FALSE(complex.betti({.cells = 1000, .depth = 3}));
    EXPECT_EQ(complex.failed().level, 3);
}

} // namespace
} // namespace isomotion::topology
