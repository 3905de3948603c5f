// Proofs of pictures of several surfaces against truth, and against what marches miss.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "accuracy/compare.h"
#include "render/drawing.h"
#include "render/picture_proofs.h"
#include "roots/certify.h"

namespace isomotion::accuracy {
namespace {

using render::Proof, render::Verdict, shader::Channel;

gpu::Context& context_of_proofs() {
    static const auto it = gpu::Context::create();
    return *it;
}

std::string ball(const std::string& place, double radius, const std::string& more = "") {
    return fmt::format("[[surfaces]]\nformula = \"x^2 + y^2 + z^2 - {}^2\"\nbounds = {{ sphere = "
                       "{} }}\ntransform = {{ translate = {} }}\n{}\n",
                       radius, 1.1 * radius, place, more);
}

constexpr const char* view =
    "[camera]\nposition = [0, -6, 1]\ntarget = [0, 0, 0]\n[output]\nsize = "
    "[64, 64]\n[isolation]\ncertify = true\n";

struct Proved {
    render::Picture picture;
    Errors errors;
};

Proved proved(const std::string& text, const std::optional<render::MarchPlan>& plan = {}) {
    const scene::Scene scene = render::scene_of(text);
    render::RenderOptions options{scene.output.width, scene.output.height, {}, plan};
    options.channels = {Channel::normal, Channel::position, Channel::verdict, Channel::surface,
                        Channel::proof};
    render::Renderer renderer(context_of_proofs(), scene, options);
    const scene::SceneAt now = scene::in_formula_coordinates(scene::at_frame(scene, 1));
    Proved found{renderer.draw(now), {}};
    const roots::Truth truth = roots::certify(scene, now, scene.output.width, scene.output.height);
    found.errors = compare(now, found.picture.frame, truth);
    return found;
}

std::int64_t count(const Proved& of, Proof proof) { return of.picture.proofs[std::size_t(proof)]; }

// By a draw a surface and in passes, with surfaces of other units that are turned.
TEST(ProofsOfSurfaces, AreNotContradictedByTruth) {
    const std::string three =
        ball("[-0.6, 0, 0]", 1) + ball("[0.6, -0.3, 0.1]", 0.9) +
        "[[surfaces]]\nuse = \"tangle\"\ntransform = { translate = [0.2, -1.5, 0.5], rotate = [20, "
        "30, 40], scale = 0.2 }\n";
    for (const std::string& text :
         {three + view, three + "[[lights]]\ndirection = [1, -1, 1]\nshadow = true\n" + view}) {
        const Proved found = proved(text);
        EXPECT_EQ(found.errors.contradicted, 0);
        EXPECT_GT(render::proved_part(found.picture.proofs), 0.97)
            << render::summary(found.picture.proofs);
        EXPECT_GT(count(found, Proof::hit), 1000);
        EXPECT_GT(count(found, Proof::miss), 1000);
        const Proved parts = proved(text, render::MarchPlan{64, 32, 8});
        EXPECT_EQ(parts.errors.contradicted, 0);
        EXPECT_GT(render::proved_part(parts.picture.proofs), 0.97);
    }
}

// What is seen need not be told from what is far behind it, and coinciding surfaces can't be.
TEST(ProofsOfSurfaces, GoAsFarAsWhatIsSeen) {
    const Proved alone = proved(ball("[0, 0, 0]", 1) + ball("[0, -20, 0]", 1) + view);
    const Proved before = proved(ball("[0, 2, -0.3]", 0.5) + ball("[0, 0, 0]", 1) + view);
    EXPECT_GT(count(alone, Proof::hit), 500);
    EXPECT_EQ(before.errors.contradicted, 0);
    EXPECT_GE(count(before, Proof::hit), count(alone, Proof::hit) - 4);
    const Proved twice = proved(ball("[0, 0, 0]", 1) + ball("[0, 0, 0]", 1) + view);
    EXPECT_EQ(count(twice, Proof::hit), 0);
    EXPECT_GT(count(twice, Proof::hidden), 500);
    EXPECT_GE(count(twice, Proof::miss), count(alone, Proof::miss) - 100);
}

// A thin shell before a ball, which its march steps over: the ball is drawn, and nothing of it is
// proved.
TEST(ProofsOfSurfaces, WhatAMarchMissesOnOneIsProvedOfNone) {
    const std::string shell =
        "[[surfaces]]\nformula = \"(y + 0.1*x)^2 - 1e-6\"\nbounds = { sphere = 1.2 }\n"
        "transform = { translate = [0, -2, 0] }\n"
        "isolation = { method = \"marching\", step = 0.3 }\n";
    for (const bool first : {true, false}) {
        const std::string body = ball("[0, 0, 0]", 0.6);
        const Proved found = proved((first ? shell + body : body + shell) + view);
        EXPECT_EQ(found.errors.contradicted, 0);
        EXPECT_GT(found.errors.wrong(), 100);
        const int seen = first ? 2 : 1;
        for (std::size_t k = 0; k < 64 * 64; ++k) {
            if (int(found.picture.frame.find("surface")->samples[k]) != seen) continue;
            ASSERT_NE(int(found.picture.frame.find("proof")->samples[k]), int(Proof::hit)) << k;
        }
    }
}

TEST(ProofsOfSurfaces, JoinWhatEachTells) {
    const auto joined = [](Proof a, Proof b) {
        std::array<float, 4> all{float(a), 1, 2, 3};
        const std::array<float, 4> one{float(b), 4, 5, 6};
        render::join_proofs(all, one);
        return Proof(int(all[0]));
    };
    for (const Proof any : {Proof::none, Proof::hit, Proof::miss, Proof::hidden, Proof::sign,
                            Proof::budget, Proof::unbounded}) {
        EXPECT_EQ(joined(any, Proof::none), Proof::none);
        EXPECT_EQ(joined(Proof::none, any), Proof::none);
        EXPECT_EQ(joined(any, Proof::miss), any);
        EXPECT_EQ(joined(Proof::miss, any), any);
    }
    EXPECT_EQ(joined(Proof::hit, Proof::hidden), Proof::hidden);
    EXPECT_EQ(joined(Proof::sign, Proof::hit), Proof::sign);
    EXPECT_EQ(joined(Proof::budget, Proof::hidden), Proof::budget);
}

} // namespace
} // namespace isomotion::accuracy
