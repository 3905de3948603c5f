// Programs without loops have the values of those with loops.
#include "formula/tape/unrolled.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "formula/enclosure.h"
#include "formula/field.h"
#include "testing.h"

namespace isomotion::formula {
namespace {

Bindings<float> random_elements(Random& random, int parameters, int arrays, int fields, int count) {
    Bindings<float> bindings;
    for (int k = 0; k < parameters; ++k) bindings.parameters.push_back(float(random.in(0.5, 2)));
    for (int a = 0; a < arrays; ++a) {
        ArrayColumns<float> array;
        array.count = count;
        for (int f = 0; f < fields; ++f) {
            std::vector<float>& column = array.fields.emplace_back();
            for (int e = 0; e < count; ++e) column.push_back(float(random.in(-1, 1)));
        }
        bindings.arrays.push_back(std::move(array));
    }
    return bindings;
}

const std::vector<std::string> formulas_over_elements{
    "sum(blobs, (x - cx)^2 + y*cy) - 1",
    "least(blobs, (x - cx)^2 + (y - cy)^2 + z^2) - 0.2",
    "sum(blobs, cx*least(links, abs(y - py - cy))) - z",
    "x*sum(blobs, cx) + y^2 - least(blobs, max(x, cy))",
    "x + y + z - 1",
};

// Also where an array has fewer elements than it has at most, or none.
TEST(Unrolled, HasTheValuesOfLoops) {
    constexpr int seed = 71, most = 5;
    Random random(seed);
    const Vocabulary vocabulary = test_vocabulary();
    for (const std::string& formula : formulas_over_elements) {
        const Field field = make_field(formula, vocabulary);
        const int parameters = int(vocabulary.parameters.size());
        const ElementParameters elements(
            parameters, field.packing,
            std::vector<ElementRange>(vocabulary.arrays.size(), {1, most}));
        for (const Program* program : {&field.value, &field.directional, &field.gradient}) {
            const auto made = unrolled(*program, elements, 10'000);
            ASSERT_TRUE(made) << formula;
            Evaluator<float> loops(*program), flat(*made);
            for (int count = 1; count <= most; ++count) {
                const Bindings<float> bindings =
                    random_elements(random, parameters, int(vocabulary.arrays.size()), 8, count);
                Bindings<float> only_parameters;
                only_parameters.parameters = elements.values(bindings);
                std::array<float, 6> at{};
                for (float& number : at) number = float(random.in(-2, 2));
                std::vector<float> a(program->outputs.size()), b(a.size());
                loops.point(bindings, at, a);
                flat.point(only_parameters, at, b);
                EXPECT_EQ(a, b) << formula << ", " << count << " elements, seed " << seed;
            }
        }
    }
}

TEST(Unrolled, IsNoLongerThanAsked) {
    const Field field = make_field("sum(blobs, (x - cx)^2) - 1", test_vocabulary());
    const auto with = [&](int count) {
        return unrolled(field.value, ElementParameters(0, field.packing, {{count, count}, {}}),
                        1000);
    };
    EXPECT_TRUE(with(100));
    EXPECT_FALSE(with(1000));
    // Without elements nothing is written out, however long it is.
    const Field flat = make_field("sin(x)*cos(y) + exp(z) - 1", test_vocabulary());
    EXPECT_TRUE(unrolled(flat.directional, ElementParameters(0, flat.packing, {{}, {}}), 1));
}

} // namespace
} // namespace isomotion::formula
