// Pictures asked for and taken later are those that are drawn and waited for.
#include "render/drawing.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "render/exposure.h"
#include "scene/reading/load.h"

namespace isomotion::render {
namespace {

class InFlight : public Drawing {
protected:
    static scene::Scene scene_of(const char* name) {
        return scene::load(name, {"look=none", "output.size=[61,43]"});
    }
    static scene::SceneAt at(const scene::Scene& scene, int frame) {
        return scene::at_frame(scene, frame);
    }
    Renderer renderer_of(const scene::Scene& scene, std::optional<MarchPlan> plan = {}) {
        RenderOptions options;
        options.width = scene.output.width;
        options.height = scene.output.height;
        options.channels = {shader::Channel::depth, shader::Channel::verdict,
                            shader::Channel::evaluations};
        options.plan = plan;
        return Renderer(*context, scene, std::move(options));
    }
    static void expect_same(const Picture& a, const Picture& b) {
        EXPECT_TRUE(same_bits(a.frame, b.frame));
        EXPECT_EQ(a.verdicts, b.verdicts);
        EXPECT_EQ(a.evaluations(), b.evaluations());
    }
};
ISOMOTION_ON_EVERY_BACKEND(InFlight);

TEST_P(InFlight, PicturesComeInTheOrderTheyWereAskedFor) {
    for (const char* name : {"torus", "blobby75", "chmutov_12"}) {
        SCOPED_TRACE(name);
        const scene::Scene scene = scene_of(name);
        Renderer waits = renderer_of(scene), overlaps = renderer_of(scene);
        ASSERT_EQ(overlaps.most_in_flight(), 2);
        std::vector<Picture> drawn;
        for (int frame = 1; frame <= 5; ++frame) drawn.push_back(waits.draw(at(scene, frame)));
        EXPECT_FALSE(same_bits(drawn[0].frame, drawn[4].frame));
        for (int frame = 1; frame <= 5; ++frame) {
            overlaps.start(at(scene, frame));
            if (frame == 1) continue;
            EXPECT_EQ(overlaps.in_flight(), 2);
            Picture taken = overlaps.take();
            expect_same(taken, drawn[std::size_t(frame) - 2]);
            EXPECT_GT(taken.drawing.count(), 0);
            overlaps.reuse(std::move(taken));
        }
        expect_same(overlaps.take(), drawn[4]);
        EXPECT_EQ(overlaps.in_flight(), 0);
        expect_same(overlaps.draw(at(scene, 2)), drawn[1]);
    }
}

// Some ray is not at its end then, which only the record tells.
TEST_P(InFlight, WhatOneDrawIsTooFewForIsDrawnInPasses) {
    const scene::Scene scene = scene_of("torus");
    const MarchPlan short_passes{61, 43, 2};
    Renderer renderer = renderer_of(scene, short_passes);
    renderer.start(at(scene, 1));
    renderer.start(at(scene, 2));
    const Picture first = renderer.take(), second = renderer.take();
    EXPECT_GT(first.passes, 1);
    EXPECT_EQ(renderer.most_in_flight(), 1) << "others of the scene will take passes, too";
    Renderer waits = renderer_of(scene, short_passes);
    expect_same(first, waits.draw(at(scene, 1)));
    expect_same(second, waits.draw(at(scene, 2)));
}

// That is found out in the middle of a frame, with the next of its pictures on the way.
TEST_P(InFlight, AFrameOfManyPicturesMayTurnOutToTakePasses) {
    scene::Scene scene = scene_of("torus");
    scene.output.samples = 5;
    Renderer overlaps = renderer_of(scene, MarchPlan{61, 43, 2});
    ASSERT_EQ(overlaps.most_in_flight(), 2);
    const Picture frame = expose(overlaps, scene, 1);
    EXPECT_EQ(overlaps.most_in_flight(), 1);
    EXPECT_EQ(overlaps.in_flight(), 0);
    Renderer passes = renderer_of(scene, MarchPlan{61, 43, 1});
    ASSERT_EQ(passes.most_in_flight(), 1);
    expect_same(frame, expose(passes, scene, 1));
}

TEST_P(InFlight, PicturesOfSeveralTilesAreNotAskedForAhead) {
    scene::Scene scene = scene_of("torus");
    scene.output.width = scene.output.height = 128;
    Renderer renderer = renderer_of(scene, MarchPlan{64, 64, 1000});
    EXPECT_EQ(renderer.most_in_flight(), 1);
    EXPECT_FALSE(ask(renderer, renderer.prepare(scene, 1)));
    EXPECT_EQ(renderer.in_flight(), 0);
    renderer.start(at(scene, 1));
    const Picture taken = renderer.take();
    expect_same(taken, renderer.draw(at(scene, 1)));
}

TEST_P(InFlight, OutOfTurnIsAMistake) {
    const scene::Scene scene = scene_of("torus");
    Renderer renderer = renderer_of(scene);
    EXPECT_THROW(renderer.take(), std::logic_error);
    renderer.start(at(scene, 1));
    EXPECT_THROW(renderer.draw(at(scene, 1)), std::logic_error);
    EXPECT_THROW(renderer.resize(30, 30), std::logic_error);
    renderer.start(at(scene, 2));
    EXPECT_THROW(renderer.start(at(scene, 3)), std::logic_error);
    EXPECT_EQ(renderer.in_flight(), 2);
    renderer.take();
    renderer.take();
    renderer.resize(30, 30);
    renderer.start(at(scene, 1));
    const Picture small = renderer.take();
    EXPECT_EQ(small.frame.width, 30);
    expect_same(small, renderer.draw(at(scene, 1)));
}

TEST_P(InFlight, NoneIsLeftWhereOneIsGivenUp) {
    const scene::Scene scene = scene_of("torus");
    bool stopped = false;
    RenderOptions options;
    options.width = options.height = 32;
    options.stop = [&] { return stopped; };
    Renderer renderer(*context, scene, std::move(options));
    renderer.start(at(scene, 1));
    stopped = true;
    EXPECT_THROW(renderer.start(at(scene, 2)), Stopped);
    EXPECT_EQ(renderer.in_flight(), 0);
    stopped = false;
    EXPECT_GT(renderer.draw(at(scene, 2)).evaluations(), 0);
}

// Each renderer has textures of its own in units that another of the context may give to others.
TEST_P(InFlight, RenderersOfOneContextKeepTheirSurroundings) {
    const std::string text =
        "[surface]\nformula = 'x^2 + y^2 + z^2 - 1'\nbounds = { sphere = 1.2 }\n"
        "[environment]\nmap = 'studio.exr'\n[material]\nmodel = 'ggx'\n"
        "reflection = 'self'\n";
    const scene::Scene scene = render::scene_of(text);
    scene::Scene other = scene;
    other.surfaces[0].isolation.method = scene::Method::amp_sign;
    other.surfaces[0].isolation.step = 0.05;
    Renderer first(*context, scene, {40, 30, {}, {}});
    const Picture before = first.draw(at(scene, 1));
    {
        Renderer second(*context, other, {40, 30, {}, {}});
        second.draw(at(other, 1));
        expect_same(first.draw(at(scene, 1)), before);
    }
    expect_same(first.draw(at(scene, 1)), before);
}

TEST_P(InFlight, InputsOfAnotherSizeAreRefused) {
    const scene::Scene scene = scene_of("torus");
    Renderer renderer = renderer_of(scene);
    const PictureInputs inputs = renderer.prepare(at(scene, 1));
    renderer.resize(32, 32);
    EXPECT_THROW(renderer.draw(inputs), std::logic_error);
    EXPECT_THROW(renderer.start(inputs), std::logic_error);
}

TEST_P(InFlight, AFrameOfOnePictureIsAskedFor) {
    scene::Scene scene = scene_of("torus");
    Renderer renderer = renderer_of(scene);
    ASSERT_TRUE(ask(renderer, renderer.prepare(scene, 3)));
    const Picture taken = renderer.take();
    expect_same(taken, expose(renderer, scene, 3));
    scene.output.samples = 4;
    EXPECT_FALSE(ask(renderer, renderer.prepare(scene, 3)));
}

} // namespace
} // namespace isomotion::render
