// What --certify calls proved is true: compared with closed forms and certified truth, also where
// the march is wrong.
#include <cstdlib>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "accuracy/compare.h"
#include "render/doubles.h"
#include "render/drawing.h"
#include "roots/certify.h"
#include "thorough.h"
#include "unit/formula/stranger_formula.h"

namespace isomotion::accuracy {
namespace {

using render::Picture, render::Proof, render::scene_of;

constexpr int side = 64;

std::vector<shader::Channel> channels() {
    auto all = render::every_channel;
    all.push_back(shader::Channel::proof);
    return all;
}

Picture certified(gpu::Context& context, const scene::Scene& scene, int frame = 1) {
    render::Renderer renderer(context, scene,
                              {scene.output.width, scene.output.height, channels(), {}});
    return renderer.draw(scene::at_frame(scene, frame));
}

std::int64_t count(const Picture& picture, Proof proof) {
    return picture.proofs[std::size_t(proof)];
}

class Certify : public render::Drawing {
protected:
    // Seen along -x, a pixel 2.4 / 64 wide.
    Picture draw_formula(const std::string& formula, const std::string& isolation = {}) {
        return certified(*context, scene_of(fmt::format(R"(
[surface]
formula = "{}"
bounds = {{ sphere = 1.5 }}
[camera]
position = [5, 0, 0]
projection = "orthographic"
height = 2.4
[output]
size = [{}, {}]
[isolation]
certify = true
{})",
                                                        formula, side, side, isolation)));
    }
};
ISOMOTION_ON_EVERY_BACKEND(Certify);

TEST_P(Certify, ASphereIsProvedAndIsWhereItIs) {
    const Picture picture = draw_formula("x^2 + y^2 + z^2 - 1");
    const double pixel = 2.4 / side;
    int hits = 0, misses = 0;
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            const auto at = [&](const char* name) {
                return double(picture.frame.find(name)->samples[std::size_t(row * side + column)]);
            };
            const double middle = 0.5 * (side - 1);
            const double off = std::hypot(column - middle, row - middle) * pixel;
            const auto proof = Proof(int(at("proof")));
            hits += proof == Proof::hit;
            misses += proof == Proof::miss;
            if (proof == Proof::miss) {
                EXPECT_GE(off, 1);
            }
            if (proof == Proof::hit) {
                ASSERT_LT(off, 1);
                EXPECT_NEAR(at("P.X"), std::sqrt(1 - off * off), pixel / 8);
            }
        }
    }
    EXPECT_EQ(hits, count(picture, Proof::hit));
    EXPECT_EQ(misses, count(picture, Proof::miss));
    EXPECT_GT(hits + misses, 0.995 * side * side);
}

// Roots found by few bisections are off by up to 0.0125, 0.006 and 0.003; an eighth of a pixel is
// 0.0047.
TEST_P(Certify, ARootThatIsOffByMoreIsNotProved) {
    const double pixel = 2.4 / side;
    std::int64_t proved = 0, open = 0;
    for (const int bisections : {1, 2, 3}) {
        const Picture picture = draw_formula(
            "x^2 + y^2 + z^2 - 1",
            fmt::format("method = 'amp-sign'\nstep = 0.05\nbisections = {}\n", bisections));
        const auto& proof = picture.frame.find("proof")->samples;
        for (std::size_t k = 0; k < proof.size(); ++k) {
            if (Proof(int(proof[k])) != Proof::hit) continue;
            std::array<double, 3> p{};
            for (std::size_t i = 0; i < 3; ++i)
                p[i] = double(picture.frame.find(std::array{"P.X", "P.Y", "P.Z"}[i])->samples[k]);
            ASSERT_NEAR(p[0], std::sqrt(1 - p[1] * p[1] - p[2] * p[2]), pixel / 8);
        }
        proved += count(picture, Proof::hit);
        open += count(picture, Proof::sign);
    }
    EXPECT_GT(proved, 1000);
    EXPECT_GT(open, 500);
}

