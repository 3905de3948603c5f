// What POV-Ray files say in their own words: colours, functions, blobs, files that they include.
#include "testing.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <unistd.h>

#include <fmt/format.h>

#include "formula/field.h"
#include "formula/graph/noise.h"
#include "scene/scene_at.h"

namespace isomotion::scene::pov_words_test {
namespace {

using testing::HasSubstr;

Scene scene_of(const std::string& text) { return load_text(text, "words.pov"); }

std::string mistake_of(const std::string& text) { return mistake_of_text(text, "words.pov"); }

// The first surface's formula at a point in POV-Ray's axes.
double value_at(const std::string& text, const glm::dvec3& p) {
    const Scene scene = scene_of(text);
    const SceneAt now = at_frame(scene, 1);
    formula::Evaluator<double> evaluator(scene.surfaces[0].field->value);
    double value = 0;
    evaluator.point(formula::convert<double>(now.surfaces[0].bindings), std::array{p.x, p.z, p.y},
                    {&value, 1});
    return value;
}

double function_at(const std::string& function, const glm::dvec3& p) {
    return value_at("isosurface { function { " + function + " } contained_by { box { -9, 9 } } }",
                    p);
}

glm::dvec3 color_of(const std::string& pigment) {
    const Scene scene = scene_of("sphere { 0, 1 pigment { " + pigment + " } }");
    const auto values = scene.surfaces[0].animation.at(scene.timeline.time(1));
    const auto& color = scene.surfaces[0].material.color;
    return {values.tracks[std::size_t(color[0])], values.tracks[std::size_t(color[1])],
            values.tracks[std::size_t(color[2])]};
}

TEST(PovWords, Colours) {
    EXPECT_EQ(color_of("color red 1 green 0.5 blue 0.2"), glm::dvec3(1, 0.5, 0.2));
    EXPECT_EQ(color_of("colour green 1 blue 1 filter 0.3"), glm::dvec3(0, 1, 1));
    EXPECT_EQ(color_of("rgb 0.25"), glm::dvec3(0.25));
    EXPECT_EQ(color_of("color rgbf <1, 0.5, 0.25, 0.75>"), glm::dvec3(1, 0.5, 0.25));
    EXPECT_EQ(color_of("color rgb <1 0.5 0.5>*0.5"), glm::dvec3(0.5, 0.25, 0.25));
    EXPECT_EQ(color_of("SteelBlue"), glm::dvec3(0.137255, 0.419608, 0.556863));
    EXPECT_EQ(color_of("color Gray35"), glm::dvec3(0.35));
    EXPECT_EQ(color_of("DimGrey"), glm::dvec3(0.329412));
    EXPECT_THAT(mistake_of("sphere { 0, 1 pigment { Clear } }"),
                HasSubstr("pigment: lets all light pass everywhere"));
    EXPECT_THAT(mistake_of("sphere { 0, 1 pigment { color Gray57 } }"),
                HasSubstr("'Gray57' is not declared before"));
}

TEST(PovWords, Functions) {
    const glm::dvec3 p(0.3, -0.7, 1.1);
    const double r = glm::length(p);
    EXPECT_NEAR(function_at("f_r(x, y, z) - 1", p), r - 1, 1e-12);
    EXPECT_NEAR(function_at("f_th(x, y, z)", p), std::atan2(0.3, 1.1), 1e-12);
    EXPECT_NEAR(function_at("f_ph(x, y, z)", p), std::atan2(std::hypot(0.3, 1.1), -0.7), 1e-12);
    EXPECT_NEAR(function_at("f_ellipsoid(x, y, z, 2, 3, 4) - 1", p),
                std::sqrt(0.36 + 4.41 + 19.36) - 1, 1e-12);
    EXPECT_NEAR(function_at("f_torus(x, y, z, 1, 0.2)", p),
                std::hypot(std::hypot(0.3, 1.1) - 1, -0.7) - 0.2, 1e-12);
    EXPECT_NEAR(function_at("f_rounded_box(x, y, z, 0.2, 0.5, 0.6, 0.7)", p),
                std::hypot(0.3, 0.6) - 0.2 - 1e-6, 1e-12);
    EXPECT_NEAR(
        function_at("f_superellipsoid(x, y, z, 0.5, 0.25)", p),
        1 - std::pow(std::pow(std::pow(0.3, 4) + std::pow(0.7, 4), 2) + std::pow(1.1, 8), 0.125),
        1e-12);
    EXPECT_NEAR(function_at("f_paraboloid(x, y, z, -1)", p), 0.09 + 0.7 + 1.21, 1e-12);
    // Strengths beyond 10 are cut off, as POV-Ray does.
    EXPECT_EQ(function_at("f_pillow(x*9, y*9, z*9, 5)", p), 10);
    EXPECT_EQ(function_at("select(x, 1, 2) + y*0", p), 2);
    EXPECT_EQ(function_at("select(y, 1, 2, 3) + x*0", p), 1);
    EXPECT_EQ(function_at("select(x - 0.3, 1, 2, 3)", p), 2);
    EXPECT_NEAR(function_at("mod(y, 0.5)", p), -0.2, 1e-12);
    EXPECT_EQ(function_at("int(y*3)", p), -2);
    EXPECT_EQ(function_at("div(z*10, 4)", p), 2);
    EXPECT_NEAR(function_at("pow(x - 1, 2)", p), 0.49, 1e-12);
    EXPECT_NEAR(function_at("f_noise3d(x*3, y, z)", p),
                0.5 + 0.5 * formula::noise(3 * p.x, p.y, p.z, {}), 1e-12);
    EXPECT_NEAR(function_at("f_noise3d(0.2, 0.3, 0.4) + y", p),
                0.5 + 0.5 * formula::noise(0.2, 0.3, 0.4, {}) + p.y, 1e-12);
    EXPECT_THAT(mistake_of("isosurface { function { x - f_ridge(x, y, z, 1, 2, 3, 4, 5, 6) } }"),
                HasSubstr("words.pov:1: function: the function f_ridge is not read: there is no "));
    EXPECT_THAT(mistake_of("isosurface { function { f_torus(x, y, z, 1) } }"),
                HasSubstr("f_torus takes 5 numbers, not 4"));
    EXPECT_THAT(mistake_of("isosurface { function { select(x, 1) } }"),
                HasSubstr("select takes 3 or 4 numbers, not 2"));
    // Names that these formulas call are no parameters.
    EXPECT_NEAR(value_at("#declare trunc = 3;\nisosurface { function { int(trunc*x) + y } }", p),
                -0.7, 1e-12);
}

TEST(PovWords, BlobsSumUpTheirComponents) {
    const std::string blob = "blob { threshold 0.5 sphere { <-0.5, 0, 0>, 1, 2 } "
                             "sphere { <0, 0, 0>, 0.5, strength -1 scale <1, 2, 1> translate x } "
                             "cylinder { <0, -1, 0>, <0, 1, 0>, 0.8, 1.5 } }";
    const auto near = [](double squares, double radius) {
        const double part = std::max(1 - squares / (radius * radius), 0.0);
        return part * part;
    };
    for (const glm::dvec3 p : {glm::dvec3(0.1, 0.2, 0.3), glm::dvec3(0.9, 0.2, -0.1),
                               glm::dvec3(0.2, 1.5, 0.1), glm::dvec3(0, 3, 0)}) {
        const glm::dvec3 own((p.x - 1), p.y / 2, p.z);
        const double up = std::max(std::abs(p.y) - 1, 0.0);
        const double expected =
            0.5 - 2 * near((p.x + 0.5) * (p.x + 0.5) + p.y * p.y + p.z * p.z, 1) +
            near(glm::dot(own, own), 0.5) - 1.5 * near(p.x * p.x + p.z * p.z + up * up, 0.8);
        EXPECT_NEAR(value_at(blob, p), expected, 1e-12);
    }
    EXPECT_THAT(mistake_of("blob { threshold 1 }"), HasSubstr("blob: needs a component"));
    EXPECT_THAT(mistake_of("blob { sphere { 0, 1, 1 pigment { Red } } }"),
                HasSubstr("blob: is read with one look"));
}

TEST(PovWords, FilesOfItsFolderAreIncluded) {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / fmt::format("pov_includes_{}", ::getpid());
    std::filesystem::create_directory(folder);
    std::ofstream(folder / "size.inc")
        << "#declare Size = 2;\n\n#declare Ball = sphere { 0, Size }";
    std::ofstream(folder / "loop.inc") << "#include \"loop.inc\"";
    const auto path = folder / "scene.pov";
    EXPECT_EQ(load_text("#include \"size.inc\"\nobject { Ball }", path).surfaces.size(), 1);
    EXPECT_THAT(mistake_of_text("\n#include \"loop.inc\"", path.string()),
                HasSubstr("scene.pov:2: #include: more than 8 files include one another"));
    EXPECT_THAT(mistake_of_text("#include \"../size.inc\"", (folder / "in" / "scene.pov").string()),
                HasSubstr("scene.pov:1: #include: \"../size.inc\" is not read"));
    std::filesystem::remove_all(folder);
}

} // namespace
} // namespace isomotion::scene::pov_words_test
