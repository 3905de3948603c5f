#include "testing.h"

#include <bit>
#include <cmath>

#include "catalogue.h"
#include "random_formula.h"

namespace isomotion::formula::evaluate_test {
namespace {

// The whole compiler against plain recursion over the same formula.
TEST(Evaluate, RandomFormulasMeanWhatTheySay) {
    int compared = 0, sums = 0, least = 0;
    for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        FormulaGenerator generator(seed);
        const RandomFormula formula = generator.make(2 + int(seed % 5));
        SCOPED_TRACE(formula.text);
        sums += formula.text.find("sum(") != std::string::npos;
        least += formula.text.find("least(") != std::string::npos;
        Graph graph;
        const NodeId root = parse(graph, formula.text);
        const Program program = schedule(graph, std::array{root});
        Random random(seed);
        for (int k = 0; k < 5; ++k) {
            const auto bindings = test_bindings(k, 4 - k);
            Meaning meaning{random.point(1.5), bindings};
            const double expected = formula.value(meaning);
            const double tolerance = 1e-13 * std::pow(meaning.largest, 3);
            if (tolerance > 1e-6) continue;
            ++compared;
            ASSERT_NEAR(run(program, meaning.p, bindings), expected, tolerance);
        }
    }
    EXPECT_GT(compared, 5000);
    EXPECT_GT(sums, 300);
    EXPECT_GT(least, 150);
}

template<class T> class Blocks : public testing::Test {};
using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(Blocks, Numbers);

template<class T> auto bits(T value) {
    if constexpr (sizeof(T) == 4) {
        return std::bit_cast<std::uint32_t>(value);
    } else {
        return std::bit_cast<std::uint64_t>(value);
    }
}

TYPED_TEST(Blocks, GiveTheBitsOfSinglePoints) {
    using T = TypeParam;
    for (const auto* text :
         {"sum(blobs, weight*exp(-s*((x-cx)^2+(y-cy)^2+(z-cz)^2))) - a",
          "sin(x)*cos(y)+tan(z)-atan(x*y)+tanh(z)+asin(x)*acos(y)", "atan2(y,x)*cos(atan2(x,z))",
          "x^1.5+abs(y)^m-sinh(z)*cosh(x)",
          "min(x,y,z)/max(x*y,z)+floor(4*x)+sign(y)+sqrt(z)+log(x)", "chebyshev(50,x)-z", "7", "y",
          "sum(blobs, sum(links, cx*px*x))", "least(blobs, cx*x)*greatest(links, px*y - z)"}) {
        SCOPED_TRACE(text);
        const Field field = make_field(text, test_vocabulary());
        const auto bindings = convert<T>(test_bindings());
        for (const std::size_t size : {0, 1, 31, 32, 33, 100}) {
            constexpr std::uint64_t seed = 40;
            SCOPED_TRACE(testing::Message() << "seed " << seed << " size " << size);
            Random random(seed);
            std::array<std::vector<T>, 6> columns;
            for (auto& column : columns) {
                for (std::size_t i = 0; i < size; ++i) column.push_back(T(random.in(-2, 2)));
            }
            const std::array<std::span<const T>, 6> inputs{columns[0], columns[1], columns[2],
                                                           columns[3], columns[4], columns[5]};
            // One value more than asked for shows a write past the end.
            std::array<std::vector<T>, 2> results;
            for (auto& result : results) result.assign(size + 1, T(-123));
            const std::array<std::span<T>, 2> outputs{std::span(results[0]).first(size),
                                                      std::span(results[1]).first(size)};
            Evaluator<T> evaluator(field.directional);
            evaluator.points(bindings, inputs, outputs);
            EXPECT_EQ(results[0][size], T(-123));
            EXPECT_EQ(results[1][size], T(-123));
            for (std::size_t i = 0; i < size; ++i) {
                std::array<T, 6> point{};
                for (std::size_t k = 0; k < 6; ++k) point[k] = columns[k][i];
                std::array<T, 2> single{};
                evaluator.point(bindings, point, single);
                for (std::size_t o = 0; o < 2; ++o) {
                    const bool both_nan = std::isnan(single[o]) && std::isnan(results[o][i]);
                    EXPECT_TRUE(both_nan || bits(single[o]) == bits(results[o][i]))
                        << single[o] << " and " << results[o][i] << " at " << i;
                }
            }
        }
    }
}

// An evaluator is used for many frames: nothing of one run may reach the next.
TEST(Evaluate, RunsDoNotDependOnEarlierOnes) {
    Graph graph;
    const NodeId root = parse(graph, "sum(blobs, cx*x)/sum(blobs, 1) + sum(links, px*cos(y))");
    const Program program = schedule(graph, std::array{root});
    Evaluator<double> used(program);
    Random random(41);
    for (const int blobs : {3, 0, 7, 1, 3}) {
        const auto bindings = test_bindings(blobs, 7 - blobs);
        const Point p = random.point(2);
        double first = 0, fresh = 0;
        used.point(bindings, p, {&first, 1});
        Evaluator<double>(program).point(bindings, p, {&fresh, 1});
        EXPECT_EQ(std::isnan(first), blobs == 0); // 0/0
        if (blobs > 0) {
            EXPECT_EQ(bits(first), bits(fresh));
        }
    }
}

TEST(Evaluate, FloatFollowsDouble) {
    constexpr std::uint64_t seed = 42;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    for (const CatalogueSurface& surface : catalogue()) {
        SCOPED_TRACE(surface.name);
        const CatalogueField made(surface);
        FieldEvaluator<double> in_double(made.field);
        FieldEvaluator<float> in_float(made.field);
        const auto narrow = convert<float>(made.bindings);
        const auto rounded = convert<double>(narrow);
        Random random(seed);
        std::vector<double> values;
        double worst = 0;
        for (int k = 0; k < 200; ++k) {
            const Point at = random.point(surface.reach);
            const std::array<float, 3> q{float(at[0]), float(at[1]), float(at[2])};
            const double exact = in_double.value(rounded, {q[0], q[1], q[2]});
            values.push_back(std::abs(exact));
            worst = std::max(worst, std::abs(double(in_float.value(narrow, q)) - exact));
        }
        EXPECT_LT(worst, 3e-5 * *std::max_element(values.begin(), values.end()));
        EXPECT_GT(worst, 0); // float and double are two programs
    }
}

TEST(Evaluate, ConversionKeepsEverything) {
    Bindings<double> wide = test_bindings(5, 2);
    wide.seed = 99;
    const auto back = convert<double>(convert<float>(wide));
    EXPECT_EQ(back.seed, 99u);
    EXPECT_EQ(back.parameters, wide.parameters); // eighths are exact in float
    ASSERT_EQ(back.arrays.size(), 2u);
    for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_EQ(back.arrays[k].count, wide.arrays[k].count);
        EXPECT_EQ(back.arrays[k].fields, wide.arrays[k].fields);
    }
}

// Fields that the formula doesn't use need no values.
TEST(Evaluate, UnusedColumnsMayBeEmpty) {
    auto bindings = test_bindings();
    for (const std::size_t unused : {1, 2, 4, 5}) bindings.arrays[0].fields[unused].clear();
    bindings.arrays[1] = {};
    EXPECT_EQ(value_of("sum(blobs, cx + weight)", {}, bindings), -0.375 + 3 - 1.125);
}

} // namespace
} // namespace isomotion::formula::evaluate_test
