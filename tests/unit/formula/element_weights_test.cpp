// Which term weighs elements, and which means may leave out elements where the field does.
#include "formula/element_weights.h"

#include <fmt/format.h>

#include "formula/paint.h"
#include "testing.h"

namespace isomotion::formula {
namespace {

const std::string r2 = "((x-cx)^2 + (y-cy)^2 + (z-cz)^2)";
const std::string hat = "max(0, 1 - " + r2 + "/width^2)^3";
const std::string gauss = "exp(-4*" + r2 + ")";

// The weight that is found in a field, as its values at a place for three elements.
std::vector<double> weights(const std::string& field) {
    Graph graph;
    const NodeId root = parse(graph, field);
    const auto weight = element_weight(graph, root, 0);
    if (!weight) return {};
    std::vector<double> found;
    Bindings<double> bindings = test_bindings(1);
    for (const double shift : {0.0, 0.05, 0.2}) {
        for (auto& column : bindings.arrays[0].fields) column[0] += shift;
        // One element's part, summed over one element.
        Graph copy = graph;
        found.push_back(value_of(copy, copy.sum(0, *weight), {0.3, 0.4, 0.5}, bindings));
    }
    return found;
}

TEST(ElementWeight, IsTheTermOfTheFirstSum) {
    EXPECT_EQ(weights("0.3 - sum(blobs, " + gauss + ")"), weights("sum(blobs, " + gauss + ")"));
    EXPECT_EQ(weights("1 - sum(blobs, weight*" + gauss + ") - sum(blobs, " + hat + ")"),
              weights("sum(blobs, weight*" + gauss + ")"));
    EXPECT_EQ(weights("-log(sum(blobs, " + gauss + "))/8"), weights("sum(blobs, " + gauss + ")"));
    EXPECT_NE(weights("sum(blobs, weight*" + gauss + ")"), weights("sum(blobs, " + gauss + ")"));
}

// The mean position of Zhu and Bridson stands before the sum of the weights in the text.
TEST(ElementWeight, OfARatioIsTheWeightWhereverItStands) {
    const auto mean = [&](const std::string& c) {
        return "sum(blobs, " + c + "*" + hat + ")/sum(blobs, " + hat + ")";
    };
    const std::string field = "sqrt((x - " + mean("cx") + ")^2 + (y - " + mean("cy") +
                              ")^2 + (z - " + mean("cz") + ")^2) - " + mean("r");
    EXPECT_EQ(weights(field), weights("sum(blobs, " + hat + ")"));
}

TEST(ElementWeight, IsOfThatArrayAndOfNoSumWithin) {
    EXPECT_TRUE(weights("x + sum(links, px*x)").empty());
    EXPECT_TRUE(weights("x^2 - 1").empty());
    EXPECT_TRUE(weights("sum(links, sum(blobs, exp(x*cx*px)))").empty());
}

bool alike(const std::string& field, const std::string& paint) {
    const Paint made = make_paint(paint, test_vocabulary(), make_field(field, test_vocabulary()));
    return weigh_like_field(made.graph, made.field, made.roots, 0);
}

TEST(WeighLikeField, WhereTheTermHasAllFactorsOfOneOfTheFields) {
    for (const std::string& kernel : {gauss, hat, "weight*" + gauss, hat + "/(1 + " + r2 + ")"}) {
        const std::string field = "0.3 - sum(blobs, " + kernel + ")";
        EXPECT_TRUE(alike(field, "sum(blobs, s*" + kernel + ")/sum(blobs, " + kernel + ")"));
        EXPECT_TRUE(alike(field, "sum(blobs, (" + kernel + ")*(s - 2*r + a)*nx*t)"));
        EXPECT_TRUE(alike(field, "2 - 7*sum(blobs, -3*abs(" + kernel + ")/s)"));
        EXPECT_TRUE(alike(field, "x*sum(blobs, x*" + kernel + ")")) << "x leaves the sum";
        EXPECT_TRUE(alike(field, "sum(blobs, x*cx*(" + kernel + ")/(2 + y))"));
        EXPECT_TRUE(alike(field, "nx + mean_curvature")) << "there is no sum";
        EXPECT_TRUE(alike(field, "sum(links, exp(-x*px))")) << "another array";
        // Wider, or of other elements.
        EXPECT_FALSE(alike(field, "sum(blobs, s*exp(-3*" + r2 + "))"));
        EXPECT_FALSE(alike(field, "sum(blobs, s)"));
        EXPECT_FALSE(alike(field, "sum(blobs, s*(" + kernel + ") + 1e-9)"));
        EXPECT_FALSE(alike(field, "sum(blobs, s*(x - cx)*" + kernel + ")"));
        EXPECT_FALSE(alike(field, "sum(blobs, s*(" + kernel + ")/(" + kernel + "))"));
    }
}

// An element without weight has no term in the field, whatever its kernel is.
TEST(WeighLikeField, NotWithoutTheElementsOwnFactor) {
    const std::string field = "0.3 - sum(blobs, weight*" + gauss + ")";
    EXPECT_FALSE(alike(field, "sum(blobs, " + gauss + ")"));
    EXPECT_FALSE(alike(field, "sum(blobs, s*" + gauss + "/weight)"));
    EXPECT_TRUE(alike(field, "sum(blobs, weight^2*" + gauss + ")"));
}

// Nor where the place makes the field's small.
TEST(WeighLikeField, NotWithoutTheFieldsFactorOfThePlace) {
    const std::string field = "0.3 - sum(blobs, weight*" + gauss + "/(1 + x^2))";
    EXPECT_FALSE(alike(field, "sum(blobs, weight*" + gauss + ")"));
    EXPECT_TRUE(alike(field, "sum(blobs, s*weight*" + gauss + "/(1 + x^2))"));
}

TEST(WeighLikeField, OneOfSeveralSumsWillDo) {
    const std::string field = "sum(blobs, s*" + hat + ") - sum(blobs, " + gauss + ")";
    EXPECT_TRUE(alike(field, "sum(blobs, r*" + gauss + ") + sum(blobs, s*r*" + hat + ")"));
    EXPECT_FALSE(alike(field, "sum(blobs, r*" + gauss + ") + sum(blobs, r*" + hat + ")"));
}

// Powers of powers end beyond all integers, and long products in no recursion.
TEST(WeighLikeField, LongProducts) {
    std::string powers = "p0 = x + y; ", product = "cx";
    for (int k = 1; k < 2000; ++k) powers += fmt::format("p{0} = p{1}*p{1}*x; ", k, k - 1);
    EXPECT_TRUE(
        alike(powers + "sum(blobs, exp(x*cx)/p1999)", powers + "sum(blobs, s*exp(x*cx)/p1999)"));
    for (int k = 0; k < 10'000; ++k) product += fmt::format("*(cx + x + {})", k);
    EXPECT_TRUE(alike("sum(blobs, " + product + ")", "sum(blobs, s*" + product + ")"));
}

} // namespace
} // namespace isomotion::formula
