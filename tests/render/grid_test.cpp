// Elements found by place: the picture is that of all elements.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "render/drawing.h"
#include "scene/reading/load.h"
#include "shader/assemble.h"

namespace isomotion::render::grid_test {
namespace {

class Grid : public Drawing {};
ISOMOTION_ON_EVERY_BACKEND(Grid);

constexpr const char* distance = "((x-cx)^2 + (y-cy)^2 + (z-cz)^2)";

constexpr const char* weights = "w = '0.7 + 0.6*random(i, 3)'";

scene::Scene elements(const std::string& formula, int count, const std::string& more = {}) {
    return scene_of(fmt::format(R"toml([surface]
formula = "{}"
bounds = {{ sphere = 2 }}
[arrays.p]
count = {}
cx = "2.4*random(i, 0) - 1.2"
cy = "2.4*random(i, 1) - 1.2"
cz = "2.4*random(i, 2) - 1.2"
{}
[camera]
azimuth = 30
elevation = 20
[output]
size = [49, 31]
{})toml",
                                formula, count, formula.find('w') != formula.npos ? weights : "",
                                more));
}

struct Difference {
    int hits = 0, other_verdict = 0;
    double farthest = 0; // along the ray
};

Difference difference(const Picture& a, const Picture& b) {
    Difference found;
    const auto channel = [](const Picture& picture, const char* name) {
        return std::span<const float>(picture.frame.find(name)->samples);
    };
    const auto va = channel(a, "verdict"), vb = channel(b, "verdict");
    for (std::size_t k = 0; k < va.size(); ++k) {
        if (Verdict(int(va[k])) == Verdict::hit) ++found.hits;
        if (va[k] != vb[k]) {
            ++found.other_verdict;
        } else if (Verdict(int(va[k])) == Verdict::hit) {
            found.farthest =
                std::max(found.farthest, double(std::abs(channel(a, "Z")[k] - channel(b, "Z")[k])));
        }
    }
    return found;
}

// Draws by a method that goes by bounds and finds first roots wherever it begins.
Difference beside_all_elements(gpu::Context& context, scene::Scene scene) {
    scene.surfaces[0].isolation.method = scene::Method::interval;
    EXPECT_TRUE(shader::array_with_grid(shader::assemble(scene)));
    scene::Scene plain = scene;
    plain.surfaces[0].isolation.beam = false;
    EXPECT_FALSE(shader::array_with_grid(shader::assemble(plain)));
    return difference(draw(context, plain), draw(context, scene));
}

void expect_picture_of_all_elements(gpu::Context& context, const std::string& formula) {
    const Difference found = beside_all_elements(context, elements(formula, 600));
    EXPECT_GT(found.hits, 250) << formula;
    EXPECT_LE(found.other_verdict, 2) << formula;
    EXPECT_LT(found.farthest, 1e-3) << formula;
}

TEST_P(Grid, IsThePictureOfAllElements) {
    const std::string d = distance;
    for (const std::string& formula : std::vector<std::string>{
             "0.3 - sum(p, exp(-120*" + d + "))",
             // no roots alone tell how large the sum is; a plane where it is 0
             "z - 0.3 + sum(p, max(0, 1 - 25*" + d + ")^3)",
             "min(least(p, sqrt(" + d + ") - 0.12), z + 0.6)",
             // no kernels of a polynomial
             "least(p, max(max(abs(x-cx), abs(y-cy)), abs(z-cz)) - 0.1*w)",
         }) {
        expect_picture_of_all_elements(*context, formula);
    }
}

TEST_P(Grid, IsThePictureOfAllElementsInOtherFormulas) {
    const std::string d = distance;
    for (const std::string& formula : std::vector<std::string>{
             "0.3 - sum(p, w*max(0, 1 - 25*" + d + ")^3)",
             "0.3 - sum(p, w*max(0, 1 - 12*((x-cx+y-cy)^2 + 2*(y-cy)^2 + (z-cz)^2))^3)",
             "sum(p, w*max(0, 1 - 20*" + d + ")^2)/(1 + sum(p, max(0, 1 - 16*" + d + ")^3)) - 0.2",
             "max(0.3 - sum(p, max(0, 1 - 25*" + d + ")^3), 0.2*y - x)",
             "least(p, sqrt(" + d + ") - 0.12*w)",
             "0.4 - greatest(p, exp(-120*" + d + "))",
             "0.3 - sum(p, w*max(0, 1 - 4*abs(x-cx))*max(0, 1 - 5*abs(y-cy))*max(0, 1 - "
             "5*abs(z-cz)))",
             "least(p, sqrt((x-cx-0.2*w*max(0, min(1, 5*(x-cx) + 3*(y-cy))))^2"
             " + (y-cy-0.1*max(0, min(1, 5*(x-cx) + 3*(y-cy))))^2 + (z-cz)^2) - 0.08)",
         }) {
        expect_picture_of_all_elements(*context, formula);
    }
}

// Terms without a bound, terms of two distances, and quadrics that are flat but for rounding.
TEST_P(Grid, IsThePictureOfAllElementsWhereTermsAreHardToBound) {
    const std::string d = distance;
    const std::string rod = "(" + d + " - (0.6*(x-cx) + 0.64*(y-cy) + 0.48*(z-cz))^2)";
    for (const std::string& formula : std::vector<std::string>{
             "sum(p, 0.0005/sqrt(" + d + ")) - 0.25 - 0.1*z",
             "sum(p, 0.000001/" + d + "^2) - 1 - 0.2*z",
             "0.1 + 0.001*z - sum(p, exp(-500*" + d +
                 ")*max(0, 1 - ((x-cx-0.1)^2 + (y-cy)^2 + (z-cz)^2)/0.0144))"
                 " + 0.0001*sum(p, exp(-500*" +
                 d + "))",
             "sum(p, max(0, 1 - " + rod + "/0.0064)^2) - 1.5",
             "exp(-30*(z+1)) - sum(p, exp(-100*" + d + "))",
         }) {
        scene::Scene scene = elements(formula, 600);
        scene.output.width = 25;
        scene.output.height = 17;
        const Difference found = beside_all_elements(*context, scene);
        EXPECT_GT(found.hits, 10) << formula;
        EXPECT_LE(found.other_verdict, 2) << formula;
        EXPECT_LT(found.farthest, 1e-3) << formula;
    }
}

TEST_P(Grid, ShadowsMirrorsAndOcclusionSeeIt) {
    const std::string formula = std::string("0.3 - sum(p, w*max(0, 1 - 25*") + distance + ")^3)";
    const std::string effects = R"toml([[lights]]
direction = [1, 0.3, 1]
shadow = true
[material]
reflection = "self"
[occlusion]
)toml";
    scene::Scene scene = elements(formula, 600, effects);
    scene.surfaces[0].isolation.method = scene::Method::interval;
    scene::Scene plain = scene;
    plain.surfaces[0].isolation.beam = false;
    const Picture a = draw(*context, plain), b = draw(*context, scene);
    std::size_t other = 0;
    for (const char* name : {"R", "G", "B"}) {
        const auto& x = a.frame.find(name)->samples;
        const auto& y = b.frame.find(name)->samples;
        for (std::size_t k = 0; k < x.size(); ++k) other += std::abs(x[k] - y[k]) > 0.02f;
    }
    EXPECT_LT(other, 3 * 49 * 31 / 200) << "less than one in two hundred";
}

