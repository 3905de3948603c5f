#include "formula/glsl/exact_results.h"

#include <algorithm>

#include "testing.h"

namespace isomotion::formula {
namespace {

std::ptrdiff_t exact_results_of(const char* text) {
    Graph graph;
    const NodeId root = parse(graph, text);
    const std::vector<bool> exact = exact_results(schedule(graph, std::array{root}));
    return std::ranges::count(exact, true);
}

TEST(ExactResults, AreThoseThatStayWhereSomethingJumps) {
    EXPECT_EQ(exact_results_of("floor(floor(x)/2)"), 1);
    EXPECT_EQ(exact_results_of("floor(floor(x)/3 + a)"), 2);
    EXPECT_EQ(exact_results_of("floor(x*max(0, y))"), 1);
    EXPECT_EQ(exact_results_of("sign(2*floor(x)*y) + x*y"), 2);
    EXPECT_EQ(exact_results_of("floor(1 + 0.5*min(1, abs(x)))"), 2);
    EXPECT_EQ(exact_results_of("floor(abs(-(floor(x) - 2*sign(y))))"), 2);
    EXPECT_EQ(exact_results_of("sum(blobs, floor(floor(x*cx)/2))"), 1);
}

TEST(ExactResults, AreNoneWhereNumbersMoveOrNothingJumps) {
    for (const char* text : {"floor(x/0.6 + 0.5)", "floor(a*x*y - 3*z)", "floor(x)/2 + y",
                             "x*max(0, y)", "floor(sin(x*max(0, y)))", "min(x, 1)*2"})
        EXPECT_EQ(exact_results_of(text), 0) << text;
}

} // namespace
} // namespace isomotion::formula
