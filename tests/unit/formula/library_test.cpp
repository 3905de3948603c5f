// The functions that every formula can call, and expressions at other points.
#include "formula/graph/library.h"

#include <cmath>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "formula/graph/parser.h"
#include "testing.h"

namespace isomotion::formula {
namespace {

std::string mistake_in(const std::string& text) {
    Graph graph;
    try {
        parse(text, test_vocabulary(), graph);
        return "none";
    } catch (const ParseError& error) {
        return error.message();
    }
}

TEST(Library, HasSolidsAndSurfaces) {
    expect_same("sphere(2) + x", "length(x, y, z) - 2 + x");
    expect_same("torus(1, a)", "length(length(x, y) - 1, z) - a");
    expect_same("box(1, 2, 3)", "max(abs(x) - 1, abs(y) - 2, abs(z) - 3)");
    expect_same(
        "union(sphere(1), gyroid(2))",
        "min(length(x, y, z) - 1, sin(2*x)*cos(2*y) + sin(2*y)*cos(2*z) + sin(2*z)*cos(2*x))");
}

TEST(Library, MovesSpace) {
    expect_same("translate(sphere(1), 2, 0, z)", "length(x - 2, y, 0) - 1");
    expect_same("scale(x^2 + y, 2)", "2*((x/2)^2 + y/2)");
    expect_same("twist(x, 3)", "x*cos(3*z) + y*sin(3*z)");
    expect_same("mirror(translate(sphere(1), 2, 0, 0))", "length(abs(x) - 2, y, z) - 1");
}

// As a formula is that is one.
TEST(Library, TakesConditionsForSolids) {
    EXPECT_EQ(value_of("union(x < 1, 5) + 0", {-2, 0, 0}), -3);
    EXPECT_EQ(value_of("difference(sphere(3), x > 0 and y > 0) + 0", {1, 2, 0}), 1);
    EXPECT_EQ(value_of("scale(x < 1, 2) + 0", {6, 0, 0}), 4);
}

// The ball goes where the axes turn to, x to y, y to z and z to x.
TEST(Library, TurnsAnticlockwise) {
    const std::string ball = "translate(sphere(1), 2, 0, 0)", up = "translate(sphere(1), 0, 0, 2)";
    EXPECT_NEAR(value_of("rotate_z(" + ball + ", pi/2)", {0, 2, 0}), -1, 1e-12);
    EXPECT_NEAR(value_of("rotate(" + ball + ", pi/2)", {0, 2, 0}), -1, 1e-12);
    EXPECT_NEAR(value_of("rotate_x(translate(sphere(1), 0, 2, 0), pi/2)", {0, 0, 2}), -1, 1e-12);
    EXPECT_NEAR(value_of("rotate_y(" + up + ", pi/2)", {2, 0, 0}), -1, 1e-12);
    // A twist by k turns what is at the height z by k z, and a bend what is at x by k x.
    EXPECT_NEAR(value_of("twist(" + ball + ", pi/6)", {0, 2, 3}), std::hypot(0, 3) - 1, 1e-12);
    EXPECT_NEAR(value_of("bend(translate(sphere(1), 0, -2, 0), pi/4)", {2, 0, 0}), -1, 1e-12);
}

// Distances of points from solids, by geometry.
TEST(Library, HasDistances) {
    const auto value = [](const std::string& text, const Point& p) { return value_of(text, p); };
    EXPECT_NEAR(value("capsule(0.5, 1)", {0, 0.3, 2}), std::hypot(0.3, 1) - 0.5, 1e-12);
    EXPECT_NEAR(value("capsule(0.5, 1)", {0.2, 0.7, -0.9}), std::hypot(0.2, 0.7) - 0.5, 1e-12);
    EXPECT_NEAR(value("round_box(1, 1, 1, 0.2)", {1.3, 1.4, 0}), std::hypot(0.5, 0.6) - 0.2, 1e-12);
    EXPECT_NEAR(value("round_box(1, 1, 1, 0.2)", {0.7, 0, 0}), -0.3, 1e-12);
    EXPECT_NEAR(value("octahedron(1)", {1, 1, 1}), 2 / std::sqrt(3.0), 1e-12);
    EXPECT_NEAR(value("plane(1, 2, 2, 3)", {2, 2, 2}), (10 - 3) / 3.0, 1e-12);
    // The apex at height 4 and the rim of radius 3 lie on the cone; its side is 5 long.
    EXPECT_NEAR(value("cone(3, 4)", {0, 0, 4}), 0, 1e-12);
    EXPECT_NEAR(value("cone(3, 4)", {3, 0, 0}), 0, 1e-12);
    EXPECT_NEAR(value("cone(3, 4)", {3, 0, 4}), 12 / 5.0, 1e-12);
    EXPECT_NEAR(value("cone(3, 4)", {0, 0, -1}), 1, 1e-12);
    EXPECT_NEAR(value("cylinder(1, 2)", {0, 3, 1}), 2, 1e-12);
    // A repeated ball is the same in every cell.
    EXPECT_NEAR(value("repeat(sphere(0.3), 2)", {4.1, -1.8, 6}), std::hypot(0.1, 0.2) - 0.3, 1e-12);
}

TEST(AtAnotherPoint, ArgumentsAndPartsCanBeTaken) {
    expect_same("f(g) = g(2*x, z, y); f(x + y^2)", "2*x + z^2");
    expect_same("b = x + y^2; b(z, x, y) + b", "(z + x^2) + (x + y^2)");
    expect_same("d = x^2 + y; f(g) = g(y, z, x) + d(z, x, y); f(x)", "y + (z^2 + x)");
    expect_same("f(g) = twist(g, 2)*g; f(x)", "twist(x, 2)*x");
    expect_same("f(g) = g(x + 1, y, z); h(g) = f(g(2*x, y, z)); h(x)", "2*(x + 1)");
    // Functions of x, y and z.
    expect_same("ball(u, v, w) = u^2 + v^2 + w^2 - 1; mirror(ball)", "abs(x)^2 + y^2 + z^2 - 1");
    // One thing in parentheses is a factor.
    expect_same("f(g) = g(x + 1); f(y)", "y*(x + 1)");
    expect_same("f(g) = g(x, y, z) + g; f(sum(blobs, (x - cx)^2))", "2*sum(blobs, (x - cx)^2)");
}

TEST(AtAnotherPoint, NamesOfTheSceneStay) {
    expect_same("sphere(r) = r^2; sphere(x)", "x^2");
    expect_same("length(u, v) = u - v; torus(1, 2)*length(x, y)",
                "(sqrt((sqrt(x^2 + y^2) - 1)^2 + z^2) - 2)*(x - y)");
    const Vocabulary vocabulary{coordinate_names, {"scale"}, {}};
    Graph graph;
    EXPECT_EQ(parse("scale(x + 1)", vocabulary, graph), parse("scale*(x + 1)", vocabulary, graph));
}

TEST(AtAnotherPoint, WrongCallsAreTold) {
    EXPECT_EQ(mistake_in("sphere(1, 2)"), "sphere(r) takes 1 argument, not 2");
    EXPECT_EQ(mistake_in("box + x"), "box needs parentheses: write 'box(a, b, c)'");
    EXPECT_EQ(mistake_in("spere(1)"), "there is no function 'spere'; did you mean 'sphere'?");
    EXPECT_EQ(mistake_in("translate(log(x), -1, 0, 0)(2, 1, 1)"),
              "expected ')' to close the parenthesis");
    EXPECT_EQ(mistake_in("f(g) = g(-2, y, z); f(log(x)) + x"), "f is not defined here");
}

// A few bytes that stand for more than any memory holds.
TEST(AtAnotherPoint, DoublingEnds) {
    std::string text = "f0(g) = g(x + y, y*z, z) + g(y, x*x, z);";
    for (int k = 1; k < 40; ++k)
        text += fmt::format("f{0}(g) = f{1}(g(x + z, y, {0}*x)) + f{1}(g(z, x, y*{0}));", k, k - 1);
    EXPECT_THAT(mistake_in(text + "f39(sin(x*y) + z)"), testing::HasSubstr("the formula"));
}

// What a call looks at counts, though equal parts make no new ones.
TEST(AtAnotherPoint, WorkEnds) {
    std::string moved = "f(g) = 0", filler = "q = x", calls = "0";
    for (int k = 0; k < 1000; ++k) moved += fmt::format(" + g(x + {}, y, z)", k);
    for (int k = 0; k < 3000; ++k) filler += fmt::format(" + sin({}*x)", k);
    for (int k = 0; k < 300; ++k) calls += " + f(u)";
    EXPECT_THAT(mistake_in(moved + ";" + filler + "; u = x*y;" + calls),
                testing::HasSubstr("calls large functions too often"));
}

// The loop's own element must not be taken for the point's.
TEST(AtAnotherPoint, FieldsMoveNoLoopOverTheirArray) {
    const std::string part = "b = sum(blobs, (x - cx)^2);";
    EXPECT_THAT(mistake_in(part + "sum(blobs, b(cx, y, z) + cy)"),
                testing::HasSubstr("is moved by the array's fields"));
    EXPECT_THAT(mistake_in("f(g) = sum(blobs, g(cx, y, z) + cy); f(sum(blobs, (x - cx)^2))"),
                testing::HasSubstr("is moved by the array's fields"));
    expect_same(part + "sum(links, b(px, y, z))", "sum(links, sum(blobs, (px - cx)^2))");
}

// Rules of animation know the time and no place.
TEST(Library, NeedsAPlace) {
    Vocabulary vocabulary;
    vocabulary.inputs = {"t", "i", "n"};
    Graph graph;
    EXPECT_THROW(parse("2 + sphere(1)", vocabulary, graph), ParseError);
    EXPECT_THROW(parse("f(g) = twist(g, 2); f(t)", vocabulary, graph), ParseError);
    EXPECT_EQ(parse("union(t, 3)", vocabulary, graph), parse("min(t, 3)", vocabulary, graph));
}

TEST(Library, IsInTheDocuments) {
    std::ifstream file(ISOMOTION_SOURCE_DIR "/docs/formulas.md");
    std::stringstream text;
    text << file.rdbuf();
    const std::string list = text.str();
    for (const std::string& name : library().names()) {
        const OwnFunction* function = library().find(name);
        EXPECT_NE(list.find(fmt::format("{}({})", name, fmt::join(function->arguments, ", "))),
                  list.npos)
            << name;
    }
}

} // namespace
} // namespace isomotion::formula
