// The cheapest matching against all there are.
#include "topology/timeline/matching.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace isomotion::topology {
namespace {

using Costs = std::vector<std::vector<double>>;

double price(const Costs& costs, std::size_t columns,
             const std::vector<std::optional<std::size_t>>& found, double alone) {
    double sum = 0;
    std::set<std::size_t> taken;
    for (std::size_t r = 0; r < found.size(); ++r) {
        if (!found[r]) {
            sum += alone;
            continue;
        }
        EXPECT_TRUE(taken.insert(*found[r]).second) << "a column of two rows";
        EXPECT_LT(costs[r][*found[r]], 2 * alone);
        sum += costs[r][*found[r]];
    }
    return sum + alone * double(columns - taken.size());
}

// Rows from `row` on, by trying everything.
double least(const Costs& costs, std::size_t columns, std::size_t row, std::vector<char>& taken,
             double alone) {
    if (row == costs.size()) {
        return alone * double(std::count(taken.begin(), taken.end(), 0));
    }
    double best = alone + least(costs, columns, row + 1, taken, alone);
    for (std::size_t c = 0; c < columns; ++c) {
        if (taken[c]) continue;
        taken[c] = 1;
        best = std::min(best, costs[row][c] + least(costs, columns, row + 1, taken, alone));
        taken[c] = 0;
    }
    return best;
}

TEST(Matching, IsTheCheapestOfAll) {
    const unsigned seed = 20260;
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> cost(0, 3.5);
    std::uniform_int_distribution<std::size_t> size(0, 6);
    for (int trial = 0; trial < 300; ++trial) {
        const std::size_t rows = size(random), columns = size(random);
        Costs costs(rows, std::vector<double>(columns));
        for (auto& row : costs) {
            // Ties are the rule among events that happen at once.
            for (double& c : row) c = trial % 2 ? cost(random) : std::floor(cost(random));
        }
        const auto found = match(
            rows, columns, [&](std::size_t r, std::size_t c) { return costs[r][c]; }, 1);
        ASSERT_EQ(found.size(), rows);
        std::vector<char> taken(columns, 0);
        ASSERT_NEAR(price(costs, columns, found, 1), least(costs, columns, 0, taken, 1), 1e-12);
    }
}

TEST(Matching, FindsAPermutationAmongMany) {
    std::mt19937_64 random(7);
    std::vector<std::size_t> order(400);
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), random);
    const auto found = match(
        400, 400,
        [&](std::size_t r, std::size_t c) {
            return 0.003 * std::abs(double(order[r]) - double(c));
        },
        1);
    for (std::size_t r = 0; r < 400; ++r) EXPECT_EQ(found[r], order[r]);
}

} // namespace
} // namespace isomotion::topology