// Tiles and passes, and blocks of rays that tiles cut, change no proof.
TEST_P(Certify, AProofIsTheSameByAnyPlan) {
    for (const char* method : {"hermite", "amp-sign"}) {
        SCOPED_TRACE(method);
        const scene::Scene scene = scene_of(fmt::format(R"(
[surface]
use = "cayley"
[output]
size = [61, 47]
[isolation]
certify = true
method = "{}"
)",
                                                        method));
        const scene::SceneAt now = scene::at_frame(scene, 1);
        const auto drawn = [&](std::optional<render::MarchPlan> plan) {
            render::Renderer renderer(*context, scene, {61, 47, channels(), plan});
            return renderer.draw(now);
        };
        const Picture at_once = drawn({});
        const Picture bit_by_bit = drawn(render::MarchPlan{32, 32, 3});
        EXPECT_GT(bit_by_bit.passes, 8);
        EXPECT_GT(count(at_once, Proof::hit), 500);
        EXPECT_EQ(at_once.frame.find("proof")->samples, bit_by_bit.frame.find("proof")->samples);
    }
}

// Where F only touches 0 nothing tells a root from none.
TEST_P(Certify, ADoubleRootIsNeitherProvedNorDisproved) {
    const Picture once = draw_formula("x^2 + y^2 + z^2 - 1");
    const Picture twice = draw_formula("(x^2 + y^2 + z^2 - 1)^2");
    EXPECT_EQ(count(twice, Proof::hit), 0);
    EXPECT_GT(count(once, Proof::hit), 1500);
    EXPECT_GE(count(twice, Proof::sign) + count(twice, Proof::hidden), count(once, Proof::hit));
    EXPECT_LE(count(twice, Proof::miss), count(once, Proof::miss));
    EXPECT_GT(count(twice, Proof::miss), 0);
}

// Uniform steps go over two sheets 1e-4 apart, which half of the picture has, and a kink that
// reaches 0 by half of that.
TEST_P(Certify, WhatTheMarchStepsOverIsNeverProved) {
    for (const char* sheets : {"(x - 0.2)^2 - 2.5e-9 + 0*y", "abs(x - 0.2) - 5e-5"}) {
        SCOPED_TRACE(sheets);
        const std::string steps = "method = \"marching\"\nstep = 0.0137\n";
        const Picture gone = draw_formula(sheets, steps);
        EXPECT_GT(render::count(gone, render::Verdict::miss), 3000); // else nothing is tested
        const std::int64_t beside = draw_formula("x - 0.2").verdicts[0];
        EXPECT_LE(count(gone, Proof::miss), beside);
        // ... and with a plane behind them, which the march hits.
        const Picture behind =
            draw_formula(fmt::format("({})*(x + 0.3)", std::string(sheets)), steps);
        EXPECT_GT(render::count(behind, render::Verdict::hit), 2000);
        EXPECT_LT(count(behind, Proof::hit), render::count(behind, render::Verdict::hit) / 4);
        const auto& proof = behind.frame.find("proof")->samples;
        const auto& x = behind.frame.find("P.X")->samples;
        for (std::size_t k = 0; k < proof.size(); ++k) {
            // Rays beside the sheets' disk may meet the plane first.
            const double y = double(behind.frame.find("P.Y")->samples[k]);
            const double z = double(behind.frame.find("P.Z")->samples[k]);
            if (Proof(int(proof[k])) != Proof::hit || x[k] > 0) continue;
            EXPECT_GT(0.04 + y * y + z * z, 1.5 * 1.5 - 1e-4) << k;
        }
    }
}

TEST_P(Certify, APoleIsNoRoot) {
    const Picture pole = draw_formula("1/(x - 0.2)");
    EXPECT_EQ(count(pole, Proof::hit), 0);
    const Picture jump = draw_formula("sign(x - 0.2)");
    EXPECT_EQ(count(jump, Proof::miss), draw_formula("x - 0.2").verdicts[0]);
}

