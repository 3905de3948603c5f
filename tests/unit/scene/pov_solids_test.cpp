// Objects of POV-Ray files as formulas: each is compared with its closed form at points.
#include "testing.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "formula/field.h"
#include "scene/scene_at.h"

namespace isomotion::scene::pov_solids_test {
namespace {

using testing::HasSubstr;

Scene scene_of(const std::string& text) { return load_text(text, "solids.pov"); }

std::string mistake_of(const std::string& text) { return mistake_of_text(text, "solids.pov"); }

// A point in POV-Ray's axes.
using Point = glm::dvec3;

double value_of(const Surface& surface, const SurfaceAt& now, const Point& p) {
    formula::Evaluator<double> evaluator(surface.field->value);
    const glm::dvec3 own = now.placement.to_local({p.x, p.z, p.y});
    double value = 0;
    evaluator.point(formula::convert<double>(now.bindings), std::array{own.x, own.y, own.z},
                    {&value, 1});
    return value;
}

// What the first surface's formula is at a point of the scene.
double value_at(const std::string& text, const Point& p) {
    const Scene scene = scene_of(text);
    return value_of(scene.surfaces[0], at_frame(scene, 1).surfaces[0], p);
}

// Points all over the cube from -2 to 2.
std::vector<Point> points() {
    std::vector<Point> all;
    unsigned state = 1;
    const auto next = [&] {
        state = state * 1664525u + 1013904223u;
        return double(state >> 8) / double(1 << 24) * 4 - 2;
    };
    for (int k = 0; k < 200; ++k) all.emplace_back(next(), next(), next());
    return all;
}

// Whether the formula is below 0 at the points that are inside, and above 0 at the others.
template<typename Inside> void expect_solid(const std::string& text, const Inside& inside) {
    const Scene scene = scene_of(text);
    ASSERT_EQ(scene.surfaces.size(), 1) << text;
    const SceneAt now = at_frame(scene, 1);
    int count = 0, wrong = 0;
    for (const Point& p : points()) {
        const double value = value_of(scene.surfaces[0], now.surfaces[0], p);
        const double depth = inside(p);
        if (std::abs(depth) < 1e-9) continue;
        count += depth < 0;
        wrong += !((value < 0) == (depth < 0));
    }
    EXPECT_EQ(wrong, 0) << text;
    EXPECT_GT(count, 3) << text;
}

double box(const Point& p, const Point& low, const Point& high) {
    double most = -1e9;
    for (int k = 0; k < 3; ++k) most = std::max({most, low[k] - p[k], p[k] - high[k]});
    return most;
}

// Of a segment's ends and the radii there.
double cone(const Point& p, const Point& a, double ra, const Point& b, double rb) {
    const double length = glm::length(b - a), t = glm::dot(p - a, b - a) / length;
    const double radius = glm::length(p - a - t * (b - a) / length);
    return std::max({-t, t - length, radius - ra - (rb - ra) * t / length});
}

TEST(PovSolids, ShapesAreInsideWhereTheirDefinitionsAre) {
    expect_solid("sphere { <0.2, 0.4, -0.1>, 1.3 }",
                 [](const Point& p) { return glm::length(p - Point(0.2, 0.4, -0.1)) - 1.3; });
    expect_solid("box { <1, -1, 0.3>, <-0.5, 1.5, -1> }", [](const Point& p) {
        return box(p, {-0.5, -1, -1}, {1, 1.5, 0.3});
    });
    expect_solid("cylinder { <-1, -1, 0>, <1, 0.5, 1>, 0.7 }", [](const Point& p) {
        return cone(p, {-1, -1, 0}, 0.7, {1, 0.5, 1}, 0.7);
    });
    expect_solid("cone { <0, -1.5, 0>, 1.6 <0, 1.5, 0>, 0.2 }", [](const Point& p) {
        return cone(p, {0, -1.5, 0}, 1.6, {0, 1.5, 0}, 0.2);
    });
    expect_solid("torus { 1.2, 0.6 }",
                 [](const Point& p) { return std::hypot(std::hypot(p.x, p.z) - 1.2, p.y) - 0.6; });
    expect_solid("plane { <1, 2, 2>, 0.5 }",
                 [](const Point& p) { return (p.x + 2 * p.y + 2 * p.z) / 3 - 0.5; });
    expect_solid("superellipsoid { <0.5, 0.25> }", [](const Point& p) {
        return std::pow(std::pow(std::abs(p.x), 4) + std::pow(std::abs(p.y), 4), 2) +
               std::pow(std::abs(p.z), 8) - 1;
    });
}

TEST(PovSolids, PartsMakeOneFormula) {
    const auto ball = [](const Point& p) { return glm::length(p) - 1.2; };
    const auto cube = [](const Point& p) { return box(p, {-1, -1, -1}, {1, 1, 1}); };
    const std::string parts = "{ sphere { 0, 1.2 } box { -1, 1 } }";
    expect_solid("union " + parts, [&](const Point& p) { return std::min(ball(p), cube(p)); });
    expect_solid("merge " + parts, [&](const Point& p) { return std::min(ball(p), cube(p)); });
    expect_solid("intersection " + parts,
                 [&](const Point& p) { return std::max(ball(p), cube(p)); });
    expect_solid("difference " + parts,
                 [&](const Point& p) { return std::max(ball(p), -cube(p)); });
    expect_solid("intersection { sphere { 0, 1.2 } box { -1, 1 inverse } }",
                 [&](const Point& p) { return std::max(ball(p), -cube(p)); });
    expect_solid("difference { box { -1.8, 1.8 } union { sphere { 0, 1.2 } plane { y, -0.5 } } "
                 "translate 0.1*x }",
                 [&](const Point& at) {
                     const Point p = at - Point(0.1, 0, 0);
                     return std::max(box(p, Point(-1.8), Point(1.8)),
                                     -std::min(ball(p), p.y + 0.5));
                 });
}

// Any affine map; those that surface.transform can say are its.
TEST(PovSolids, TransformationsApplyInTurn) {
    const auto ellipsoid = [](const Point& p) { return glm::length(p / Point(1, 2, 0.5)) - 1; };
    expect_solid("sphere { 0, 1 scale <1, 2, 0.5> }", ellipsoid);
    const double c = std::cos(M_PI / 6), s = std::sin(M_PI / 6);
    const auto turned = [&](const Point& at) {
        const Point p = at - Point(0.5, 0, 0);
        return ellipsoid({c * p.x + s * p.y, -s * p.x + c * p.y, p.z});
    };
    expect_solid("sphere { 0, 1 scale <1, 2, 0.5> rotate 30*z translate 0.5*x }", turned);
    expect_solid("#declare Turn = transform { rotate 30*z translate 0.5*x };\n"
                 "object { sphere { 0, 1 } scale <1, 2, 0.5> transform { Turn } }",
                 turned);
    expect_solid("#declare R = 30;\n#declare Ball = sphere { 0, 1 scale <1, 2, 0.5> };\n"
                 "object { Ball rotate R*z translate <0.5, 0, 0> }",
                 turned);
    // x to (1, 0.5, 0), y to (0, 1, 0), z to (0, 0, 2), then by (0, 0.25, 0).
    expect_solid("sphere { 0, 1 matrix <1, 0.5, 0, 0, 1, 0, 0, 0, 2, 0, 0.25, 0> }",
                 [](const Point& p) {
                     return glm::length(Point(p.x, p.y - 0.25 - 0.5 * p.x, p.z / 2)) - 1;
                 });
    expect_solid("box { 0, <1, 2, 1> scale <-1, 1, 1> rotate <0, 90, 0> }", [](const Point& p) {
        return box(p, {0, 0, 0}, {1, 2, 1});
    });
}

TEST(PovSolids, LongFormulasAreNamedWhereTheyMove) {
    std::string sum = "x*x";
    for (int k = 1; k < 60; ++k) sum += " + y*y/60 + z*z/60";
    expect_solid("union { isosurface { function { " + sum +
                     " - 1 } contained_by { box { -1.5, 1.5 } } rotate 20*x scale <1, 1, 1.5> } "
                     "inverse inverse }",
                 [](const Point& at) {
                     const double a = M_PI / 9;
                     const Point q(at.x, at.y, at.z / 1.5);
                     const Point p(q.x, std::cos(a) * q.y + std::sin(a) * q.z,
                                   std::cos(a) * q.z - std::sin(a) * q.y);
                     return p.x * p.x + 59.0 / 60 * (p.y * p.y + p.z * p.z) - 1;
                 });
}

// A clip leaves holes: beyond it there is nothing, and no wall.
TEST(PovSolids, ClipsCutOpen) {
    const std::string clipped = "sphere { 0, 1 scale <1, 2, 1> clipped_by { plane { y, 0.5 } } }";
    EXPECT_EQ(value_at(clipped, {0, 0.6, 0}), 1);
    EXPECT_NEAR(value_at(clipped, {0.5, 0.4, 0}), 0.25 + 0.04 - 1, 1e-12);
    // What moves after it moves with the clip, what moved before does not.
    const std::string moved = "sphere { 0, 1 translate 0.5*x clipped_by { plane { x, 0.2 } } "
                              "translate 1*y }";
    EXPECT_EQ(value_at(moved, {0.3, 1, 0}), 1);
    EXPECT_NEAR(value_at(moved, {0.1, 1, 0}), 0.16 - 1, 1e-12);
    const std::string clear = "intersection { sphere { 0, 1 pigment { rgb 1 } } "
                              "box { -0.5, 0.5 pigment { rgbt <1, 1, 1, 1> } } }";
    EXPECT_EQ(value_at(clear, {0.6, 0, 0}), 1);
    EXPECT_NEAR(value_at(clear, {0.4, 0, 0}), 0.16 - 1, 1e-12);
    expect_solid("intersection { isosurface { function { x*x + y*y - 0.5 } } box { -2, 2 } }",
                 [](const Point& p) {
                     return std::max(p.x * p.x + p.y * p.y - 0.5, box(p, Point(-1), Point(1)));
                 });
}

TEST(PovSolids, LooksThatDifferMakeSurfaces) {
    const Scene scene = scene_of("union { sphere { 0, 1 pigment { rgb <1, 0, 0> } }\n"
                                 "sphere { 2*x, 1 } sphere { -2*x, 1 }\n"
                                 "pigment { rgb <0, 0, 1> } scale 2 }\nbox { 3, 4 }");
    EXPECT_EQ(scene.surfaces.size(), 4);
    std::string many = "#declare Piece = sphere { 0, 0.1 }\nunion { plane { y, -1 }\n";
    for (int k = 0; k < 20; ++k) many += fmt::format("object {{ Piece translate {}*x }}\n", k);
    EXPECT_EQ(scene_of(many + "}").surfaces.size(), 2);
    // Open ones show within one another, also as one: the formula is 0 where one of them is.
    std::string open;
    for (int k = 0; k < 12; ++k) open += fmt::format("quadric {{ <1, 1, 1>, 0, 0, -{} }}\n", k + 1);
    EXPECT_EQ(scene_of(open).surfaces.size(), 1);
    EXPECT_NEAR(value_at(open, {0, 2, 0}), 0, 1e-12);
    EXPECT_NE(value_at(open, {0, 2.1, 0}), 0);
    std::string colours;
    for (int k = 0; k < 9; ++k)
        colours += fmt::format("sphere {{ {0}*x, 1 pigment {{ rgb 0.{0} }} }}\n", k);
    EXPECT_THAT(mistake_of(colours), HasSubstr("solids.pov:9: sphere: is one of 9 objects that"));
}

// The parts of a union keep their colours where the union is cut, by a box or by another object,
// and are cut where the union lies.
TEST(PovSolids, CutUnionsKeepTheColoursOfTheirParts) {
    const std::string balls = "union { sphere { 0, 1 pigment { rgb <1, 0, 0> } }\n"
                              "sphere { 2*x, 1 pigment { rgb <0, 1, 0> } }\n";
    for (const char* cut : {"clipped_by { box { <-3, -3, -3>, <3, 0, 3> } } translate 0.25*y",
                            "clipped_by { plane { y, 0 } } translate 0.25*y",
                            "translate 0.25*y clipped_by { plane { y, 0.25 } }",
                            "clipped_by { plane { y, 1 } } translate 0.25*y "
                            "clipped_by { plane { y, 0.25 } } clipped_by { sphere { 0, 9 } }"}) {
        SCOPED_TRACE(cut);
        const Scene scene = scene_of(balls + cut + " }");
        ASSERT_EQ(scene.surfaces.size(), 2);
        const SceneAt now = at_frame(scene, 1);
        for (std::size_t k = 0; k < 2; ++k) {
            const SurfaceAt& surface = now.surfaces[k];
            EXPECT_EQ(surface.color, glm::dvec3(k == 0, k == 1, 0));
            for (const Point& p : points()) {
                const double ball = glm::distance(p, Point(2.0 * double(k), 0.25, 0)) - 1;
                if (std::abs(ball) < 1e-9 || std::abs(p.y - 0.25) < 1e-9) continue;
                EXPECT_EQ(value_of(scene.surfaces[k], surface, p) < 0, ball < 0 && p.y < 0.25);
            }
        }
    }
}

TEST(PovSolids, KnownObjectsAndMistakesOfDeclarations) {
    EXPECT_NEAR(value_at("#include \"shapesq.inc\"\nobject { Piriform scale 2 }", {1, 0.5, 0.25}),
                4 * std::pow(0.5, 4) - 4 * std::pow(0.5, 3) + 0.0625 + 0.015625, 1e-12);
    EXPECT_NEAR(value_at("object { Cylinder_Y }", {1, 7, 2}), 4, 1e-12);
    // What is not used need not be read.
    EXPECT_EQ(scene_of("#declare A = union { lathe { 1 } }\nsphere { 0, 1 }").surfaces.size(), 1);
    EXPECT_THAT(mistake_of("#declare A = union {\nlathe { 1 } }\nobject { A }"),
                HasSubstr("solids.pov:2: union: needs objects before 'lathe'"));
}

TEST(PovSolids, HostileFilesEnd) {
    std::string deep, twice = "#declare A = sphere { 0, 1 }\n", chain = twice;
    for (int k = 0; k < 100'000; ++k) deep += "union { ";
    EXPECT_THAT(mistake_of(deep), HasSubstr("more than 60 objects in one another"));
    for (int k = 0; k < 50; ++k)
        twice += "#declare A = intersection { object { A } object { A } }\n";
    EXPECT_THAT(mistake_of(twice + "object { A }"), HasSubstr("more than 20000 objects"));
    for (int k = 0; k < 1000; ++k) chain += "#declare A = union { object { A } }\n";
    EXPECT_THAT(mistake_of(chain + "object { A }"), HasSubstr("more than 60 objects"));
    std::string turns = "sphere { 0, 1 ";
    for (int k = 0; k < 5000; ++k) turns += "rotate clock ";
    EXPECT_THAT(mistake_of(turns + "}"), testing::StartsWith("solids.pov:1: "));
}

} // namespace
} // namespace isomotion::scene::pov_solids_test
