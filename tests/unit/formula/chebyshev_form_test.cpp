#include "formula/graph/chebyshev_form.h"

#include "formula/enclosure.h"
#include "formula/graph/operations.h"
#include "formula/graph/substitute.h"
#include "testing.h"

namespace isomotion::formula {
namespace {

struct Rewritten {
    Graph graph;
    NodeId from = 0, to = 0;

    explicit Rewritten(const std::string& text) {
        const NodeId root = parse(graph, text);
        graph.fold_exactly();
        from = root;
        to = with_chebyshev(graph, root);
    }

    bool has(Op op) const {
        const auto below = nodes_below(graph, std::array{to});
        return std::ranges::any_of(below, [&](NodeId id) { return graph[id].op == op; });
    }
};

// T_n(u) of u >= 1.
std::string outside(const std::string& u, const std::string& degree = "14") {
    return "cosh(" + degree + "*log(" + u + " + sqrt((" + u + " - 1)*(" + u + " + 1))))";
}

const std::vector<std::string> forms{
    "cos(14*acos(min(abs(x), 1)))*" + outside("max(1, abs(x))"),
    "cos(-7*acos(min(1, abs(x))))*" + outside("max(abs(x), 1)", "7"),
    "cos(7*acos(x))*" + outside("max(1, abs(x))", "7") + " + y",
    "cos(8*acos(max(-1, min(x, 1))))*" + outside("max(1, abs(x))", "8") + " + y",
    outside("max(1, abs(x))", "50") + "*cos(acos(min(max(x, -1), 1))*50)",
    "cos(5*acos(min(1, 2*x - y)))*" + outside("max(1, min(3, abs(2*x - y)))", "5") + "*z",
    "cos(5*acos(x*y)) - z",
    "u = max(1, abs(x)); cosh(6*log(u + sqrt(u^2 - 1))) - y",
    "u = max(abs(y - a), 1); cosh(6*log(sqrt(u*u - 1) + u)) + cos(6*acos(x)) - 1",
    "u = max(1, x); cosh(3*log(u + sqrt(u - 1)*sqrt(u + 1))) - z",
    "u = 1 + 0*x; v = max(u, y); cosh(9*log(v + sqrt(-(1 - v)*(v + 1)))) - x",
    "cosh(6*acosh(max(1, abs(x)))) - y",
    "cosh(7*acosh(abs(x)))*cos(7*acos(x)) - y",
    "cosh(3*acosh(x)) - z"};

TEST(ChebyshevForm, IsFoundAndHasTheSameValues) {
    constexpr std::uint64_t seed = 71;
    for (const std::string& text : forms) {
        SCOPED_TRACE(testing::Message() << text << ", seed " << seed);
        Rewritten both(text);
        EXPECT_FALSE(both.has(Op::acos) || both.has(Op::log) || both.has(Op::acosh));
        Random random(seed);
        for (int trial = 0; trial < 300; ++trial) {
            Point p = random.point(1.25);
            if (trial % 4 == 0) p[0] = trial % 8 == 0 ? 1 : -1;
            const double expected = value_of(both.graph, both.from, p);
            EXPECT_NEAR(value_of(both.graph, both.to, p), expected, 1e-6 * (1 + std::abs(expected)))
                << testing::PrintToString(p);
        }
    }
}

// Without an end, which a program would have; through elements; and by n that has a name.
TEST(ChebyshevForm, OnPaperIsThePolynomialAlone) {
    const auto number = [](int) { return std::optional(4.0); };
    const auto on_paper = [&](const std::string& text) {
        Graph graph;
        const NodeId root = parse(graph, text);
        return std::pair(graph, chebyshev_on_paper(graph, root, number));
    };
    for (const auto& [written, polynomial] : std::vector<std::pair<std::string, std::string>>{
             {forms[0], "chebyshev(14, x)"},
             {forms[1], "chebyshev(7, abs(x))"},
             {forms[2], "chebyshev(7, x) + y"},
             {forms[4], "chebyshev(50, x)"},
             {forms[8], "chebyshev(6, max(abs(y - a), 1)) + chebyshev(6, min(1, max(-1, x))) - 1"},
             {"cos(7*acos(x))*cosh(7*acosh(abs(x)))", "chebyshev(7, x)"},
             {"cosh(3*acosh(x))", "chebyshev(3, max(1, x))"},
             {"cos(a*acos(x))", "chebyshev(4, max(-1, min(1, x)))"},
             {"cos(acos(x)*a)*" + outside("max(1, abs(x))", "4"), "chebyshev(4, x)"},
             {"sum(blobs, " + outside("max(1, abs(x - cx))") + ")",
              "sum(blobs, chebyshev(14, max(1, abs(x - cx))))"}}) {
        auto [graph, found] = on_paper(written);
        Random random(73);
        const NodeId expected = parse(graph, polynomial);
        for (int trial = 0; trial < 100; ++trial) {
            const Point p = random.point(1.25);
            const double value = value_of(graph, expected, p);
            EXPECT_NEAR(value_of(graph, found, p), value, 1e-9 * (1 + std::abs(value))) << written;
        }
        for (const NodeId id : nodes_below(graph, std::array{found})) {
            const Op op = graph[id].op;
            EXPECT_FALSE(op == Op::cos || op == Op::cosh || op == Op::select) << written;
        }
    }
    // A program, whose parameters may change, takes them as they come.
    EXPECT_TRUE(Rewritten("cos(a*acos(x))").has(Op::acos));
}

// One polynomial, where both halves are there: of even degree it needs no size.
TEST(ChebyshevForm, HalvesAreJoined) {
    for (const std::size_t k : {0, 2, 3, 4}) {
        const Rewritten all(forms[k]);
        EXPECT_FALSE(all.has(Op::min) || all.has(Op::max) || all.has(Op::abs)) << forms[k];
    }
    const Rewritten odd(forms[1]);
    EXPECT_TRUE(odd.has(Op::abs));
}

TEST(ChebyshevForm, OthersStayAsTheyAre) {
    for (const std::string& text : std::vector<std::string>{
             "cos(2.5*acos(x))", "cos(a*acos(x))", "cos(acos(x))", "cos(14*asin(x))",
             "cos(1001*acos(x))", "sin(14*acos(x))", "cosh(14*acos(x))",
             outside("abs(x)"), // where it is less, it is another function
             outside("max(0.999, abs(x))"), outside("max(a, abs(x))"),
             "u = max(1, x); cosh(5*log(u + sqrt(u^2 + 1)))",
             "u = max(1, x); cosh(5*log(u - sqrt(u^2 - 1)))",
             "u = max(1, x); cosh(5*log(u + sqrt(u^2 - 1) + 1))",
             "u = max(1, x); cosh(5*log(u + sqrt(2*u^2 - 1)))",
             "u = max(1, x); cosh(5*log(u + sqrt(1 - u)*sqrt(-1 - u)))", // that root is 0
             "u = max(1, x); cosh(5*log(u + sqrt(u^3 - 1)))",
             "u = max(1, x); v = max(1, y); cosh(5*log(u + sqrt(v^2 - 1)))",
             "sum(blobs, cos(4*acos(x - cx)))", "cos(4*acos(x)) + sum(blobs, cx*x)"}) {
        const Rewritten same(text);
        EXPECT_EQ(same.from, same.to) << text;
    }
}

// Halves that don't fit together stay two factors.
TEST(ChebyshevForm, OtherHalvesAreNotJoined) {
    for (const std::string& text : std::vector<std::string>{
             "cos(14*acos(min(abs(x), 1)))*" + outside("max(1, abs(x))", "12"),
             "cos(14*acos(min(abs(x), 1)))*" + outside("max(1, abs(y))"),
             "cos(14*acos(min(abs(x), 0.5)))*" + outside("max(1, abs(x))"),
             "cos(14*acos(min(abs(x), 1)))*" + outside("max(1, max(2, abs(x)))"),
             "cos(14*acos(x))*" + outside("max(1, x + 1)"),
             "cos(14*acos(max(-0.5, x)))*" + outside("max(1, abs(x))")}) {
        Rewritten both(text);
        Random random(72);
        EXPECT_TRUE(both.has(Op::max)) << text;
        for (int trial = 0; trial < 300; ++trial) {
            const Point p = random.point(1.25);
            const double expected = value_of(both.graph, both.from, p);
            EXPECT_NEAR(value_of(both.graph, both.to, p), expected, 1e-6 * (1 + std::abs(expected)))
                << text;
        }
    }
}

// cosh is cut off, at one number of floats and at another of doubles; T_n is not.
// The form is cut off where F is; elsewhere F, continuous, is seen to be so.
TEST(ChebyshevForm, LeavesFContinuous) {
    const Field field = make_field(forms[0] + " - a", test_vocabulary());
    const EnclosurePrograms programs = enclosure_programs(field);
    Evaluator<Interval> jump(programs.jumps);
    auto bindings = convert<Interval>(test_bindings());
    std::array<Interval, 3> box{Interval(0.4, 0.5), 0.0, 0.0};
    std::array<Interval, 2> told;
    jump.point(bindings, box, told);
    EXPECT_EQ(told[0].lo, 0);
    EXPECT_EQ(told[0].hi, 0);
}

TEST(ChebyshevForm, HoldsWhatIsCutOff) {
    const Field field = make_field(forms[0] + " - a", test_vocabulary());
    const EnclosurePrograms programs = enclosure_programs(field);
    Evaluator<Interval> along(programs.directional);
    auto bindings = convert<Interval>(test_bindings());
    bindings.parameters[0] = 0.0;
    const auto enclose = [&](Interval x) {
        std::array<Interval, 6> box{x, 0.0, 0.0, 1.0, 0.0, 0.0};
        std::array<Interval, 2> f;
        along.point(bindings, box, f);
        return f;
    };
    const double floats = double(Operations<float>::saturation());
    for (const double x : {1e4, 1e24, 1e200, -1e5}) {
        const auto [value, slope] = enclose(x);
        EXPECT_TRUE(contains(value, floats)) << x;
        EXPECT_EQ(value.hi, infinity) << x;
        EXPECT_GT(value.lo, 0.9 * floats) << x;
        EXPECT_TRUE(contains(slope, 0)) << x; // of what is cut off
    }
    // Where n is odd, F is cut off at both ends.
    const Field odd =
        make_field("cos(7*acos(x))*" + outside("max(1, abs(x))", "7") + " - a", test_vocabulary());
    const EnclosurePrograms of_odd = enclosure_programs(odd);
    Evaluator<Interval> along_odd(of_odd.directional);
    for (const double x : {1e5, -1e5, -1e200}) {
        std::array<Interval, 6> box{x, 0.0, 0.0, 1.0, 0.0, 0.0};
        std::array<Interval, 2> f;
        along_odd.point(bindings, box, f);
        EXPECT_TRUE(contains(f[0], x > 0 ? floats : -floats)) << x;
        EXPECT_TRUE(contains(f[1], 0)) << x;
    }
    // Between a value below the cut and one beyond it.
    const auto [value, slope] = enclose({2, 1e4});
    EXPECT_TRUE(contains(slope, floats / (1e4 - 2)));
    // There is a bound where acos and acosh have none.
    for (const Interval x : {Interval(1.0), Interval(0.9, 1.1), Interval(-1, 1)}) {
        const auto [at_one, steep] = enclose(x);
        EXPECT_LT(magnitude(steep), x.hi > 1 ? 1e4 : 196.001) << testing::PrintToString(x);
    }
}

} // namespace
} // namespace isomotion::formula
