// What a formula is said to be, by what it is and not by the names in it.
#include "formula/smoothness.h"

#include <cmath>

#include <gtest/gtest.h>

namespace isomotion::formula {
namespace {

Smoothness of(const std::string& text, Interval parameter = 1, double radius = 1.5) {
    Vocabulary vocabulary;
    vocabulary.parameters = {"p"};
    const Field field = make_field(text, vocabulary);
    const Interval side{-radius, radius};
    Region region{{}, {side, side, side}};
    region.bindings.parameters = {parameter};
    return smoothness(field, {&region, 1});
}

std::string words_of(const std::string& text, Interval parameter = 1) {
    return words(of(text, parameter));
}

// Of a sum over balls about the centres `cx` of each region, whose numbers differ.
std::string words_of_balls(const std::string& term, const std::vector<std::vector<double>>& cx) {
    Vocabulary vocabulary;
    vocabulary.arrays = {{"balls", {{"cx", {}}}}};
    const Field field = make_field("sum(balls, " + term + ") - 0.3", vocabulary);
    std::vector<Region> regions;
    for (const std::vector<double>& centres : cx) {
        Region& region = regions.emplace_back();
        region.box = {Interval{-1.5, 1.5}, {-1.5, 1.5}, {-1.5, 1.5}};
        ArrayColumns<Interval> array{int(centres.size()), {{centres.begin(), centres.end()}}};
        region.bindings.arrays.push_back(std::move(array));
    }
    return words(smoothness(field, regions));
}

// Elements are looked at one by one, in each region those that it has.
TEST(Smoothness, OfSumsIsThatOfEachElement) {
    const std::string pole = "0.01/((x - cx)^2 + y^2 + z^2 + 0.01)";
    EXPECT_EQ(words_of_balls(pole, {{0.1, 0.5, -0.5}, {0.2}, {}}), "smooth");
    EXPECT_EQ(words_of_balls(pole, {{0.2}, {0.1, 0.5, -0.5}}), "smooth");
    std::vector<double> many;
    for (int k = 0; k < 3000; ++k) many.push_back(0.001 * k - 1.5);
    EXPECT_EQ(words_of_balls(pole, {many}), "smooth");
    // Within the bounds from the second region on.
    const std::string kink = "max(0, 1 - (x - cx)^2 - y^2 - z^2)";
    EXPECT_EQ(words_of_balls(kink, {{40, 50}, {60, 50, 40}}), "smooth");
    EXPECT_EQ(words_of_balls(kink, {{40, 50}, {60, 50, 0.2}}), "with kinks");
}

TEST(Smoothness, OfPolynomialsIsTheirDegree) {
    EXPECT_EQ(words_of("x^2 + y^2 + z^2 - 1"), "polynomial of degree 2");
    EXPECT_EQ(words_of("(x^2 + y^2 + z^2)^3 - p*x*y"), "polynomial of degree 6");
    EXPECT_EQ(words_of("x/p + y"), "polynomial of degree 1");
}

TEST(Smoothness, IsOfTheBoundsNotOfTheNames) {
    for (const char* text :
         {"sin(x) + cos(y)*exp(z)", "sqrt(x^2 + y^2 + 0.1) - z", "1/(1 + x^2) - y",
          "log(x + 2) + z", "abs(x + 2) + y", "max(x, y + 4) - z", "tan(x/2) + y", "acos(x/3) - z",
          "(x + 2)^0.3 - y", "floor(x/10 + 0.5) + y + z*x", "sign(x + 4)*y - z + x^2*sin(z)"}) {
        EXPECT_EQ(words_of(text), "smooth") << text;
    }
}

TEST(Smoothness, KinksAreWhereSlopesChange) {
    for (const char* text :
         {"abs(x) + y", "min(x, y) - 0.1", "max(x^2 + y^2 - 1, z)",
          "abs(x^2 + y^2 + z^2 - 1) - 0.1", "abs(x)^0.3 + y", "sqrt(abs(x)) + y^2 - 0.5",
          "abs(x)^1.0001 - y", "asin(x) - y", "sqrt(x) + y",
          "sqrt(x^2 + y^2) - z"}) { // a cone: no line meets its tip, but F is 0 there
        EXPECT_EQ(words_of(text), "with kinks") << text;
    }
}

TEST(Smoothness, KinksAcrossWhichSlopesGoOnAreNone) {
    for (const char* text :
         {"abs(x)^2 + y + sin(z)", "abs(x)^3 + y", "max(0, 1 - x^2 - y^2)^3 - 0.2",
          "max(0, 1 - x^2 - y^2)^2 - 0.2", "cos(6*acos(abs(x)/2)) + y", "abs(x)^p + y",
          "max(x, 0)^2 - max(-x, 0)^2 + sin(y)",
          "(1 - sqrt(x^2 + y^2))^2 + z^2 - 0.1"}) { // a torus: its axis is off the surface
        EXPECT_EQ(words_of(text, 2.5), "smooth") << text;
    }
    // What a parameter comes to decides.
    EXPECT_EQ(words_of("abs(x)^p + y", 0.8), "with kinks");
    EXPECT_EQ(words_of("(p - sqrt(x^2 + y^2))^2 + z^2 - 0.25", Interval(0.4, 0.6)), "with kinks");
}

TEST(Smoothness, JumpsAndPolesCount) {
    for (const char* text : {"floor(3*x) + y", "sign(x) + y - 0.1", "x - floor(x)"})
        EXPECT_TRUE(of(text).jumps) << text;
    for (const char* text : {"1/x + y", "1/(x - 0.3) + 1/(y + 0.2) + z", "tan(3*x) + y",
                             "log(x) + y", "x^(-3) + y", "log(x + 0.5) - 1", "x^0.5*log(y)"})
        EXPECT_TRUE(of(text).poles) << text;
    // A pole that no ray meets and around which F is large changes nothing.
    EXPECT_EQ(words_of("1/(x^2 + y^2 + z^2) - 1"), "smooth");
    EXPECT_TRUE(of("(x^2 - y)/(x^2 + y^2 + z^2)").poles);
}

// Some field of an element decides, whichever.
TEST(Smoothness, OfSumsIsThatOfAllElements) {
    Vocabulary vocabulary;
    vocabulary.arrays = {{"blobs", {{"c", {}}, {"a", {}}}}};
    const auto with = [&](const char* text, double last) {
        const Field field = make_field(text, vocabulary);
        const Interval side{-1, 1};
        Region region{{}, {side, side, side}};
        region.bindings.arrays = {{3, {{0, 0.2, 0.4}, {0.1, 0.1, last}}}};
        return words(smoothness(field, {&region, 1}));
    };
    EXPECT_EQ(with("sum(blobs, exp(-(x - c)^2)) - 1", 0.1), "smooth");
    EXPECT_EQ(with("sum(blobs, abs(x - c)) - 1", 0.1), "with kinks");
    EXPECT_EQ(with("sum(blobs, abs(y - c + 3)) - 1 + sin(x)", 0.1), "smooth");
    EXPECT_EQ(with("sum(blobs, abs(y - c - 3 + 30*a)) - 1 + sin(x)", 10), "with kinks");
    EXPECT_EQ(with("sum(blobs, max(0, 1 - (x - c)^2/a)^3) - 0.5", 0.1), "smooth");
    // Of equal keys, too: shaders cut keys off.
    EXPECT_EQ(with("least(blobs, (x - 0.1)^2 + y^2 + z^2) - 0.5", 0.1), "with kinks");
}

// A soft object is flat from its radius on. Of an array's elements, no step leaves out any: the
// bend at their edges is none. Elsewhere bounds have to look for what is in the flat.
TEST(Smoothness, SoftObjectsAreSmoothAsElementsOfTheOneArray) {
    const std::string place = "((x - cx)^2 + (y - cy)^2 + (z - cz)^2)";
    const auto of_elements = [&](const std::string& text, int arrays, int hard_one) {
        Vocabulary vocabulary;
        vocabulary.arrays = {{"a", {{"cx", {}}, {"cy", {}}, {"cz", {}}, {"hard", {}}}},
                             {"b", {{"bx", {}}}}};
        vocabulary.arrays.resize(std::size_t(arrays));
        const Field field = make_field(text, vocabulary);
        const Interval side{-1, 1};
        Region region{{}, {side, side, side}};
        std::vector<std::vector<Interval>> columns(4);
        for (int k = 0; k < 24; ++k) {
            for (std::size_t axis = 0; axis < 3; ++axis)
                columns[axis].push_back(0.8 * std::sin(double(k * k) + 2.0 * double(axis)));
            columns[3].push_back(k == hard_one ? 1.0 : 0.0);
        }
        region.bindings.arrays = {{24, columns}};
        if (arrays > 1) region.bindings.arrays.push_back({2, {{-0.5, 0.5}}});
        return words(smoothness(field, {&region, 1}));
    };
    for (const std::string reach : {"9", "40", "150"}) {
        const std::string u = "min(1, " + reach + "*" + place + ")";
        EXPECT_EQ(of_elements("sum(a, (1 - " + u + ")^2*(1 - 4/9*" + u + ")) - 0.5", 1, -1),
                  "smooth");
        EXPECT_EQ(of_elements("sum(a, (1 - " + u + ")^2) - 0.5", 1, -1), "smooth");
        EXPECT_EQ(of_elements("sum(a, 1 - " + u + ") - 0.5", 1, -1), "with kinks");
    }
    const std::string u = "min(1, 9*" + place + ")";
    const std::string mixed = "sum(a, (1 - " + u + ")*(1 - " + u + "*(1 - hard))) - 0.5";
    EXPECT_EQ(of_elements(mixed, 1, -1), "smooth");
    for (int hard_one = 0; hard_one < 24; ++hard_one)
        EXPECT_EQ(of_elements(mixed, 1, hard_one), "with kinks") << hard_one;
    // Discs may be thinner than the least radius by which steps are bounded.
    const std::string disc = "min(1, 9*((x - cx)^2 + (y - cy)^2 + 100*(z - cz)^2))";
    EXPECT_EQ(of_elements("sum(a, (1 - " + disc + ")^2) - 0.5", 1, -1), "with kinks");
    const std::string tiny = "min(1, 3000*" + place + ")";
    EXPECT_EQ(of_elements("sum(a, (1 - " + tiny + ")^2) - 0.5", 1, -1), "with kinks");
    // Nothing bounds steps between balls that are no elements.
    const std::string ball = "min(1, 5*(sin(9*x)^2 + sin(9*y)^2 + sin(9*z)^2))";
    EXPECT_EQ(words_of("(1 - " + ball + ")^2 - 0.5"), "with kinks");
}

} // namespace
} // namespace isomotion::formula
