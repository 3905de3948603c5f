// [material.colormap]: what it means, and what is said about mistakes in it.
#include "testing.h"

namespace isomotion::scene {
namespace {

class PaintOfScene : public Scenes {
protected:
    // The paint's lines begin with line 16.
    void expect(const std::string& lines, const std::string& message) const {
        EXPECT_EQ(mistake(ball_and("[material.colormap]\n" + lines)), "scene.toml:" + message);
    }
};

TEST_F(PaintOfScene, IsAnExpressionARangeAndAMap) {
    EXPECT_FALSE(loaded(ball()).surfaces[0].material.paint);
    const Scene plain = loaded(ball_and("[material.colormap]\nvalue = 'nz'\nrange = [-1, 1]"));
    ASSERT_TRUE(plain.surfaces[0].material.paint);
    EXPECT_EQ(plain.surfaces[0].material.paint->map, ColorMap::blue_yellow);
    EXPECT_TRUE(plain.surfaces[0].material.paint->value->uses("nz"));
    const Scene moving = loaded(ball_and("[material]\ncolor = [1, 0, 0]\n[material.colormap]\n"
                                         "value = 'mean_curvature*radius'\n"
                                         "range = ['-t', { keys = [[0, 2.0], [1, 4.0]] }]\n"
                                         "map = 'blue-orange'"));
    EXPECT_EQ(moving.surfaces[0].material.paint->map, ColorMap::blue_orange);
    EXPECT_EQ(at_time(moving, 0.5).surfaces[0].paint_range, glm::dvec2(-0.5, 3));
}

TEST_F(PaintOfScene, IsSetOnTheCommandLine) {
    const Scene scene =
        loaded(ball(), {"material.colormap.value=nz + x", "material.colormap.range=[1, -1]"});
    ASSERT_TRUE(scene.surfaces[0].material.paint);
    EXPECT_EQ(at_time(scene, 0).surfaces[0].paint_range, glm::dvec2(1, -1))
        << "a map may run backwards";
}

TEST_F(PaintOfScene, AParameterMayServeThePaintAlone) {
    const std::string wave =
        "wave = 3\n[material.colormap]\nvalue = 'sin(wave*x)'\nrange = [-1, 1]";
    EXPECT_TRUE(loaded(ball_with(9, "radius = 1\n" + wave)).surfaces[0].material.paint);
    EXPECT_EQ(mistake(ball_with(9, "radius = 1\nwave = 3")),
              "scene.toml:10: parameters.wave: neither the formula nor an expression uses this "
              "parameter");
}

TEST_F(PaintOfScene, Mistakes) {
    expect("range = [0, 1]",
           "15: material.colormap.value: is missing; give an expression of x, y, z, nx, ny, nz, "
           "mean_curvature, gaussian_curvature, evaluations, t and the surface's parameters");
    expect("value = 3\nrange = [0, 1]", "16: material.colormap.value: must be a text in quotes");
    expect("value = 'nz + raduis'\nrange = [0, 1]",
           "16: material.colormap.value: unknown name 'raduis'; did you mean 'radius'?\n"
           "    nz + raduis\n"
           "         ^");
    expect("value = 'nz'",
           "15: material.colormap.range: is missing; give [low, high], the values at "
           "the ends of the map, or \"auto\"");
    expect("value = 'nz'\nrange = 3", "17: material.colormap.range: must be [low, high], the "
                                      "values at the ends of the map, or \"auto\"");
    expect("value = 'nz'\nrange = [1, 2, 3]", "17: material.colormap.range: must be [low, high], "
                                              "the values at the ends of the map, or \"auto\"");
    expect(
        "value = 'nz'\nrange = [0, true]",
        "17: material.colormap.range.high: must be a number, an expression in t (\"2 + sin(t)\"), "
        "or { keys = [[t, value], ...], ease = \"smooth\" }");
    expect("value = 'nz'\nrange = [0, 1]\nmap = 'blue-yelow'",
           "18: material.colormap.map: there is no map 'blue-yelow'; did you mean 'blue-yellow'? "
           "known: blue-yellow, blue-orange");
    expect("value = 'nz'\nrange = [0, 1]\nmap = 'jet'",
           "18: material.colormap.map: there is no map 'jet'; known: blue-yellow, blue-orange");
    expect("value = 'nz'\nrange = [0, 1]\nvalues = 1",
           "18: material.colormap.values: unknown key; did you mean 'value'?");
    expect("value = 'nz'\nrange = [2, '2 + t']",
           "17: material.colormap.range at t = 0: the two ends must differ, and both are 2");
}

} // namespace
} // namespace isomotion::scene