// Slopes on both sides of a pole, and of what is cut off or jumps, say nothing of what is between.
TEST_P(Certify, WhatJumpsIsNotProved) {
    const std::int64_t beside = draw_formula("x").verdicts[0];
    for (const char* formula : {"tan(x + pi/2)", "x + 1e-4*(floor(x) + 0.5)", "x/abs(x) + 0.5",
                                "min(tan(x + pi/2), 2)", "x^(-301)"}) {
        SCOPED_TRACE(formula);
        const Picture picture = draw_formula(formula);
        EXPECT_EQ(count(picture, Proof::hit), 0);
        EXPECT_LE(count(picture, Proof::miss), beside + 4); // of rays that pass the bounds by
    }
    // A root that is proved is met before the first pole.
    const double pole = 0.5 * std::numbers::pi;
    const Picture picture = draw_formula("tan(20*x + 2.141)");
    const auto& proof = picture.frame.find("proof")->samples;
    std::array<std::vector<float>, 3> p;
    for (std::size_t k = 0; k < 3; ++k)
        p[k] = picture.frame.find(std::array{"P.X", "P.Y", "P.Z"}[k])->samples;
    int proved = 0;
    for (std::size_t k = 0; k < proof.size(); ++k) {
        if (Proof(int(proof[k])) != Proof::hit) continue;
        ++proved;
        const double x = double(p[0][k]), y = double(p[1][k]), z = double(p[2][k]);
        const double entry = std::sqrt(2.25 - y * y - z * z);
        EXPECT_EQ(std::floor((20 * entry + 2.141 - pole) / std::numbers::pi),
                  std::floor((20 * x + 2.141 - pole) / std::numbers::pi));
    }
    EXPECT_GT(proved, 500);
}

// Squares of such lengths over- or underflow in floats: whatever was drawn, nothing is proved.
TEST_P(Certify, RaysBeyondFloatsAreNotProved) {
    const auto proved = [&](double size) {
        const Picture picture =
            certified(*context, scene_of(fmt::format(R"(
[surface]
formula = "(x/{0})^2 + (y/{0})^2 + (z/{0})^2 - 1"
bounds = {{ sphere = {1} }}
[camera]
position = [{2}, 0, 0]
[output]
size = [32, 32]
[isolation]
certify = true
)",
                                                     size, 1.5 * size, 5 * size)));
        return count(picture, Proof::hit) + count(picture, Proof::miss);
    };
    for (const double size : {1e-12, 1e12}) EXPECT_GT(proved(size), 1000) << size;
    for (const double size : {1e-17, 1e19}) EXPECT_EQ(proved(size), 0) << size;
    if (!is_thorough()) return;
    for (const double size : {1e-3, 1e3}) EXPECT_GT(proved(size), 1000) << size;
    EXPECT_EQ(proved(1e25), 0);
    // No picture of these can be right, and none is drawn.
    for (const double size : {1e-30, 1e-20}) EXPECT_THROW(proved(size), scene::SceneError) << size;
}

TEST_P(Certify, EveryPixelHasAnOutcome) {
    // x < 2 everywhere in the bounds.
    const Picture undefined = draw_formula("log(x - 2) + y", "method = \"amp-sign\"\n");
    EXPECT_EQ(count(undefined, Proof::none), render::count(undefined, render::Verdict::nan));
    EXPECT_GT(count(undefined, Proof::none), 2000);
    std::int64_t all = 0;
    for (const auto n : undefined.proofs) all += n;
    EXPECT_EQ(all, side * side);
}

