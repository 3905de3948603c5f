// What range of a number a surface shows, against what is known of simple surfaces.
#include "unit/scene/testing.h"

#include <fmt/format.h>

namespace isomotion::probe {
namespace {

using namespace scene;

class ShownRange : public Scenes {
protected:
    glm::dvec2 range(const std::string& text, const std::string& value,
                     const std::vector<Override>& more = {}) const {
        std::vector<Override> all{"material.colormap.value=" + value,
                                  "material.colormap.range=auto"};
        all.insert(all.end(), more.begin(), more.end());
        const Scene scene = loaded(text, all);
        return at_time(scene, 0.3).surfaces[0].paint_range;
    }
    void expect(const std::string& value, double low, double high, double within,
                const std::vector<Override>& more = {}) const {
        const glm::dvec2 found = range(ball(), value, more);
        EXPECT_NEAR(found.x, low, within) << value;
        EXPECT_NEAR(found.y, high, within) << value;
    }
};

// The ball is seen from (4, 0, 0): what is behind x = 1/4 is hidden.
TEST_F(ShownRange, IsThatOfWhatIsSeen) {
    expect("x", 0.25, 1, 0.1);
    expect("y", -1, 1, 0.1);
    expect("nz", -1, 1, 0.1);
    expect("-nx", -1, -0.25, 0.1);
    expect("x", -1, -0.25, 0.1, {"camera.position=[-4, 0, 0]"});
    expect("sqrt(x^2 + y^2 + z^2)", 1, 1, 0.51);
    expect("mean_curvature*x", 0.25, 1, 0.1);
    expect("gaussian_curvature*y", -0.5, 0.5, 0.05,
           {"radius=2", "surface.bounds.sphere=3", "camera.position=[8, 0, 0]"});
}

// The cap of the ball that is seen is at x = 0.5, and what is behind its rim is hidden but for x >
// 1/4.
TEST_F(ShownRange, IsThatOfWhatSectionsLeave) {
    const auto cut = [&](const std::string& value, const std::string& section) {
        return range(ball_and("[[sections]]\n" + section + "\n"), value);
    };
    const glm::dvec2 flat = cut("x", "normal = [1, 0, 0]\noffset = 0.5");
    EXPECT_NEAR(flat.x, 0.25, 0.1);
    EXPECT_NEAR(flat.y, 0.5, 0.01);
    EXPECT_NEAR(cut("mean_curvature", "normal = [1, 0, 0]\noffset = 0.5").x, 0, 0.1);
    EXPECT_NEAR(cut("mean_curvature", "sphere = 0.5\ncentre = [1, 0, 0]").x, -2, 0.3);
    EXPECT_NEAR(cut("x", "sphere = 0.5\ncentre = [1, 0, 0]").y, 0.87, 0.1);
}

// World and formula, as the shader has them.
TEST_F(ShownRange, OfAPlacedSurface) {
    const std::vector<Override> placed{"surface.transform={rotate = [0, 0, 90], scale = 10}",
                                       "camera.position=[40, 0, 0]"};
    expect("y", -1, -0.25, 0.1, placed);
    expect("nx", 0.25, 1, 0.1, placed);
}

TEST_F(ShownRange, CoversTheWholeSequenceWhateverIsAskedFor) {
    // t from 0 to 59/30
    expect("t + 0*x", 0, 59.0 / 30, 1e-6);
    expect("y", -2, 2, 0.2,
           {"radius=1 + t*30/59", "surface.bounds.sphere=3", "camera.position=[16, 0, 0]"});
    expect("t + 0*x", 0, 9.0 / 30, 1e-6, {"time.frames=10"});
    expect("t + 0*x", 0, 1.0 / 30, 1e-6, {"time.frames=2"});
}

TEST_F(ShownRange, IsTheSameEachTime) {
    const glm::dvec2 first = range(ball(), "x + y*mean_curvature");
    EXPECT_EQ(range(ball(), "x + y*mean_curvature"), first);
    EXPECT_EQ(range(ball(), "x + y*mean_curvature", {"output.size=[128, 128]"}), first)
        << "as large a picture as there is asks the same rays";
}

TEST_F(ShownRange, OfOneValueHasItInTheMiddle) {
    EXPECT_EQ(range(ball(), "3 + 0*x"), glm::dvec2(1.5, 4.5));
    EXPECT_EQ(range(ball(), "'0.25'"), glm::dvec2(-0.25, 0.75));
    EXPECT_EQ(range(ball(), "'-2^90'"), glm::dvec2(-0x1.8p90, -0x1p89));
}

TEST_F(ShownRange, WhatIsNoNumberDoesNotCount) {
    expect("y + 1e-9*log(y)", 0, 1, 0.1);
    for (const char* value :
         {"log(-x^2 - 1)", "y + (-1 - x^2)^0.3", "x*1e300"}) { // the GPU's are floats
        EXPECT_THAT(mistake(ball_and(
                        fmt::format("[material.colormap]\nvalue = '{}'\nrange = 'auto'", value))),
                    testing::StartsWith("scene.toml:17: material.colormap.range: the value is no "
                                        "finite number anywhere on the surface"))
            << value;
    }
}

TEST_F(ShownRange, WithoutASurfaceOrAFrameIsSome) {
    EXPECT_EQ(range(ball(), "x", {"surface.formula=x^2 + radius"}), glm::dvec2(0, 1));
    // A frame that can't be drawn says so when it is drawn.
    expect("x", 0.25, 1, 0.1, {"surface.bounds.sphere=1.5 - max(0, t - 1)*9"});
}

// A pole is no surface; the first root counts.
TEST_F(ShownRange, TakesFirstRootsAlone) {
    const glm::dvec2 found = range(ball(), "x", {"surface.formula=1/(x - 0.5) + 0*radius"});
    EXPECT_EQ(found, glm::dvec2(0, 1));
    expect("x", 0.7, 0.7, 0.51, {"surface.formula=(x - 0.7)*(x + 0.7) + 0*radius"});
}

TEST_F(ShownRange, OfManyElementsGoesByTheirPlaces) {
    // A ball of small ones, each with its height; some 3,000, for a fifth of a second.
    const std::string kernel = "max(0, 1 - ((x-cx)^2 + (y-cy)^2 + (z-cz)^2)/0.04)^3";
    const std::string text =
        fmt::format("[surface]\nformula = '0.2 - sum(p, {})'\nbounds = {{ sphere = 1.5 }}\n"
                    "[camera]\nposition = [4, 0, 0]\n[arrays.p]\ncount = 3000\n"
                    "cz = '2*random(i, 0) - 1'\na = '2*pi*random(i, 1)'\n"
                    "cx = 'sqrt(1 - cz^2)*cos(a)'\ncy = 'sqrt(1 - cz^2)*sin(a)'\n"
                    "heat = '5*cz + 1'\n",
                    kernel);
    const glm::dvec2 found = range(text, fmt::format("sum(p, heat*{0})/sum(p, {0})", kernel));
    EXPECT_NEAR(found.x, -4, 0.3);
    EXPECT_NEAR(found.y, 6, 0.3);
    // Weights that are wider than the formula's take all elements.
    const glm::dvec2 wide = range(text, "sum(p, heat)/3000");
    EXPECT_NEAR(wide.x + wide.y, 2, 0.2);
}

TEST_F(ShownRange, Mistakes) {
    const std::string begin = "[material.colormap]\nvalue = ";
    EXPECT_EQ(mistake(ball_and(begin + "'x'\nrange = 'automatic'")),
              "scene.toml:17: material.colormap.range: must be [low, high], the values at the ends "
              "of the map, or \"auto\"");
    // Terms that have no place.
    EXPECT_EQ(mistake("[surface]\nformula = 'sum(p, sin(x*a)*sin(y*a)) - 1'\n"
                      "bounds = { sphere = 1 }\n[arrays.p]\ncount = 100000\na = 'i'\n" +
                      begin + "'x'\nrange = 'auto'"),
              "scene.toml:9: material.colormap.range: what the surface shows takes too long to "
              "find; give [low, high]");
    EXPECT_EQ(
        mistake(ball_and(begin + "'evaluations/2'\nrange = 'auto'")),
        "scene.toml:16: material.colormap.value: how many evaluations there are is known once "
        "a picture is drawn; give the range as [low, high]");
}

} // namespace
} // namespace isomotion::probe
