#include "testing.h"

#include <cmath>
#include <set>

namespace isomotion::formula {
namespace {

// Animations are reproducible: these values may never change.
TEST(RandomUnit, PinnedValues) {
    EXPECT_EQ(random_unit(0, 0, 0), 0.65244848637403219);
    EXPECT_EQ(random_unit(0, 1, 0), 0.55272679084691956);
    EXPECT_EQ(random_unit(0, 0, 1), 0.013996059553765816);
    EXPECT_EQ(random_unit(1, 0, 0), 0.36818951565166946);
    EXPECT_EQ(random_unit(20240229, 74, 2.5), 0.38465294077814349);
}

TEST(RandomUnit, DependsOnEachArgument) {
    const double base = random_unit(7, 3, 4);
    EXPECT_EQ(base, random_unit(7, 3, 4));
    EXPECT_NE(base, random_unit(8, 3, 4));
    EXPECT_NE(base, random_unit(7, 4, 4));
    EXPECT_NE(base, random_unit(7, 3, 5));
    EXPECT_NE(base, random_unit(7, 4, 3));
    EXPECT_NE(base, random_unit(7, 3.5, 4));
    EXPECT_NE(random_unit(7, 1, 0), random_unit(7, -1, 0));
    EXPECT_EQ(random_unit(7, -0.0, 4), random_unit(7, 0.0, 4));
    EXPECT_EQ(random_unit(7, 3, -0.0), random_unit(7, 3, 0.0));
}

// Chi-square with 99 degrees of freedom: mean 99, deviation 14.
void expect_uniform(const std::vector<double>& values) {
    std::array<int, 100> bins{};
    for (const double value : values) {
        ASSERT_GE(value, 0);
        ASSERT_LT(value, 1);
        ++bins[std::size_t(value * 100)];
    }
    const double expected = double(values.size()) / 100;
    double chi_square = 0;
    for (const int bin : bins) chi_square += (bin - expected) * (bin - expected) / expected;
    EXPECT_LT(chi_square, 99 + 5 * 14);
    EXPECT_GT(chi_square, 99 - 5 * 14);
}

TEST(RandomUnit, IsUniformAlongEachArgument) {
    std::vector<double> by_i, by_k, by_seed;
    for (int n = 0; n < 20'000; ++n) {
        by_i.push_back(random_unit(1, n, 0));
        by_k.push_back(random_unit(1, 0, n));
        by_seed.push_back(random_unit(std::uint64_t(n), 0, 0));
    }
    expect_uniform(by_i);
    expect_uniform(by_k);
    expect_uniform(by_seed);
    EXPECT_EQ(std::set<double>(by_i.begin(), by_i.end()).size(), by_i.size());
}

// What a formula uses side by side may not be related: neighbours, columns, swapped arguments.
TEST(RandomUnit, IsUncorrelated) {
    constexpr int count = 20'000;
    double neighbours = 0, columns = 0, swapped = 0, seeds = 0;
    for (int n = 0; n < count; ++n) {
        const double value = random_unit(1, n, 0) - 0.5;
        neighbours += value * (random_unit(1, n + 1, 0) - 0.5);
        columns += value * (random_unit(1, n, 1) - 0.5);
        swapped += value * (random_unit(1, 0, n) - 0.5);
        seeds += value * (random_unit(2, n, 0) - 0.5);
    }
    // A product of two has the deviation 1/12; five deviations of the sum.
    const double limit = 5 * std::sqrt(double(count)) / 12;
    EXPECT_LT(std::abs(neighbours), limit);
    EXPECT_LT(std::abs(columns), limit);
    EXPECT_LT(std::abs(swapped), limit);
    EXPECT_LT(std::abs(seeds), limit);
}

} // namespace
} // namespace isomotion::formula
