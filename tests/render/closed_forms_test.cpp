// Pictures whose every pixel is known.
#include "render/drawing.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace isomotion::render {
namespace {

class ClosedForms : public Drawing {};
ISOMOTION_ON_EVERY_BACKEND(ClosedForms);

struct SphereHit {
    bool certain_miss, certain_hit;
    double t;
};

// The ray of a pixel of sphere_scene against the unit sphere, in double. Rays that pass the
// silhouette closer than `margin` are neither hit nor miss.
SphereHit trace(int column, int row, int width, int height, double margin) {
    const double tangent = std::tan(20 * M_PI / 180);
    const double u = (2 * (column + 0.5) / width - 1) * tangent * width / height;
    const double v = (1 - 2 * (row + 0.5) / height) * tangent;
    const double length = std::sqrt(1 + u * u + v * v);
    const double along = 5 / length; // from the eye to the foot of the perpendicular
    const double foot = std::sqrt(std::max(0.0, 25 - along * along));
    return {foot > 1 + margin, foot < 1 - margin,
            along - std::sqrt(std::max(0.0, 1 - foot * foot))};
}

TEST_P(ClosedForms, SphereHasItsSilhouetteDepthNormalsAndPositions) {
    for (const char* method : {"marching", "amp-sign", "amp-taylor"}) {
        SCOPED_TRACE(method);
        const scene::Scene scene =
            scene_of(sphere_scene, {std::string("isolation.method=\"") + method + "\""});
        const Picture picture = draw(*context, scene);
        const image::Frame& f = picture.frame;
        const auto at = [&](const char* name, int k) {
            return double(f.find(name)->samples[std::size_t(k)]);
        };
        // A chord shorter than the step can be stepped over by the sign test: the step bounds how
        // far from the silhouette that happens.
        const double margin = scene.surfaces[0].isolation.step * scene.surfaces[0].isolation.step;
        int hits = 0;
        for (int row = 0; row < f.height; ++row) {
            for (int column = 0; column < f.width; ++column) {
                const int k = row * f.width + column;
                const SphereHit truth = trace(column, row, f.width, f.height, margin);
                const auto verdict = Verdict(int(at("verdict", k)));
                if (truth.certain_miss) {
                    ASSERT_EQ(verdict, Verdict::miss) << column << "," << row;
                }
                if (!truth.certain_hit) continue;
                ASSERT_EQ(verdict, Verdict::hit) << column << "," << row;
                ++hits;
                // Ten bisections of a step leave 2^-11 of it; a grazing ray magnifies that in x.
                const double tolerance = scene.surfaces[0].isolation.step / 1024;
                const double x = 5 - at("Z", k);
                const double px = at("P.X", k), py = at("P.Y", k), pz = at("P.Z", k);
                EXPECT_NEAR(px, x, 1e-5);
                EXPECT_NEAR(std::hypot(px - 5, py, pz), truth.t, tolerance);
                EXPECT_NEAR(std::hypot(at("N.X", k), at("N.Y", k), at("N.Z", k)), 1, 1e-6);
                EXPECT_NEAR(at("N.X", k), px, 2 * tolerance);
                EXPECT_NEAR(at("N.Y", k), py, 2 * tolerance);
                EXPECT_NEAR(at("N.Z", k), pz, 2 * tolerance);
                EXPECT_EQ(at("A", k), 1);
            }
        }
        EXPECT_GT(hits, 3000);
        EXPECT_EQ(picture.verdicts[0] + picture.verdicts[1], f.width * f.height);
    }
}

// Light, camera and colour in one formula: ambient 0.12 plus the cosine.
TEST_P(ClosedForms, DiffuseShadingIsTheCosine) {
    const scene::Scene scene = scene_of(sphere_scene + R"(
[[lights]]
direction = [1, 1, 1]
color = [1, 0.5, 0.25]
[material]
color = [0.5, 0.5, 0.5]
)");
    const Picture picture = draw(*context, scene);
    const auto sample = [&](const char* name, std::size_t k) {
        return double(picture.frame.find(name)->samples[k]);
    };
    int lit = 0;
    for (std::size_t k = 0; k < picture.frame.find("R")->samples.size(); ++k) {
        if (sample("verdict", k) != 1) continue;
        const double cosine = std::max(
            0.0, (sample("N.X", k) + sample("N.Y", k) + sample("N.Z", k)) / std::sqrt(3.0));
        EXPECT_NEAR(sample("R", k), 0.5 * (0.12 + cosine), 1e-5);
        EXPECT_NEAR(sample("B", k), 0.5 * (0.12 + 0.25 * cosine), 1e-5);
        lit += cosine > 0;
    }
    EXPECT_GT(lit, 1000);
}

// A box clips an unbounded plane to its section; the eye inside the bounds sees it too.
TEST_P(ClosedForms, PlaneFillsThePictureFromInsideTheBounds) {
    const Picture picture = draw(*context, scene_of(R"(
[surface]
formula = "z"
bounds = { box = [[-10, -10, -1], [10, 10, 1]] }
[camera]
position = [0, 0, 0.5]
target = [0, 0, 0]
up = [0, 1, 0]
fov = 90
[output]
size = [64, 64]
)"));
    EXPECT_EQ(count(picture, Verdict::hit), 64 * 64);
    for (const float z : picture.frame.find("Z")->samples) EXPECT_NEAR(z, 0.5, 1e-4);
}

// A formula of thousands of operations takes its gradient in another way: by three slopes.
TEST_P(ClosedForms, NormalsOfALongFormulaAreItsGradient) {
    std::string formula = "x^2 + y^2 + z^2 - 1";
    for (int k = 1; k <= 250; ++k) formula += fmt::format(" + 1e-4*sin({}*x + y)*z", k);
    std::string text = sphere_scene;
    text.replace(text.find("x^2 + y^2 + z^2 - 1"), 19, formula);
    const scene::Scene scene = scene_of(text, {"output.size=[40,30]"});
    const Picture picture = draw(*context, scene);
    formula::FieldEvaluator<double> evaluate(*scene.surfaces[0].field);
    const auto at = [&](const char* name, std::size_t k) {
        return double(picture.frame.find(name)->samples[k]);
    };
    int hits = 0;
    for (std::size_t k = 0; k < 40 * 30; ++k) {
        if (at("verdict", k) != 1) continue;
        const auto g = evaluate.gradient({}, {at("P.X", k), at("P.Y", k), at("P.Z", k)});
        const double length = std::hypot(g[0], g[1], g[2]);
        const double cosine =
            (g[0] * at("N.X", k) + g[1] * at("N.Y", k) + g[2] * at("N.Z", k)) / length;
        EXPECT_GT(std::abs(cosine), 1 - 1e-6);
        ++hits;
    }
    EXPECT_GT(hits, 150);
}

// The paper's Fig. 6: touching roots don't change the sign, and the Taylor test sees them.
TEST_P(ClosedForms, TaylorTestFindsTheTouchingRootsThatTheSignTestMisses) {
    std::string text = sphere_scene;
    text.replace(text.find("x^2 + y^2 + z^2 - 1"), 19, "(x^2 + y^2 + z^2 - 1)^2");
    text += "[isolation]\nstep = 0.02\nnear = 0.1\nfar = 0.5\nhorizon = 0.1\n";
    const std::int64_t simple =
        count(draw(*context, scene_of(sphere_scene, {"isolation.step=0.002"})), Verdict::hit);
    const auto sign = draw(*context, scene_of(text, {"isolation.method=\"amp-sign\""}));
    const auto taylor = draw(*context, scene_of(text, {"isolation.method=\"amp-taylor\""}));
    EXPECT_EQ(count(sign, Verdict::hit) + count(sign, Verdict::zero_gradient), 0);
    EXPECT_GE(count(taylor, Verdict::hit) + count(taylor, Verdict::zero_gradient), simple);
}

// Parallel rays: a sphere is a disc of its own size, with depth and normals in closed form.
TEST_P(ClosedForms, OrthographicSphereIsADiscOfItsSize) {
    const scene::Scene scene =
        scene_of(sphere_scene, {"camera.projection=orthographic", "camera.height=3"});
    const Picture picture = draw(*context, scene);
    const image::Frame& f = picture.frame;
    const auto at = [&](const char* name, int k) {
        return double(f.find(name)->samples[std::size_t(k)]);
    };
    const double margin = scene.surfaces[0].isolation.step * scene.surfaces[0].isolation.step;
    for (int row = 0; row < f.height; ++row) {
        for (int column = 0; column < f.width; ++column) {
            const int k = row * f.width + column;
            const double y = ((column + 0.5) / f.width - 0.5) * 4; // 160 to 120 pixels
            const double z = (0.5 - (row + 0.5) / f.height) * 3;
            const double square = 1 - y * y - z * z;
            const auto verdict = Verdict(int(at("verdict", k)));
            if (square < -margin) {
                ASSERT_EQ(verdict, Verdict::miss) << column << "," << row;
            }
            if (square < margin) continue;
            ASSERT_EQ(verdict, Verdict::hit) << column << "," << row;
            const double x = std::sqrt(square), tolerance = scene.surfaces[0].isolation.step / 1024;
            EXPECT_NEAR(at("Z", k), 5 - x, tolerance);
            EXPECT_NEAR(at("P.Y", k), y, 1e-5);
            EXPECT_NEAR(at("P.Z", k), z, 1e-5);
            EXPECT_NEAR(at("N.X", k), at("P.X", k), 1e-4);
        }
    }
}

// A shell x^2 + y^2 + z^2 = 1 cut open by the bounds: F < 0 inside.
TEST_P(ClosedForms, EachSideHasItsColour) {
    const std::string shell = R"(
[surface]
formula = "x^2 + y^2 + z^2 - 1"
bounds = { box = [[-1.1, -1.1, -1.1], [0.5, 1.1, 1.1]] }
[camera]
position = [5, 0, 0]
projection = "orthographic"
height = 2.4
[material]
color = [1, 0, 0]
back_color = [0, 0, 1]
[output]
size = [96, 96]
)";
    const Picture picture = draw(*context, scene_of(shell));
    const image::Frame& f = picture.frame;
    for (int k = 0; k < f.width * f.height; ++k) {
        const auto at = [&](const char* name) { return f.find(name)->samples[std::size_t(k)]; };
        if (Verdict(int(at("verdict"))) != Verdict::hit) continue;
        const bool inside = at("P.X") < 0; // through the opening
        const double radius = std::hypot(at("P.Y"), at("P.Z"));
        const double opening = std::sqrt(0.75);
        if (std::abs(radius - opening) > 0.03) {
            EXPECT_EQ(inside, radius < opening) << radius;
        }
        EXPECT_EQ(at("B") > 0, inside);
        EXPECT_EQ(at("R") > 0, !inside);
    }
    // Without a colour of its own the inside looks like the outside.
    std::string plain = shell;
    plain.erase(plain.find("back_color"), std::string("back_color = [0, 0, 1]\n").size());
    const Picture one = draw(*context, scene_of(plain));
    for (std::size_t k = 0; k < f.find("R")->samples.size(); ++k) {
        if (one.frame.find("verdict")->samples[k] != float(Verdict::hit)) continue;
        EXPECT_GT(one.frame.find("R")->samples[k], 0);
        EXPECT_EQ(one.frame.find("B")->samples[k], 0);
    }
}

} // namespace
} // namespace isomotion::render
