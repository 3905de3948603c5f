// Proofs whose elements are found by place: what they call proved is so of all elements, also where
// the march is wrong.
#include <regex>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "render/drawing.h"
#include "shader/assemble.h"
#include "unit/elements/families.h"

namespace isomotion::accuracy::proofs_by_place_test {
namespace {

using render::Picture, render::Proof, render::scene_of, render::Verdict;

constexpr int width = 49, height = 33;

// Values of what families read. Scenes name those that their formula reads.
constexpr std::pair<const char*, const char*> parameters[] = {
    {"a", "69"}, {"h", "0.24"}, {"level", "0.3"}, {"s", "0.4"}};
constexpr std::pair<const char*, const char*> fields[] = {
    {"cx", "1.8*random(i, 0) - 0.9"}, {"cy", "1.8*random(i, 1) - 0.9"},
    {"cz", "1.8*random(i, 2) - 0.9"}, {"w", "0.7 + 0.6*random(i, 3)"},
    {"r", "0.12 + 0.1*random(i, 4)"}, {"dx", "0.6*random(i, 5) - 0.3"},
    {"gxx", "4 + 2*random(i, 6)"},    {"gxy", "random(i, 7) - 0.5"},
    {"gxz", "random(i, 8) - 0.5"},    {"gyy", "4 + 2*random(i, 9)"},
    {"gyz", "random(i, 10) - 0.5"},   {"gzz", "4 + 2*random(i, 11)"}};

// 600 elements in a ball.
scene::Scene family_scene(const std::string& formula, const std::string& isolation) {
    const auto lines = [&](const auto& values, const char* quote) {
        std::string text;
        for (const auto& [name, value] : values) {
            if (std::regex_search(formula, std::regex(fmt::format("\\b{}\\b", name))))
                text += fmt::format("{0} = {2}{1}{2}\n", name, value, quote);
        }
        return text;
    };
    return scene_of(fmt::format(R"toml([surface]
formula = "{}"
bounds = {{ sphere = 1.4 }}
[parameters]
{}[arrays.p]
count = 600
{}[camera]
azimuth = 30
elevation = 20
[output]
size = [{}, {}]
[isolation]
{})toml",
                                formula, lines(parameters, ""), lines(fields, "\""), width, height,
                                isolation));
}

Picture drawn(gpu::Context& context, const scene::Scene& scene) {
    auto channels = render::every_channel;
    if (scene.surfaces[0].isolation.certify) channels.push_back(shader::Channel::proof);
    render::Renderer renderer(context, scene, {width, height, channels, {}});
    return renderer.draw(scene::at_frame(scene, 1));
}

class ProofsByPlace : public render::Drawing {
protected:
    // By a march that steps over a part of them.
    void expect_true(const char* name, const char* formula) {
        SCOPED_TRACE(name);
        const scene::Scene by_place =
            family_scene(formula, "certify = true\nmethod = \"amp-sign\"\nstep = 0.4\n");
        EXPECT_TRUE(shader::array_with_grid(shader::assemble(by_place)));
        const scene::Scene all = family_scene(formula, "method = \"interval\"\nbeam = false\n");
        EXPECT_FALSE(shader::array_with_grid(shader::assemble(all)));
        expect_true_of(drawn(*context, by_place), drawn(*context, all));
    }

    // Where the picture `right` has a ray otherwise nothing is proved of it.
    void expect_true_of(const Picture& proved, const Picture& right) {
        const auto proof = std::span<const float>(proved.frame.find("proof")->samples);
        const auto marched = std::span<const float>(proved.frame.find("verdict")->samples);
        const auto verdict = std::span<const float>(right.frame.find("verdict")->samples);
        const auto near = std::span<const float>(proved.frame.find("Z")->samples);
        const auto depth = std::span<const float>(right.frame.find("Z")->samples);
        for (std::size_t k = 0; k < proof.size(); ++k) {
            const bool differs =
                marched[k] != verdict[k] || std::abs(near[k] - depth[k]) > 0.25f * pixel;
            wrong_ += differs;
            if (!render::is_proved(Proof(int(proof[k])))) continue;
            ++proved_;
            EXPECT_FALSE(differs) << k % width << "," << k / width << ": " << near[k]
                                  << " is proved, " << depth[k] << " is right";
        }
        pixels_ += int(proof.size());
    }

