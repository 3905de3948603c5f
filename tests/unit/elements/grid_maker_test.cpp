// What lists by place leave out of sums, against the sums themselves.
#include "elements/grid_maker.h"

#include <cmath>

#include <gmock/gmock.h>

#include "families.h"

namespace isomotion::elements::grid_maker_test {
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

// What F is far from all elements, or would be of a logarithm at its root: level or h^2/2. Where
// roots have sums of any size, the bounds' size.
double scale(const Family& family, const formula::Bindings<float>& values) {
    const std::string name = family.name;
    if (name == "bumps" || name == "terrain") return ball.high.x - ball.low.x;
    return std::min<double>(values.parameters[2],
                            0.5 * values.parameters[1] * values.parameters[1]);
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
            } else if (std::abs(whole) < 0.2 * scale(GetParam(), values)) { // near roots
                EXPECT_NEAR(part, whole, 0x1p-17 * scale(GetParam(), values))
                    << count << " at " << testing::PrintToString(p);
            }
        }
        if (count == 700 && !GetParam().lists_all) {
            EXPECT_LT(listed / 300, 200) << "lists are much shorter than all";
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, Families, testing::ValuesIn(families));

class LeastFamilies : public testing::TestWithParam<Family> {};

// Lists hold the least element wherever a root depends on it.
TEST_P(LeastFamilies, RootsAreThoseOfAllElements) {
    const unsigned seed = 20261127;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 draw(seed);
    const std::string formula = GetParam().formula, name = GetParam().name;
    const auto field = formula::make_field(formula, family_vocabulary());
    // The key's sign in F, and the least alone.
    const auto begin = formula.find(name == "kernels" ? "greatest(" : "least(");
    const auto end = [&] {
        int depth = 0;
        for (std::size_t k = begin; k < formula.size(); ++k) {
            depth += formula[k] == '(' ? 1 : formula[k] == ')' ? -1 : 0;
            if (formula[k] == ')' && depth == 0) return k + 1;
        }
        return formula.size();
    }();
    const auto least = formula::make_field(
        (name == "kernels" ? "-" : "") + formula.substr(begin, end - begin), family_vocabulary());
    const auto maker = GridMaker::of(field, 0);
    ASSERT_TRUE(maker);
    for (const int count : {0, 1, 2, 75, 700}) {
        const double spacing = count > 0 ? 0.8 / std::cbrt(count) : 1.0;
        const auto values = drawn_elements(draw, count, spacing);
        const ElementGrid grid = maker->make(values, ball, {.threads = 2});
        const auto all = formula::convert<double>(values);
        formula::FieldEvaluator<double> evaluator(field), of_least(least);
        std::uniform_real_distribution<double> place(-1.1, 1.1);
        double listed = 0;
        int inside = 0;
        for (int k = 0; k < 1000; ++k) {
            const std::array p{place(draw), place(draw), place(draw)};
            const auto list = grid.list(grid.at(grid.place({p[0], p[1], p[2]})));
            listed += double(list.size());
            const auto near = only(all, list);
            const double limit = double(grid.least);
            EXPECT_EQ(std::min(of_least.value(near, p), limit),
                      std::min(of_least.value(all, p), limit))
                << count << " at " << testing::PrintToString(p);
            const double whole = evaluator.value(all, p), part = evaluator.value(near, p);
            inside += whole < 0;
            EXPECT_EQ(part < 0, whole < 0) << count << " at " << testing::PrintToString(p);
        }
        if (count == 700 && !GetParam().lists_all) {
            EXPECT_LT(listed / 1000, 200) << "lists are much shorter than all";
            EXPECT_GT(inside, 20);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, LeastFamilies, testing::ValuesIn(least_families));

class AllFamilies : public testing::TestWithParam<Family> {};
INSTANTIATE_TEST_SUITE_P(Sums, AllFamilies, testing::ValuesIn(families));
INSTANTIATE_TEST_SUITE_P(Least, AllFamilies, testing::ValuesIn(least_families));

// F has one sign at all places of a free cell, or no value.
TEST_P(AllFamilies, FreeCellsHaveNoRoot) {
    const unsigned seed = 20261125;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 draw(seed);
    const auto field = formula::make_field(GetParam().formula, family_vocabulary());
    const auto maker = GridMaker::of(field, 0);
    ASSERT_TRUE(maker);
    const auto values = drawn_elements(draw, 120, 0.15);
    const ElementGrid grid = maker->make(values, ball, {.threads = 2});
    const auto all = formula::convert<double>(values);
    formula::FieldEvaluator<double> evaluator(field);
    std::uniform_real_distribution<double> part(0, 1);
    int free = 0;
    for (int k = 0; k < 2000; ++k) {
        const glm::ivec3 place(glm::dvec3(part(draw), part(draw), part(draw)) *
                               glm::dvec3(grid.across));
        if (grid.at(place).free() == 0) continue;
        ++free;
        int above = 0, below = 0;
        for (int sample = 0; sample < 8; ++sample) {
            const glm::dvec3 in(part(draw), part(draw), part(draw));
            const glm::dvec3 p = grid.low + (glm::dvec3(place) + in) * grid.cell;
            const double f = evaluator.value(all, {p.x, p.y, p.z});
            above += f > 0;
            below += f < 0;
        }
        EXPECT_EQ(std::min(above, below), 0) << testing::PrintToString(place);
    }
    if (!GetParam().lists_all) {
        EXPECT_GT(free, 100);
    }
}

TEST_P(AllFamilies, GridsAreEqualForAnyNumberOfThreads) {
    std::mt19937 draw(3);
    const auto maker =
        GridMaker::of(formula::make_field(GetParam().formula, family_vocabulary()), 0);
    const auto values = drawn_elements(draw, 3000, 0.06);
    const ElementGrid one = maker->make(values, ball, {.threads = 1});
    const ElementGrid three = maker->make(values, ball, {.threads = 3});
    EXPECT_EQ(one.cells, three.cells);
    EXPECT_EQ(one.listed, three.listed);
    EXPECT_EQ(one.left_out, three.left_out);
    EXPECT_EQ(one.least, three.least);
}

// What no grid is made of: its elements are all looked at.
TEST(GridMaker, IsOfOneLeastAndNoSums) {
    const auto may = [](const char* formula) {
        return GridMaker::of(formula::make_field(formula, family_vocabulary()), 0).has_value();
    };
    EXPECT_TRUE(may("least(p, (x-cx)^2 + y^2 + z^2) - 1"));
    EXPECT_FALSE(may("least(p, (x-cx)^2 + y^2 + z^2) - least(p, (y-cy)^2 + x^2 + z^2)"));
    EXPECT_FALSE(may("least(p, (x-cx)^2 + y^2 + z^2) - sum(p, exp(-(y-cy)^2 - x^2 - z^2))"));
    EXPECT_FALSE(may("least(p, sin(x*cx)*sin(y*cy))"));
}

// 1/L grows towards 0 for ever, so what is far counts. Lists hold what may be the least in a cell.
TEST(GridMaker, FindsTheLeastWhereRootsDependOnItAnywhere) {
    std::mt19937 draw(6);
    const auto field = formula::make_field("z*least(p, sqrt((x-cx)^2 + (y-cy)^2 + (z-cz)^2)) - 0.2",
                                           family_vocabulary());
    const auto values = drawn_elements(draw, 3000, 0.06);
    const auto all = formula::convert<double>(values);
    const ElementGrid grid = GridMaker::of(field, 0)->make(values, ball, {});
    EXPECT_EQ(grid.least, formula::Operations<float>::least_of_none());
    EXPECT_LT(grid.usual_count(), 100);
    formula::FieldEvaluator<double> evaluator(field);
    // Also a little beyond the grid, whose outermost cells hold what is there.
    std::uniform_real_distribution<double> place(-1.15, 1.15);
    for (int k = 0; k < 1000; ++k) {
        const std::array p{place(draw), place(draw), place(draw)};
        const auto list = grid.list(grid.at(grid.place({p[0], p[1], p[2]})));
        EXPECT_EQ(evaluator.value(only(all, list), p), evaluator.value(all, p))
            << testing::PrintToString(p);
    }
}

// Cells in layers along the rods share their lists.
TEST(GridMaker, CrowdedRodsOnAFloorKeepTheirLeast) {
    std::mt19937 draw(7);
    const auto field = formula::make_field(
        "min(least(p, sqrt((x-cx)^2 + (y-cy)^2) - 0.4*r), z + 0.7)", family_vocabulary());
    const auto values = drawn_elements(draw, 3000, 0.3);
    const auto all = formula::convert<double>(values);
    const ElementGrid grid = GridMaker::of(field, 0)->make(values, ball, {.threads = 2});
    EXPECT_GT(grid.longest, 24u);
    formula::FieldEvaluator<double> evaluator(field);
    std::uniform_real_distribution<double> place(-1.1, 1.1);
    for (int k = 0; k < 1000; ++k) {
        const std::array p{place(draw), place(draw), place(draw)};
        const auto list = grid.list(grid.at(grid.place({p[0], p[1], p[2]})));
        EXPECT_EQ(evaluator.value(only(all, list), p) < 0, evaluator.value(all, p) < 0)
            << testing::PrintToString(p);
    }
}

TEST(GridMaker, DividedCellsKeepWithinTheLimitOfLists) {
    std::mt19937 draw(8);
    const auto field = formula::make_field("z*least(p, sqrt((x-cx)^2 + (y-cy)^2 + (z-cz)^2)) - 0.2",
                                           family_vocabulary());
    const auto values = drawn_elements(draw, 3000, 0.06);
    const ElementGrid grid = GridMaker::of(field, 0)->make(values, ball, {.listed = 20'000});
    EXPECT_LE(grid.listed.size(), 20'000u);
}

TEST(GridMaker, ListsKeepWithinTheirLimit) {
    std::mt19937 draw(4);
    const auto maker =
        GridMaker::of(formula::make_field(families[0].formula, family_vocabulary()), 0);
    const auto values = drawn_elements(draw, 2000, 0.2);
    const ElementGrid grid = maker->make(values, ball, {.listed = 40'000, .threads = 2});
    EXPECT_LE(grid.listed.size(), 40'000u);
    EXPECT_GE(grid.listed.size(), 2000u);
}

// A weight of 0, a kernel as wide as the scene, and one of no width.
TEST(GridMaker, ElementsOfEverySize) {
    const auto field = formula::make_field(families[7].formula, family_vocabulary());
    std::mt19937 draw(5);
    for (const float h : {0.0f, 1e-20f, 1e-4f, 50.0f, 1e20f}) {
        auto values = drawn_elements(draw, 20, 0.3);
        values.parameters[1] = h;
        const ElementGrid grid = GridMaker::of(field, 0)->make(values, ball, {});
        const std::size_t most = grid.longest;
        EXPECT_LE(most, 20u) << h;
        if (h >= 50) {
            EXPECT_EQ(most, 20u) << h;
        }
    }
}

} // namespace
} // namespace isomotion::elements::grid_maker_test
