#include "formula/field.h"

#include "testing.h"

namespace isomotion::formula {
namespace {

TEST(Field, KeepsItsText) {
    const auto* text = "x^2 +\n y";
    EXPECT_EQ(make_field(text, {}).text, text);
    EXPECT_THROW(make_field("x +", {}), ParseError);
}

// A field lives in space: whatever inputs the vocabulary had, it now has these.
TEST(Field, InputsAreTheCoordinates) {
    Vocabulary v;
    v.inputs = {"t", "i", "n"};
    const Field field = make_field("x + 10*y + 100*z", v);
    EXPECT_EQ(FieldEvaluator<double>(field).value({}, {1, 2, 3}), 321);
    EXPECT_THROW(make_field("t", v), ParseError);
}

TEST(Field, ValueSlopeAndGradient) {
    const Field field = make_field("x^2*y + a*z", test_vocabulary());
    FieldEvaluator<double> evaluator(field);
    const auto bindings = test_bindings(); // a = 1.25
    const Point p{2, 3, 4};
    EXPECT_EQ(evaluator.value(bindings, p), 17);
    EXPECT_EQ(evaluator.gradient(bindings, p), (Point{12, 4, 1.25}));
    EXPECT_EQ(evaluator.directional(bindings, p, {1, -2, 4}), (std::array{17.0, 12.0 - 8 + 5}));
    EXPECT_EQ(evaluator.directional(bindings, p, {0, 0, 0}), (std::array{17.0, 0.0}));
}

// The graph keeps T_n whole for interval bounds; the programs have no such instruction.
TEST(Field, PrimitivesStayInTheGraphOnly) {
    const Field field = make_field("chebyshev(7, x) + chebyshev(7, y)", {});
    int primitives = 0;
    for (NodeId id = 0; id <= field.root; ++id) primitives += field.graph[id].op == Op::chebyshev;
    EXPECT_EQ(primitives, 2);
    for (const Program* program : {&field.value, &field.directional, &field.gradient}) {
        for (const auto& now : program->instructions) EXPECT_NE(now.op, Op::chebyshev);
    }
}

TEST(Field, PacksUsedFieldsInTheOrderOfDeclaration) {
    const auto packing = [](std::string_view text) {
        return make_field(text, test_vocabulary()).packing;
    };
    EXPECT_EQ(packing("x"), (ArrayPacking{{}, {}}));
    EXPECT_EQ(packing("sum(blobs, s*cz - cx)"), (ArrayPacking{{0, 2, 5}, {}}));
    EXPECT_EQ(packing("sum(links, py + width)"), (ArrayPacking{{}, {1}}));
    EXPECT_EQ(packing("sum(blobs, cy) + sum(links, px)"), (ArrayPacking{{1}, {0}}));
    EXPECT_EQ(packing("sum(blobs, 1)"), (ArrayPacking{{}, {}}));
    // A field that no program reads any more, since its term is gone, takes no room.
    EXPECT_EQ(packing("sum(blobs, cx + 0*cy)"), (ArrayPacking{{0}, {}}));
}

TEST(Field, IsIndependentOfItsVocabulary) {
    Field field;
    {
        Vocabulary v = test_vocabulary();
        field = make_field("a + sum(blobs, cx)", v);
        v = {};
    }
    FieldEvaluator<double> evaluator(field);
    EXPECT_EQ(evaluator.value(test_bindings(), {0, 0, 0}), 1.25 - 0.375);
}

} // namespace
} // namespace isomotion::formula