// Cubics pass cells without roots; they lose no blob by it.
TEST_P(Grid, CubicsHitWhatBoundsHit) {
    for (const char* kernel : {"exp(-120*", "max(0, 1 - 25*"}) {
        const std::string power = kernel[0] == 'm' ? ")^3" : ")";
        scene::Scene scene =
            elements(std::string("0.3 - sum(p, ") + kernel + distance + power + ")", 600);
        ASSERT_EQ(scene.surfaces[0].isolation.method, scene::Method::hermite);
        scene::Scene certain = scene;
        certain.surfaces[0].isolation.method = scene::Method::interval;
        const Difference found = difference(draw(*context, certain), draw(*context, scene));
        EXPECT_GT(found.hits, 250);
        EXPECT_LE(found.other_verdict, 2) << kernel;
        EXPECT_LT(found.farthest, 1e-2) << kernel;
    }
}

// Two thin capsules, each of half of the elements. Equal keys leave F smooth, but shaders cut keys
// off, so that F is flat beside them.
TEST_P(Grid, CubicsLoseNothingOfEqualKeys) {
    scene::Scene scene =
        elements("least(p, sqrt((x - 0.1 - 0.6*floor(cx/10))^2 + (y - floor(0.5 + cy/10))^2 + "
                 "max(0, abs(z - floor(0.5 + cz/10)) - 0.6)^2) - 0.06)",
                 100);
    ASSERT_EQ(scene.surfaces[0].isolation.method, scene::Method::hermite);
    ASSERT_TRUE(shader::array_with_grid(shader::assemble(scene)));
    scene::Scene certain = scene;
    certain.surfaces[0].isolation.method = scene::Method::interval;
    certain.surfaces[0].isolation.beam = false;
    const Difference found = difference(draw(*context, certain), draw(*context, scene));
    EXPECT_GT(found.hits, 10);
    EXPECT_LE(found.other_verdict, 1);
    EXPECT_LT(found.farthest, 1e-2);
}