// A polynomial of degree 14 written out, whose terms are thousands of times their sum.
TEST_P(Certify, DoublesProveWhatFloatsCannot) {
    const scene::Scene scene = scene_of(fmt::format(
        "[surface]\nuse = 'chmutov_14_power'\n[output]\nsize = [{0}, {0}]\n[isolation]\ncertify = "
        "true\n",
        side));
    const scene::SceneAt now = scene::in_formula_coordinates(scene::at_frame(scene, 1));
    const auto proved_by = [&](bool doubles) {
        render::RenderOptions options{side, side, channels(), {}};
        options.proofs_in_doubles = doubles;
        return render::Renderer(*context, scene, options).draw(now);
    };
    const Picture by_floats = proved_by(false), by_both = proved_by(true);
    EXPECT_LT(render::proved_part(by_floats.proofs), 0.9); // else nothing is tested
    const auto& before = by_floats.frame.find("proof")->samples;
    const auto& after = by_both.frame.find("proof")->samples;
    const auto& verdicts = by_both.frame.find("verdict")->samples;
    for (std::size_t k = 0; k < before.size(); ++k) {
        const auto proof = Proof(int(after[k]));
        if (render::is_proved(Proof(int(before[k])))) {
            EXPECT_EQ(after[k], before[k]) << k;
        }
        if (render::is_proved(proof)) {
            EXPECT_EQ(proof == Proof::hit, verdicts[k] == float(render::Verdict::hit)) << k;
        }
    }
    if (!render::can_trust_doubles(0)) {
        EXPECT_EQ(before, after);
        GTEST_SKIP() << "no doubles, or not to be trusted";
    }
    EXPECT_GE(render::proved_part(by_both.proofs), 0.98);
    const Errors errors = compare(now, by_both.frame, roots::certify(scene, now, side, side));
    EXPECT_EQ(errors.contradicted, 0);
}

// A sample of so many rays shows that floats decide hardly any, and doubles try the others at once.
// They prove those that floats would have proved, too, and each ray has one outcome.
TEST_P(Certify, DoublesProveWhatFloatsAreNotAsked) {
    constexpr int larger = 512; // whose pixels are narrow enough
    const scene::Scene scene = scene_of(fmt::format(
        "[surface]\nuse = 'chmutov_14_power'\n[output]\nsize = [{0}, {0}]\n[isolation]\ncertify = "
        "true\n",
        larger));
    const auto proved_by = [&](bool doubles, std::optional<render::MarchPlan> plan) {
        render::RenderOptions options{larger, larger, channels(), plan};
        options.proofs_in_doubles = doubles;
        return render::Renderer(*context, scene, options).draw(scene::at_frame(scene, 1));
    };
    const Picture by_floats = proved_by(false, {}), by_both = proved_by(true, {});
    const Picture in_tiles = proved_by(true, render::MarchPlan{96, 64, 500});
    if (!render::can_trust_doubles(0)) GTEST_SKIP() << "no doubles, or not to be trusted";
    const auto& before = by_floats.frame.find("proof")->samples;
    const auto& after = by_both.frame.find("proof")->samples;
    const auto& tiled = in_tiles.frame.find("proof")->samples;
    render::ProofCounts counted{};
    int lost = 0, other = 0;
    for (std::size_t k = 0; k < after.size(); ++k) {
        ++counted.at(std::size_t(after[k]));
        lost += render::is_proved(Proof(int(before[k]))) && after[k] != before[k];
        other += render::is_proved(Proof(int(tiled[k]))) != render::is_proved(Proof(int(after[k])));
    }
    EXPECT_EQ(lost, 0);
    EXPECT_EQ(other, 0) << "tiles, whose rays are too few to be asked";
    EXPECT_EQ(counted, by_both.proofs);
    EXPECT_LT(render::proved_part(by_floats.proofs), 0.8);
    EXPECT_GE(render::proved_part(by_both.proofs), 0.99);
}

struct Cheap {
    const char* animation;
    double proved; // at least this part
};

void PrintTo(const Cheap& cheap, std::ostream* out) { *out << cheap.animation; }

class CertifyAnimation : public testing::TestWithParam<Cheap> {};

