// What lists by place leave out of sums, against the sums themselves.
#include "elements/grid_maker.h"

#include <chrono>
#include <cmath>
#include <ctime>

#include <gmock/gmock.h>

#include "families.h"

namespace isomotion::elements {
namespace {

const Region ball{glm::dvec3(-1.1), glm::dvec3(1.1)};

formula::Bindings<double> only(const formula::Bindings<double>& all,
                               std::span<const std::uint32_t> elements) {
    formula::Bindings<double> some;
    some.parameters = all.parameters;
    some.arrays.resize(1);
    some.arrays[0].count = int(elements.size());
    for (const auto& column : all.arrays[0].fields) {
        auto& of = some.arrays[0].fields.emplace_back();
        for (const std::uint32_t e : elements) of.push_back(column[e]);
    }
    return some;
}

// What F is far from all elements, or would be of a logarithm at its root: level or h^2/2.
double scale(const formula::Bindings<float>& values) {
    return std::min<double>(values.parameters[2], 0.5 * values.parameters[1] * values.parameters[1]);
}

class Families : public testing::TestWithParam<Family> {};

TEST_P(Families, SumsOverListsAreTheSums) {
    const unsigned seed = 20261124;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 draw(seed);
    const auto field = formula::make_field(GetParam().formula, family_vocabulary());
    const auto maker = GridMaker::of(field, 0);
    ASSERT_TRUE(maker);
    for (const int count : {0, 1, 2, 75, 700}) {
        const double spacing = count > 0 ? 0.8 / std::cbrt(count) : 1.0;
        const auto values = drawn_elements(draw, count, spacing);
        const ElementGrid grid = maker->make(values, ball, {.threads = 2});
        if (GetParam().exact) {
            EXPECT_THAT(grid.left_out, testing::Each(0.0));
        }
        const auto all = formula::convert<double>(values);
        formula::FieldEvaluator<double> evaluator(field);
        std::uniform_real_distribution<double> place(-1.1, 1.1);
        double listed = 0;
        for (int k = 0; k < 300; ++k) {
            const std::array p{place(draw), place(draw), place(draw)};
            const Cell& cell = grid.at(grid.place({p[0], p[1], p[2]}));
            const auto list =
                cell.elements() > 0 ? grid.list(cell) : std::span<const std::uint32_t>{};
            listed += double(list.size());
            const double whole = evaluator.value(all, p);
            const double part = evaluator.value(only(all, list), p);
            if (std::isnan(whole) && std::isnan(part)) continue;
            if (GetParam().exact) {
                EXPECT_EQ(part, whole) << count << " at " << testing::PrintToString(p);
            } else if (std::abs(whole) < 0.2 * scale(values)) { // near roots
                EXPECT_NEAR(part, whole, 0x1p-17 * scale(values))
                    << count << " at " << testing::PrintToString(p);
            }
        }
        if (count == 700) {
            EXPECT_LT(listed / 300, 200) << "lists are much shorter than all";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, Families, testing::ValuesIn(families));

TEST(Speed, OfMany) {
    std::mt19937 draw(7);
    for (const auto& family : families) {
        const auto field = formula::make_field(family.formula, family_vocabulary());
        const auto maker = GridMaker::of(field, 0);
        const int count = 100'000;
        // As blobby75: a = 62 at 75.
        const auto values = drawn_elements(draw, count, 0.127 * std::cbrt(75.0 / count));
        const auto c0 = std::clock();
        const auto begin = std::chrono::steady_clock::now();
        const ElementGrid grid = maker->make(values, ball, {.threads = 2});
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
        double mean = 0, full = 0;
        for (const Cell& c : grid.cells) {
            mean += double(c.elements()) * c.elements();
            full += c.free() == 0;
        }
        printf("%s: %.0f ms (%.0f cpu), across %d, listed %zu, longest %u, met %.1f, full %.2f, "
               "left out %g\n",
               family.name, 1e3 * took.count(), 1e3 * double(std::clock() - c0) / CLOCKS_PER_SEC,
               grid.across.x, grid.listed.size(), grid.longest,
               mean / std::max<double>(1, double(grid.listed.size())),
               full / double(grid.cells.size()), grid.left_out[0]);
    }
}

} // namespace
} // namespace isomotion::elements