// Where each element may matter nearly everywhere, cells are small enough for bounds all the same.
TEST_P(Grid, NoRayGivesUpAmongThousands) {
    const std::string d = distance;
    for (const std::string& formula : std::vector<std::string>{
             "abs(smoothmin(least(p, sqrt(" + d + ") - 0.04*w), 0.7*z + 0.5*x + 0.8, 0.8)) - 0.01",
             "least(p, sqrt(" + d + ") - 0.04*w)*(z + 0.3) - 0.001",
         }) {
        SCOPED_TRACE(formula);
        const Picture picture = draw(*context, elements(formula, 6000));
        EXPECT_EQ(count(picture, Verdict::step_limit), 0);
        EXPECT_GT(count(picture, Verdict::hit), 150);
        EXPECT_GT(count(picture, Verdict::miss), 100);
    }
}

TEST_P(Grid, DrawsNoElementOneAndMoreThanAShaderCanSum) {
    const std::string formula = std::string("0.3 - sum(p, max(0, 1 - 4000*") + distance + ")^3)";
    scene::Scene many = elements(formula, 70'000);
    EXPECT_GT(count(draw(*context, many), Verdict::hit), 250);
    scene::SceneAt now = scene::at_frame(many, 1);
    Renderer renderer(*context, many, {49, 31, every_channel});
    for (auto& column : now.surfaces[0].bindings.arrays[0].fields)
        column.resize(std::min<std::size_t>(column.size(), 1));
    now.surfaces[0].bindings.arrays[0].count = 1;
    EXPECT_LE(count(renderer.draw(now), Verdict::hit), 4);
    now.surfaces[0].bindings.arrays[0].count = 0;
    for (auto& column : now.surfaces[0].bindings.arrays[0].fields) column.clear();
    EXPECT_EQ(count(renderer.draw(now), Verdict::hit), 0);
}

TEST_P(Grid, SaysWhereTooManyMeet) {
    const scene::Scene scene =
        elements("0.3 - sum(p, max(0, 1 - 0.1*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))^3)", 60'000);
    Renderer renderer(*context, scene, {16, 16, {}});
    EXPECT_THROW(renderer.draw(scene::at_frame(scene, 1)), std::length_error);
}

} // namespace
} // namespace isomotion::render::grid_test