TEST_P(CertifyAnimation, IsNotContradictedByTruth) {
    const scene::Scene scene = scene::load(
        GetParam().animation, {"look=none", "isolation.certify=true", "output.samples=1",
                               fmt::format("output.size=[{},{}]", side, side)});
    const int frame = scene.output.poster;
    const scene::SceneAt now = scene::in_formula_coordinates(scene::at_frame(scene, frame));
    const roots::Truth truth = roots::certify(scene, now, side, side);
    for (const auto backend : {gpu::Backend::egl, gpu::Backend::osmesa}) {
        const auto context = gpu::open_if_available(backend);
        if (!context) continue;
        render::Renderer renderer(*context, scene, {side, side, channels(), {}});
        const Picture picture = renderer.draw(now);
        const Errors errors = compare(now, picture.frame, truth);
        EXPECT_EQ(errors.contradicted, 0);
        EXPECT_EQ(errors.proofs, picture.proofs);
        EXPECT_GE(render::proved_part(errors.proofs), GetParam().proved);
    }
}
INSTANTIATE_TEST_SUITE_P(Cheap, CertifyAnimation,
                         testing::Values(Cheap{"torus", 0.98}, Cheap{"cassini", 0.98},
                                         Cheap{"cayley", 0.98}, Cheap{"clebsch", 0.98},
                                         Cheap{"ding_dong", 0.98}, Cheap{"goursat", 0.98},
                                         Cheap{"heart", 0.98}, Cheap{"kummer", 0.95},
                                         Cheap{"tangle", 0.95}, Cheap{"barth_sextic", 0.95}),
                         [](const auto& tested) { return std::string(tested.param.animation); });

// Strangers' formulas, of which truth knows nothing but by its own march.
class CertifyRandom : public testing::Test {
protected:
    static void attack(unsigned formulas) {
        const char* given = std::getenv("ISOMOTION_SEED");
        const unsigned first = given ? unsigned(std::strtoul(given, nullptr, 10)) : 2200;
        const auto context = gpu::open_if_available(gpu::Backend::egl);
        if (!context) GTEST_SKIP() << "no EGL";
        std::int64_t proved = 0, pixels = 0;
        int refused = 0;
        for (unsigned seed = first; seed < first + formulas && !HasFailure(); ++seed) {
            const std::string formula = formula::StrangerFormula(seed).text();
            SCOPED_TRACE(fmt::format("{}, seed {} (ISOMOTION_SEED)", formula, seed));
            try {
                const Errors errors = errors_of(*context, formula);
                EXPECT_EQ(errors.contradicted, 0);
                for (const Proof proof : {Proof::hit, Proof::miss})
                    proved += errors.proofs[std::size_t(proof)];
                pixels += errors.pixels;
            } catch (const base::InputError&) {
                ++refused; // constants without a value
            }
        }
        fmt::print("{} formulas, {} refused: {} of {} pixels proved\n", formulas, refused, proved,
                   pixels);
        EXPECT_GT(proved, pixels / 3);
    }

private:
    static Errors errors_of(gpu::Context& context, const std::string& formula) {
        const scene::Scene scene = scene_of(fmt::format(
            "[surface]\nformula = \"{}\"\nbounds = {{ sphere = 1.5 }}\n[camera]\nposition = [4, 1, "
            "2]\n[output]\nsize = [24, 24]\n[isolation]\ncertify = true\n",
            formula));
        const scene::SceneAt now = scene::in_formula_coordinates(scene::at_frame(scene, 1));
        render::Renderer renderer(context, scene, {24, 24, channels(), {}});
        return compare(
            now, renderer.draw(now).frame,
            roots::certify(scene, now, 24, 24, {roots::Budget{.evaluations = 4000}, 0, {}}));
    }
};

TEST_F(CertifyRandom, FormulasAreNotContradictedByTruth) { attack(4); }
TEST_F(CertifyRandom, HundredsOfFormulasAreNotContradictedByTruth) { attack(200); }

} // namespace
} // namespace isomotion::accuracy
