// Parts of boxes that a judge settles.
#include "formula/interval/prune.h"

#include <gtest/gtest.h>

namespace isomotion::formula {
namespace {

using Square = std::array<Interval, 2>;

// Parts that are settled are the whole box, each once, from low to high.
TEST(Prune, GoesThroughAllOfABoxOnce) {
    const Square domain{Interval(0, 1), Interval(2, 10)};
    double area = 0;
    std::vector<Square> parts;
    const bool settled = prune(domain, [&](const Square& box) {
        if (longest_side(box, domain).part > 0.25) return Judged::open;
        area += (box[0].hi - box[0].lo) * (box[1].hi - box[1].lo);
        parts.push_back(box);
        return Judged::settled;
    });
    EXPECT_TRUE(settled);
    EXPECT_EQ(area, 8);
    ASSERT_EQ(parts.size(), 16u);
    EXPECT_EQ(parts.front(), (Square{Interval(0, 0.25), Interval(2, 4)}));
    EXPECT_EQ(parts.back(), (Square{Interval(0.75, 1), Interval(8, 10)}));
}

TEST(Prune, EndsWhereAPartIsRefused) {
    int judged = 0;
    const bool settled = prune(std::array{Interval(0, 1)}, [&](const auto& box) {
        ++judged;
        if (box[0].hi <= 0.5) return Judged::settled;
        return box[0].lo >= 0.5 ? Judged::refused : Judged::open;
    });
    EXPECT_FALSE(settled);
    EXPECT_EQ(judged, 3);
}

TEST(Prune, HalvesTheGivenSidesAlone) {
    const Square domain{Interval(0, 1), Interval(0, 1)};
    EXPECT_TRUE(prune(domain, domain, {1, 2}, [&](const Square& box) {
        EXPECT_EQ(box[0], domain[0]);
        return box[1].hi - box[1].lo > 0.1 ? Judged::open : Judged::settled;
    }));
}

// The sides of the domain tell which side is long, wherever the search begins.
TEST(Prune, ComparesSidesWithTheDomains) {
    const Square domain{Interval(0, 1), Interval(0, 100)}, box{Interval(0, 1), Interval(0, 50)};
    Square first{};
    EXPECT_FALSE(prune(box, domain, {0, 2}, [&](const Square& part) {
        if (part == box) return Judged::open;
        first = part;
        return Judged::refused;
    }));
    EXPECT_EQ(first, (Square{Interval(0, 0.5), Interval(0, 50)}));
}

// Between neighbouring doubles there is no middle.
TEST(Prune, EndsWithoutABoxToHalve) {
    int judged = 0;
    EXPECT_FALSE(prune(std::array{Interval(1, 2)}, [&](const auto&) {
        ++judged;
        return Judged::open;
    }));
    EXPECT_EQ(judged, 53);
    EXPECT_FALSE(prune(std::array{Interval(3, 3)}, [](const auto&) { return Judged::open; }));
}

// A side of two doubles is not halved, however long it is as a part of the domain's; others are.
TEST(Prune, HalvesOtherSidesWhereTheLongestHasNoMiddle) {
    const double next = std::nextafter(1.0, 2.0);
    const Square domain{Interval(1, next), Interval(0, 1)};
    EXPECT_EQ(longest_side(domain, domain).side, 1u);
    int parts = 0;
    EXPECT_TRUE(prune(domain, [&](const Square& box) {
        if (longest_side(box, domain).part > 0.25) return Judged::open;
        ++parts;
        return Judged::settled;
    }));
    EXPECT_EQ(parts, 4);
    EXPECT_EQ(longest_side(Square{Interval(1, next), Interval(3, 3)}, domain).part, 0);
}

} // namespace
} // namespace isomotion::formula
