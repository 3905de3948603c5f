// material.color: values over time, expressions of the place, the colours of elements; and what is
// said about mistakes in it.
#include "testing.h"

namespace isomotion::scene {
namespace {

class ColorOfScene : public Scenes {
protected:
    // The colour is line 16.
    void expect(const std::string& color, const std::string& message) const {
        EXPECT_EQ(mistake(ball_and("[material]\ncolor = " + color)), "scene.toml:" + message);
    }
    // What colours the surface, in words.
    std::string of(const std::string& text) const {
        const Scene scene = loaded(text);
        return scene.surfaces[0].material.color_by_place
                   ? scene.surfaces[0].material.color_by_place->text
                   : "plain";
    }
};

TEST_F(ColorOfScene, OfTheTimeStaysWithTheProcessor) {
    for (const char* color :
         {"[1, 0.5, 0]", "['t', 'radius', 'random(1, 2)']", "[1, '2*t + pi', 0]",
          "{ keys = [[0, [1, 1, 1]]] }", "[{ keys = [[0, 1]] }, 0, 0]"})
        EXPECT_EQ(of(ball_and(std::string("[material]\ncolor = ") + color)), "plain") << color;
    EXPECT_EQ(of(ball()), "plain");
    EXPECT_EQ(of(ball_with(9, "radius = 1\nnx = 0.5") + "[material]\ncolor = ['nx', 0, 0]\n"),
              "plain")
        << "a parameter goes on being one";
}

TEST_F(ColorOfScene, OfThePlaceIsAnExpression) {
    EXPECT_EQ(of(ball_and("[material]\ncolor = ['abs(nx)', '0.5 + z*t', 'radius*evaluations']")),
              "abs(nx), 0.5 + z*t, radius*evaluations");
    const Scene scene = loaded(ball_and("[material]\ncolor = ['t', { keys = [[0, 3]] }, 'x']"));
    EXPECT_EQ(scene.surfaces[0].material.color_by_place->text, "as it is, as it is, x");
    EXPECT_EQ(at_time(scene, 0.5).surfaces[0].color, glm::dvec3(0.5, 3, 0));
    EXPECT_TRUE(
        loaded(ball(), {"material.color=['x', 'y', 0.5]"}).surfaces[0].material.color_by_place);
}

TEST_F(ColorOfScene, AParameterMayServeItAlone) {
    EXPECT_NE(of(ball_with(9, "radius = 1\nwave = 3\n[material]\ncolor = ['sin(wave*x)', 0, 0]")),
              "plain");
}

TEST_F(ColorOfScene, Mistakes) {
    const std::string names = "x, y, z, nx, ny, nz, mean_curvature, gaussian_curvature, "
                              "evaluations, t";
    expect("['x', 0]", "16: material.color: must have three components: [x, y, z]");
    expect("['x', 0, 0, 1]", "16: material.color: must have three components: [x, y, z]");
    expect("'x'", "16: material.color: must be [r, g, b], linear ([1, 0, 0] is red), or { keys = "
                  "[[t, [r, g, b]], ...] }");
    expect("[0, 'q', 0]", "16: material.color.y: unknown name 'q'; known: " + names +
                              ", radius, pi\n    q\n    ^");
    expect("[0, 0, 'nx + raduis']",
           "16: material.color.z: unknown name 'raduis'; did you mean 'radius'?\n"
           "    nx + raduis\n"
           "         ^");
    expect("['x + random(1, 2)', 0, 0]",
           "16: material.color.x: random is for animation: give a parameter or an array field its "
           "value with random(i, k), not the formula\n"
           "    x + random(1, 2)\n"
           "        ^");
    expect("['random(1, q)', 0, 0]", "16: material.color.x: unknown name 'q'; known: " + names +
                                         ", radius, pi\n    random(1, q)\n              ^");
    expect("['x', 'x/0', 0]", "16: material.color.y: division by zero\n    x/0\n     ^");
    expect("['sum(blobs, 1)', 0, 0]",
           "16: material.color.x: sum needs an array, and the scene has none: add [arrays.name]\n"
           "    sum(blobs, 1)\n"
           "        ^");
}

const std::string two = "count = 2\ncx = [-1, 1]\nw = [1, 2]\n";

TEST_F(ColorOfScene, TooMuchWorkIsAMistakeOfIts) {
    const std::string blobs = "[arrays.b]\ncount = 100000\ncx = 'sin(i)'\n";
    std::string terms = "0";
    for (int k = 0; k < 600; ++k) terms += "+sin(" + std::to_string(k) + "*x-cx)";
    for (const std::string& text :
         {"[material]\ncolor = ['sum(b, " + terms + ")', 0, 0]\n" + blobs,
          "[material.colormap]\nvalue = 'sum(b, " + terms + ")'\nrange = [0, 1]\n" + blobs}) {
        EXPECT_THAT(mistake(ball_and(text)),
                    testing::HasSubstr("operations at one point, all elements of its sums counted"))
            << text.substr(0, 60);
    }
}

TEST_F(ColorOfScene, NamesAnyFieldOfAnArray) {
    const std::string tint = blobs(two + "tint = [0, 1]\n[material]\n"
                                         "color = ['sum(blobs, tint*w)', 0, 0]");
    EXPECT_EQ(of(tint), "sum(blobs, tint*w), as it is, as it is");
    const Scene scene = loaded(tint);
    EXPECT_EQ(scene.surfaces[0].field->packing, (formula::ArrayPacking{{0, 2, 1}}))
        << "cx and w as without it, then tint";
    EXPECT_EQ(at_time(scene, 0).surfaces[0].bindings.arrays[0].fields[1],
              (std::vector<float>{0, 1}));
    EXPECT_EQ(
        mistake(blobs(two + "tint = [0, 1]\n[material]\ncolor = ['sum(blobs, tnit*w)', 0, 0]")),
        "scene.toml:10: material.color.x: unknown name 'tnit'; did you mean 'tint'?\n"
        "    sum(blobs, tnit*w)\n"
        "               ^");
    EXPECT_EQ(mistake(blobs(two + "tint = [0, 1]\n[material]\ncolor = ['tint', 0, 0]")),
              "scene.toml:10: material.color.x: 'tint' is a field of the array 'blobs' and has a "
              "value only inside sum(blobs, ...)\n"
              "    tint\n"
              "    ^");
    EXPECT_THAT(mistake(blobs(two + "tint = [0, 1]")), testing::HasSubstr("uses this field"));
}

TEST_F(ColorOfScene, IsThatOfElementsWhichHaveOne) {
    const std::string mean = "the elements' mean of blobs.r blobs.g blobs.b";
    const std::string rgb = "r = [1, 0]\ng = 0.5\nb = 'i'\n";
    EXPECT_EQ(of(blobs(two + rgb)), mean);
    EXPECT_EQ(of(blobs(two + "red = [255, 0]\ngreen = [0, 0]\nblue = [0, 255]")),
              "the elements' mean of blobs.red blobs.green blobs.blue");
    EXPECT_EQ(of(blobs(two + rgb + "[material]\nmodel = 'ggx'")), mean);
    EXPECT_EQ(of(blobs(two + rgb + "[material]\nback_color = [1, 1, 1]")), mean);
    // Unless something else is asked for.
    EXPECT_NE(of(blobs(two + rgb + "[material]\ncolor = ['sum(blobs, r*g*b)', 0, 0]")), mean);
}

TEST_F(ColorOfScene, OfElementsNeedsAllThreeAndNobodyElseReadingThem) {
    EXPECT_THAT(mistake(blobs(two + "r = [1, 0]\ng = [1, 0]")), testing::HasSubstr("uses this"));
    const std::string rgb = "r = [1, 0]\ng = [1, 0]\nb = [1, 0]\n";
    EXPECT_THAT(mistake(blobs(two + rgb + "[material]\ncolor = [1, 0, 0]")),
                testing::HasSubstr("uses this"));
    EXPECT_THAT(mistake(blobs(two + rgb + "[material.colormap]\nvalue = 'x'\nrange = [0, 1]")),
                testing::HasSubstr("uses this"));
    // A radius called r.
    EXPECT_THAT(mistake(blobs("count = 2\ncx = [-1, 1]\nw = 'r'\n" + rgb)),
                testing::HasSubstr("uses this"));
}

TEST_F(ColorOfScene, ColumnsOfFilesAreNoMistakeWhoeverReadsThem) {
    write("p.csv", "cx,r,g,b,unread\n-1,1,0,0,9\n1,0,0,1,9\n");
    const std::string array = "file = 'p.csv'\nw = 1\n";
    EXPECT_EQ(of(blobs(array)), "the elements' mean of blobs.r blobs.g blobs.b");
    EXPECT_EQ(of(blobs(array + "[material]\ncolor = [1, 0, 0]")), "plain");
    EXPECT_EQ(of(blobs(array + "R = 'r'\n[material.colormap]\nvalue = 'sum(blobs, R)'\n"
                               "range = 'auto'")),
              "plain");
    // A formula without a sum over the array leaves its colours alone.
    EXPECT_EQ(of("[surface]\nformula = 'x^2 + y^2 + z^2 - 1'\nbounds = { sphere = 2 }\n"
                 "[arrays.blobs]\nfile = 'p.csv'\n"),
              "plain");
    // The catalogue's colour is no choice of the scene's.
    surface("blobs", "formula = 'sum(blobs, exp(-(x-cx)^2 - y^2 - z^2)) - 0.5'\n"
                     "bounds = { sphere = 3 }\n[arrays.blobs]\ncount = 1\ncx = 0\n"
                     "[material]\ncolor = [0, 1, 0]\n");
    EXPECT_EQ(of("[surface]\nuse = 'blobs'\n"), "plain");
    EXPECT_EQ(of("[surface]\nuse = 'blobs'\n[arrays.blobs]\nfile = 'p.csv'\n"),
              "the elements' mean of blobs.r blobs.g blobs.b");
}

} // namespace
} // namespace isomotion::scene
