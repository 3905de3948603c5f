// Painted surfaces, pixel by pixel: what the GPU computes against double on the CPU.
#include "render/material_colors.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "formula/curvature.h"
#include "formula/hessian.h"
#include "shader/assemble.h"

namespace isomotion::render {
namespace {

class PaintedPictures : public Drawing {};
ISOMOTION_ON_EVERY_BACKEND(PaintedPictures);

std::string paint(const std::string& value, const std::string& range,
                  const std::string& map = "blue-yellow") {
    return fmt::format("[material.colormap]\nvalue = '{}'\nrange = {}\nmap = '{}'\n", value, range,
                       map);
}

// The sequential map, as its file describes it.
glm::dvec3 blue_yellow(double u) {
    const glm::dvec3 lab = glm::mix(glm::dvec3(0.32, -0.012, -0.13), glm::dvec3(0.93, -0.055, 0.15),
                                    glm::clamp(u, 0.0, 1.0));
    const double l = std::pow(lab.x + 0.3963377774 * lab.y + 0.2158037573 * lab.z, 3);
    const double m = std::pow(lab.x - 0.1055613458 * lab.y - 0.0638541728 * lab.z, 3);
    const double s = std::pow(lab.x - 0.0894841775 * lab.y - 1.2914855480 * lab.z, 3);
    return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

// `u` of a pixel is where its value stands in the range.
template<class Position>
void expect_painted(const Picture& picture, Position&& u, double tolerance, std::size_t most_off) {
    const std::vector<Pixel> hits = hits_of(picture);
    EXPECT_GT(hits.size(), 500u);
    std::size_t off = 0;
    for (const Pixel& hit : hits) {
        const glm::dvec3 difference = glm::abs(hit.color - blue_yellow(u(hit)));
        const double worst = std::max({difference.r, difference.g, difference.b});
        if (!(worst <= tolerance)) ++off;
    }
    EXPECT_LE(off, most_off) << "of " << hits.size();
}

TEST_P(PaintedPictures, TheNormalOfASphereIsItsPosition) {
    const Picture picture = draw(*context, scene_of(sphere_scene + dark + paint("nz", "[-1, 1]")));
    expect_painted(
        picture, [](const Pixel& p) { return (p.position.z + 1) / 2; }, 4e-3, 0);
    expect_painted(
        picture, [](const Pixel& p) { return (p.normal.z + 1) / 2; }, 1e-5, 0);
}

// Towards F > 0, that is into the ball, whose inside the picture shows turned to the viewer.
TEST_P(PaintedPictures, TheNormalPointsToWhereTheFieldRises) {
    scene::Scene scene = scene_of(sphere_scene + dark + paint("nz", "[-1, 1]"),
                                  {"surface.formula=1 - x^2 - y^2 - z^2"});
    expect_painted(
        draw(*context, scene), [](const Pixel& p) { return (1 - p.normal.z) / 2; }, 1e-5, 0);
}

TEST_P(PaintedPictures, PlacedSurfacesHaveNormalsOfTheWorldAndPositionsOfTheFormula) {
    const std::string placed = R"(
[surface]
formula = "x^2 + y^2 + z^2 - 1"
bounds = { sphere = 1.5 }
transform = { rotate = [0, 90, 0], scale = 2 }
[output]
size = [96, 96]
)";
    // Turned about y by 90 degrees, the formula's x is the world's -z.
    const auto picture = [&](const char* value) {
        return draw(*context, scene_of(placed + dark + paint(value, "[-1, 1]")));
    };
    expect_painted(
        picture("nz"), [](const Pixel& p) { return (p.normal.z + 1) / 2; }, 1e-5, 0);
    expect_painted(
        picture("x"), [](const Pixel& p) { return (1 - p.position.z / 2) / 2; }, 1e-5, 0);
}

TEST_P(PaintedPictures, TimeParametersAndTheRangeMove) {
    const std::string scene = R"(
[time]
fps = 10
frames = 20
[surface]
formula = "x^2 + y^2 + z^2 - a"
bounds = { sphere = 1.5 }
[parameters]
a = "1 + t"
[output]
size = [64, 64]
)" + dark + paint("z*a - t", "['-t', 3]");
    const Picture picture = draw(*context, scene_of(scene), 6); // t = 0.5
    expect_painted(
        picture, [](const Pixel& p) { return (p.position.z * 1.5 - 0.5 + 0.5) / 3.5; }, 1e-5, 0);
}

TEST_P(PaintedPictures, EvaluationsAreThoseOfTheChannel) {
    const Picture picture =
        draw(*context, scene_of(sphere_scene + dark + paint("evaluations", "[0, 300]")));
    expect_painted(
        picture, [](const Pixel& p) { return p.evaluations / 300; }, 1e-5, 0);
}

TEST_P(PaintedPictures, BeyondTheRangeTheMapStandsStillAndWhatIsNoNumberIsGrey) {
    const auto colors = [&](const char* value) {
        return hits_of(draw(*context, scene_of(sphere_scene + dark + paint(value, "[0, 1]"))));
    };
    for (const Pixel& p : colors("7 + x")) {
        ASSERT_LT(glm::distance(p.color, blue_yellow(1)), 1e-5);
    }
    for (const Pixel& p : colors("x - 70")) {
        ASSERT_LT(glm::distance(p.color, blue_yellow(0)), 1e-5);
    }
    for (const Pixel& p : colors("floor(abs(y)/9)/floor(abs(z)/9)")) {
        ASSERT_LT(glm::distance(p.color, glm::dvec3(0.05)), 1e-6);
    }
}

// Whatever the method of assembly: the gradient from the field or, for long formulas, from the
// march.
TEST_P(PaintedPictures, CurvaturesAreThoseInDouble) {
    struct Subject {
        std::string name, scene;
        double mean, gaussian; // ends of the range
    };
    std::string waves = "s = x^2 + y^2 + z^2 - 1; "; // no sum of many, which would be an array's
    for (int k = 1; k <= 100; ++k)
        waves += fmt::format("s = 1.001*(s + 1e-5*sin({}*x/50 + y)*z); ", k);
    waves += "s";
    const auto of_formula = [](const std::string& formula) {
        return fmt::format("[surface]\nformula = '''{}'''\nbounds = {{ sphere = 2 }}\n", formula);
    };
    const auto of_catalogue = [](const char* name) {
        return fmt::format("[surface]\nuse = '{}'\n", name);
    };
    for (const Subject& subject :
         {Subject{"cylinder", of_formula("x^2 + y^2 - 1"), 1, 1},
          Subject{"saddle", of_formula("z - x*y"), 1, 2},
          Subject{"tiny values", of_formula("1e-12*(x^2 + 2*y^2 + z^2 - 1)"), 2, 4},
          Subject{"long", of_formula(waves), 2, 2}, Subject{"torus", of_catalogue("torus"), 4, 8},
          Subject{"blobby", of_catalogue("blobby"), 8, 40},
          Subject{"tangle", of_catalogue("tangle"), 2, 4},
          Subject{"chmutov_6", of_catalogue("chmutov_6"), 20, 200}}) {
        for (const bool mean : {true, false}) {
            SCOPED_TRACE(subject.name + (mean ? ", mean" : ", gaussian"));
            const double end = mean ? subject.mean : subject.gaussian;
            const scene::Scene scene =
                scene_of(subject.scene + "[output]\nsize = [80, 80]\n" + dark +
                         paint(mean ? "mean_curvature" : "gaussian_curvature",
                               fmt::format("[{}, {}]", -end, end)));
            ASSERT_EQ(shader::assemble(scene).march_takes_gradient, subject.name == "long");
            const formula::Field& field = *scene.surfaces[0].field;
            const formula::Program second = formula::hessian(field);
            formula::Evaluator<double> evaluate_second(second);
            formula::FieldEvaluator<double> evaluate(field);
            const auto bindings =
                formula::convert<double>(scene::at_frame(scene, 1).surfaces[0].bindings);
            const auto u = [&](const Pixel& pixel) {
                const std::array<double, 3> p{pixel.position.x, pixel.position.y, pixel.position.z};
                std::array<double, 6> hessian{};
                evaluate_second.point(bindings, p, hessian);
                const auto c = formula::curvatures(evaluate.gradient(bindings, p), hessian);
                return ((mean ? c.mean : c.gaussian) / end + 1) / 2;
            };
            expect_painted(draw(*context, scene), u, 5e-3, 5);
        }
    }
}

} // namespace
} // namespace isomotion::render