    static constexpr float pixel = 2.9f / height;
    int proved_ = 0, wrong_ = 0, pixels_ = 0;
};
ISOMOTION_ON_EVERY_BACKEND(ProofsByPlace);

TEST_P(ProofsByPlace, OfAFewFamiliesHoldForAllElements) {
    const elements::Family* const few[] = {&elements::families[0], &elements::families[7],
                                           &elements::least_families[0]};
    for (const elements::Family* family : few) expect_true(family->name, family->formula);
    EXPECT_GT(proved_, 0.6 * pixels_);
    EXPECT_GT(wrong_, 20); // else nothing is tested
}

TEST_P(ProofsByPlace, OfSumsHoldForAllElements) {
    for (const elements::Family& family : elements::families)
        expect_true(family.name, family.formula);
    EXPECT_GT(proved_, 0.4 * pixels_);
    EXPECT_GT(wrong_, 200); // else nothing is tested
}

TEST_P(ProofsByPlace, OfLeastElementsHoldForAllElements) {
    for (const elements::Family& family : elements::least_families)
        expect_true(family.name, family.formula);
    EXPECT_GT(proved_, 0.4 * pixels_);
    EXPECT_GT(wrong_, 200); // else nothing is tested
}

// Loops that drivers end, unasked, would leave terms of the second array out.
TEST_P(ProofsByPlace, OfTwoLongArraysHoldForAllElements) {
    const auto scene = [](const char* isolation) {
        return scene_of(fmt::format(R"toml([surface]
formula = "0.35 - sum(p, exp(-300*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))) - sum(q, exp(-300*((x-ex)^2 + (y-ey)^2 + (z-ez)^2)))"
bounds = {{ sphere = 1.4 }}
[arrays.p]
count = 2100
cx = "1.8*random(i, 0) - 0.9"
cy = "1.8*random(i, 1) - 0.9"
cz = "1.8*random(i, 2) - 0.9"
[arrays.q]
count = 1900
ex = "1.8*random(i, 3) - 0.9"
ey = "1.8*random(i, 4) - 0.9"
ez = "1.8*random(i, 5) - 0.9"
[output]
size = [{}, {}]
[isolation]
{})toml",
                                    width, height, isolation));
    };
    const scene::Scene by_place = scene("certify = true\nmethod = \"amp-sign\"\nstep = 0.4\n");
    EXPECT_TRUE(shader::array_with_grid(shader::assemble(by_place)));
    expect_true_of(drawn(*context, by_place), drawn(*context, scene("beam = false\n")));
    EXPECT_GT(wrong_, 20);
}

// Second derivatives lead from one cell's slopes to another's, which they do not know.
TEST_P(ProofsByPlace, OfPolynomialsTakeNoSecondDerivatives) {
    const scene::Scene scene =
        family_scene("sum(p, 0.001*((x-cx)^2 + (y-cy)^2 + (z-cz)^2)) - 0.9", "certify = true\n");
    EXPECT_TRUE(shader::array_with_grid(shader::assemble(scene)));
    EXPECT_GT(drawn(*context, scene).proofs[std::size_t(Proof::hit)], 100);
}

// Sums of F begin with what lists leave out, sums of its slopes with nothing.
TEST_P(ProofsByPlace, SumsBeginWithWhatListsLeaveOut) {
    const scene::Scene scene = family_scene(elements::families[0].formula, "certify = true\n");
    int texts = 0;
    for (const shader::Pass& pass : shader::assemble(scene).list) {
        if (pass.text.find("_in_cell") == std::string::npos) continue;
        const bool proves = pass.name.find("proof") != std::string::npos;
        EXPECT_EQ(pass.text.find("(array0_rest[0])") != std::string::npos, proves) << pass.name;
        texts += proves;
    }
    EXPECT_EQ(texts, 5);
}

// More elements at one place than a draw could go through for one box.
TEST_P(ProofsByPlace, ProvesNothingWhereListsAreTooLong) {
    const scene::Scene scene = scene_of(R"toml([surface]
formula = "3 - sum(p, max(0, 1 - 4*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))^3)"
bounds = { sphere = 1.4 }
[arrays.p]
count = 30000
cx = "0.001*random(i, 0)"
cy = "0.001*random(i, 1)"
cz = "0.001*random(i, 2)"
[output]
size = [49, 33]
[isolation]
certify = true
)toml");
    const Picture picture = drawn(*context, scene);
    EXPECT_EQ(picture.proofs[std::size_t(Proof::hit)], 0);
    EXPECT_GT(render::count(picture, Verdict::hit), 50);
    EXPECT_GT(picture.proofs[std::size_t(Proof::unbounded)], 50);
}

} // namespace
} // namespace isomotion::accuracy::proofs_by_place_test
