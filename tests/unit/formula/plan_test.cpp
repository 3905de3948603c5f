// What an evaluator makes of a program.
#include "formula/evaluate/plan.h"

#include "testing.h"

#include "random_formula.h"

namespace isomotion::formula {
namespace {

using Kind = Instruction::Kind;

Program scheduled(std::string_view text) {
    Graph graph;
    const NodeId root = parse(graph, text);
    return schedule(graph, std::array{root});
}

// How often its products are taken each way.
std::map<Product, int> products(std::string_view text) {
    std::map<Product, int> count;
    for (const Step& step : plan(scheduled(text), true).steps) {
        if (step.op == Op::multiply) ++count[step.product];
    }
    return count;
}

TEST(Plan, RegistersServeAgain) {
    std::string text = "x";
    for (int k = 0; k < 50; ++k) text = "sin(" + text + " + y)";
    EXPECT_GT(scheduled(text).registers, 100);
    EXPECT_LT(plan(scheduled(text), false).registers, 6);
}

// Puts into each register the number of the value that it should hold, and asks for it.
TEST(Plan, RegistersHoldWhatIsAskedFor) {
    std::size_t asked = 0;
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        FormulaGenerator generator(seed);
        const Program program = scheduled(generator.make(2 + int(seed % 5)).text);
        const Plan made = plan(program, true);
        std::vector<Register> holds(std::size_t(made.registers), -1);
        std::size_t next = 0;
        for (const Instruction& now : program.instructions) {
            if (now.kind == Kind::operation && now.op == Op::input)
                holds[std::size_t(made.inputs[std::size_t(now.index)])] = now.result;
        }
        // A second round of each loop asks for the same.
        std::vector<std::pair<std::size_t, std::size_t>> open;
        for (std::size_t at = 0; at < program.instructions.size(); ++at) {
            const Instruction& now = program.instructions[at];
            if (now.kind == Kind::operation && now.op == Op::input) continue;
            const Step& step = made.steps[next++];
            ASSERT_EQ(step.kind, now.kind);
            if (now.kind == Kind::loop_begin) {
                open.emplace_back(at, next);
                continue;
            }
            if (now.kind == Kind::loop_end) {
                const auto [begin, first] = open.back();
                open.pop_back();
                if (begin == program.instructions.size()) continue;
                open.emplace_back(program.instructions.size(), first);
                at = begin;
                next = first;
                continue;
            }
            std::vector<Register> expected, found;
            if (now.kind != Kind::begin) {
                for (std::size_t k = 0; k < now.arity; ++k) {
                    expected.push_back(now.operands[k]);
                    found.push_back(holds[std::size_t(step.operands[k])]);
                }
            }
            if (now.kind == Kind::accumulate) {
                expected.push_back(now.result);
                found.push_back(holds[std::size_t(step.result)]);
            }
            std::ranges::sort(expected); // factors may change places
            std::ranges::sort(found);
            ASSERT_EQ(found, expected);
            asked += found.size();
            holds[std::size_t(step.result)] = now.result;
        }
        for (std::size_t o = 0; o < program.outputs.size(); ++o)
            ASSERT_EQ(holds[std::size_t(made.outputs[o])], program.outputs[o]);
    }
    EXPECT_GT(asked, 4000u);
}

TEST(Plan, KnowsSignsOfFactors) {
    EXPECT_EQ(products("x*y")[Product::any], 1);
    EXPECT_EQ(products("x*x")[Product::square], 1);
    EXPECT_EQ(products("x*exp(y)")[Product::by_not_negative], 1);
    EXPECT_EQ(products("exp(y)*x")[Product::by_not_negative], 1);
    EXPECT_EQ(products("sqrt(x)*exp(y)")[Product::of_not_negative], 1);
    EXPECT_EQ(products("x*(1/(1 + y^2))")[Product::by_not_negative], 1);
    EXPECT_EQ(products("x*(1/(1 + y))")[Product::any], 1);
    EXPECT_EQ(products("x*(exp(y) - 1)")[Product::any], 1);
    EXPECT_EQ(products("x*min(exp(y), z)")[Product::any], 1);
    EXPECT_EQ(products("x*max(exp(y), z)")[Product::by_not_negative], 1);
    EXPECT_EQ(products("3*x")[Product::by_uniform], 1);
    EXPECT_EQ(products("a*x")[Product::by_uniform], 1);
    EXPECT_EQ(products("x*sum(blobs, exp(cx*y))")[Product::by_not_negative], 1);
    EXPECT_EQ(products("x*sum(blobs, sin(cx*y))")[Product::any], 1);
}

// What depends on no input is computed at one point of a block.
TEST(Plan, TellsWhatIsTheSameAtAllPoints) {
    for (const auto& [text, uniform] : {std::pair{"sin(a) + x", 1},
                                        {"sum(blobs, sin(cx) + x)", 1},
                                        {"sum(blobs, sin(cx + x))", 0}}) {
        SCOPED_TRACE(text);
        int count = 0;
        for (const Step& step : plan(scheduled(text), false).steps)
            count += step.op == Op::sin && step.is_uniform ? 1 : 0;
        EXPECT_EQ(count, uniform);
    }
}

} // namespace
} // namespace isomotion::formula
