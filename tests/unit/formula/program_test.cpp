// Loops: what is inside, what is before, what shares one.
#include "testing.h"

#include "formula/field.h"

namespace isomotion::formula {
namespace {

using Kind = Instruction::Kind;

struct Shape {
    int loops = 0;
    int deepest = 0;
    int dangling = 0;                      // ends without a beginning, beginnings without an end
    std::map<Op, std::vector<int>> depths; // of each operation, the loop depth it runs at
};

Shape shape_of(const Program& program) {
    Shape shape;
    int depth = 0;
    for (const Instruction& now : program.instructions) {
        if (now.kind == Kind::loop_begin) {
            ++shape.loops;
            shape.deepest = std::max(shape.deepest, ++depth);
        }
        if (now.kind == Kind::loop_end && --depth < 0) ++shape.dangling;
        if (now.kind == Kind::operation) shape.depths[now.op].push_back(depth);
    }
    shape.dangling += depth;
    return shape;
}

Program program_of(std::string_view text) {
    Graph graph;
    const NodeId root = parse(graph, text);
    return schedule_lowered(graph, root);
}

double iterations(std::string_view text, std::array<int, 2> counts) {
    return cost(program_of(text), counts).iterations;
}

using Depths = std::vector<int>;

TEST(Schedule, WhatDoesNotNeedTheElementIsComputedOnce) {
    const Shape shape = shape_of(program_of("sum(blobs, exp(x*a)*sin(cx) + sqrt(y))"));
    EXPECT_EQ(shape.loops, 1);
    EXPECT_EQ(shape.depths.at(Op::exp), Depths{0});
    EXPECT_EQ(shape.depths.at(Op::sqrt), Depths{0});
    EXPECT_EQ(shape.depths.at(Op::sin), Depths{1});
}

// Takes minutes where a level of sums costs as much as all of them.
TEST(Schedule, LongChainsOfSums) {
    constexpr int levels = 12'000;
    std::string text = "s0 = x;";
    for (int k = 0; k < levels; ++k)
        text +=
            "s" + std::to_string(k + 1) + " = sum(blobs, sin(cx + s" + std::to_string(k) + "));";
    const Shape shape = shape_of(program_of(text + "s" + std::to_string(levels)));
    EXPECT_EQ(shape.loops, levels);
    EXPECT_EQ(shape.deepest, 1);
}

TEST(Schedule, NestedSumsHoistToTheLoopTheyNeed) {
    const Shape shape =
        shape_of(program_of("sum(blobs, sum(links, exp(cx*x)*sin(px + cy)*cos(y)))"));
    EXPECT_EQ(shape.loops, 2);
    EXPECT_EQ(shape.deepest, 2);
    EXPECT_EQ(shape.depths.at(Op::cos), Depths{0});
    EXPECT_EQ(shape.depths.at(Op::exp), Depths{1});
    EXPECT_EQ(shape.depths.at(Op::sin), Depths{2});
}

TEST(Schedule, ASharedFieldIsReadBeforeTheLoop) {
    const Shape shape = shape_of(program_of("sum(links, sin(width)*px)"));
    EXPECT_EQ(shape.depths.at(Op::sin), Depths{0});
    EXPECT_EQ(shape.depths.at(Op::parameter), Depths{0});
}

TEST(Schedule, SumsOverOneArrayShareALoop) {
    EXPECT_EQ(iterations("sum(blobs, cx) + sum(blobs, cy)*sum(blobs, exp(cz))", {75, 0}), 75);
    // Also where one of them holds a loop of its own.
    EXPECT_EQ(iterations("sum(blobs, sum(links, max(cx, px))) + sum(blobs, cy)", {10, 4}),
              10 + 10 * 4);
    const Program program = program_of("sum(blobs, exp(x-cx)) + sum(blobs, exp(x-cx)*cy)");
    EXPECT_EQ(shape_of(program).loops, 1);
    EXPECT_EQ(shape_of(program).depths.at(Op::exp).size(), 1u);
}

TEST(Schedule, ValueAndDerivativesShareALoop) {
    const Field field = make_field("sum(blobs, weight*exp(-s*((x-cx)^2+(y-cy)^2+(z-cz)^2))) - a",
                                   test_vocabulary());
    for (const Program* program : {&field.value, &field.directional, &field.gradient}) {
        const Shape shape = shape_of(*program);
        EXPECT_EQ(shape.loops, 1);
        EXPECT_EQ(shape.depths.at(Op::exp), Depths{1});
    }
    EXPECT_EQ(cost(field.gradient, std::array{75, 0}).iterations, 75);
}

TEST(Schedule, SumsThatFeedSumsRunOneAfterTheOther) {
    // The inner sum doesn't depend on the outer element, so it is no nested loop.
    EXPECT_EQ(iterations("sum(blobs, cx*sum(links, px))", {10, 4}), 14);
    EXPECT_EQ(iterations("sum(blobs, (cx - sum(links, px)/sum(links, 1))^2)", {10, 4}), 14);
    // The mean of one array, used by a second sum over the same array.
    EXPECT_EQ(iterations("q = sum(blobs, cx)/sum(blobs, 1); sum(blobs, (cx-q)^2)", {10, 0}), 20);
    EXPECT_EQ(iterations("sum(blobs, sum(links, max(cx, px)))", {10, 4}), 10 + 10 * 4);
    EXPECT_EQ(iterations("sum(links, sum(blobs, max(cx, px)))", {10, 4}), 4 + 10 * 4);
}

TEST(Schedule, FactorsLeaveTheSumsTheyDoNotBelongTo) {
    // A product over two arrays is no nested loop.
    EXPECT_EQ(iterations("sum(blobs, sum(links, cx*px))", {10, 4}), 14);
    EXPECT_EQ(iterations("sum(blobs, sum(links, x*px*y*cx*3))", {10, 4}), 14);
    const auto operations = [](std::string_view text) {
        return cost(program_of(text), std::array{1000, 0}).operations;
    };
    // One accumulation an element, whatever stands before it.
    EXPECT_EQ(operations("sum(blobs, cx)"), 1000);
    EXPECT_EQ(operations("sum(blobs, 2*x*cx)"), 1002);
    EXPECT_EQ(operations("sum(blobs, -cx)"), 1001);
    EXPECT_EQ(operations("sum(blobs, cx*sin(x)*y - cy*sin(x)*y)"), 2000 + 3);
}

TEST(Schedule, WellFormed) {
    for (const auto* text :
         {"1", "x", "sum(blobs, 1)", "sum(blobs, x)", "sum(blobs, sum(links, 1))",
          "sum(blobs, sum(links, cx)*px1 + 0*cx)", "sum(blobs, cx)*sum(links, px)",
          "q = sum(links, px*y); sum(blobs, cx*q + sum(links, px*cx*q)) + q",
          "sum(blobs, exp(sum(links, sin(cx*px)) - sum(links, px)))"}) {
        SCOPED_TRACE(text);
        Vocabulary v = test_vocabulary();
        v.parameters.push_back("px1");
        Graph graph;
        const NodeId root = parse(text, v, graph);
        const Program program = schedule(graph, std::array{root});
        EXPECT_EQ(shape_of(program).dangling, 0);
        // Every operand is written before it is read.
        std::set<Register> written;
        for (const Instruction& now : program.instructions) {
            const int reads = now.arity;
            for (int k = 0; k < reads; ++k) {
                EXPECT_TRUE(written.contains(now.operands[std::size_t(k)]));
            }
            if (now.kind == Kind::accumulate) {
                EXPECT_TRUE(written.contains(now.result));
            }
            if (now.result >= 0) written.insert(now.result);
        }
        for (const Register output : program.outputs) EXPECT_TRUE(written.contains(output));
        for (const Register r : written) EXPECT_LT(r, program.registers);
    }
}

TEST(Schedule, TextsValues) {
    const auto bindings = test_bindings(3, 2);
    // cx: 0.25, -0.125, -0.5; cy is 0.25 more. px: 0.25, -0.125.
    const auto value = [&](std::string_view text) { return value_of(text, {2, 3, 5}, bindings); };
    EXPECT_EQ(value("sum(blobs, 1)"), 3);
    EXPECT_EQ(value("sum(blobs, sum(links, 1))"), 6);
    EXPECT_EQ(value("sum(blobs, x)"), 6);
    EXPECT_EQ(value("sum(blobs, cx) + sum(blobs, cy)"), -0.375 + 0.375);
    EXPECT_EQ(value("sum(blobs, sum(links, cx*px))"), -0.375 * 0.125);
    EXPECT_EQ(value("sum(links, sum(blobs, cx*px))"), -0.375 * 0.125);
    EXPECT_EQ(value("sum(blobs, cx*sum(links, px))"), -0.375 * 0.125);
    EXPECT_EQ(value("q = sum(blobs, cx)/sum(blobs, 1); sum(blobs, (cx-q)^2)"), 0.28125);
    EXPECT_EQ(value("sum(blobs, sum(links, cx + px + x)^2)"), [] {
        double total = 0;
        for (const double cx : {0.25, -0.125, -0.5}) {
            const double inner = 2 * cx + 0.125 + 4;
            total += inner * inner;
        }
        return total;
    }());
}

TEST(Schedule, EmptyArraysAndSingleElements) {
    for (const auto* text : {"sum(blobs, 1)", "sum(blobs, exp(x-cx)/cy)", "sum(blobs, 1/0.5)",
                             "sum(blobs, sum(links, cx*px))", "sum(links, sum(blobs, cx*px))"}) {
        EXPECT_EQ(value_of(text, {1, 2, 3}, test_bindings(0, 2)), 0) << text;
    }
    EXPECT_EQ(value_of("sum(blobs, 3+sum(links, cx*px))", {}, test_bindings(4, 0)), 12);
    EXPECT_EQ(value_of("sum(blobs, 1) + sum(blobs, cx)", {}, test_bindings(1, 0)), 1.25);
    EXPECT_EQ(value_of("sum(blobs, 1)", {}, test_bindings(1000, 0)), 1000);
    EXPECT_EQ(value_of("5 + sum(blobs, cx)*sum(links, px)", {}, test_bindings(0, 0)), 5);
}

TEST(Schedule, SeveralRootsAndRepeatedOnes) {
    Graph g;
    const NodeId f = parse(g, "sum(blobs, cx*x)"), seven = g.constant(7), x = g.input(0);
    const std::array roots{f, seven, f, x, g.unary(Op::negate, f)};
    const Program program = schedule(g, roots);
    ASSERT_EQ(program.outputs.size(), roots.size());
    EXPECT_EQ(program.outputs[0], program.outputs[2]);
    std::array<double, 5> out{};
    Evaluator<double>(program).point(test_bindings(), Point{2, 0, 0}, out);
    EXPECT_EQ(out, (std::array{-0.75, 7.0, -0.75, 2.0, 0.75}));
}

TEST(Cost, CountsOperationsAndIterations) {
    const auto operations = [](std::string_view text, int blobs, int links) {
        return cost(program_of(text), std::array{blobs, links}).operations;
    };
    EXPECT_EQ(operations("x", 0, 0), 0);
    EXPECT_EQ(operations("x*y + 1", 0, 0), 2);
    EXPECT_EQ(operations("x^16", 0, 0), 4);
    // One difference and one accumulation an element; the sine once.
    EXPECT_EQ(operations("sum(blobs, cx - sin(x))", 75, 0), 1 + 75 * 2);
    EXPECT_EQ(operations("sum(blobs, cx - sin(x))", 0, 0), 1);
    EXPECT_EQ(operations("sum(blobs, sum(links, max(cx, px)))", 5, 7), 5 * (7 * 2 + 1));
    // A missing count is an empty array.
    EXPECT_EQ(cost(program_of("sum(links, px)"), std::array{3}).iterations, 0);
}

} // namespace
} // namespace isomotion::formula
