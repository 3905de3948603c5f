// What is held in the window is what `render` is told.
#include "player/model/session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "player/model/orbit.h"
#include "player/model/render_settings.h"
#include "scene/reading/load.h"

namespace isomotion::player {
namespace {

void expect_same(const scene::SceneAt& a, const scene::SceneAt& b) {
    EXPECT_EQ(a.time, b.time);
    EXPECT_EQ(a.camera, b.camera);
    EXPECT_EQ(a.surfaces[0].bindings.parameters, b.surfaces[0].bindings.parameters);
    EXPECT_EQ(a.surfaces[0].bounds.radius, b.surfaces[0].bounds.radius);
    EXPECT_EQ(a.surfaces[0].cubic_steps, b.surfaces[0].cubic_steps);
    ASSERT_EQ(a.lights.size(), b.lights.size());
    for (std::size_t k = 0; k < a.lights.size(); ++k) {
        EXPECT_EQ(a.lights[k].direction, b.lights[k].direction);
    }
    ASSERT_EQ(a.surfaces[0].bindings.arrays.size(), b.surfaces[0].bindings.arrays.size());
    for (std::size_t k = 0; k < a.surfaces[0].bindings.arrays.size(); ++k) {
        EXPECT_EQ(a.surfaces[0].bindings.arrays[k].fields, b.surfaces[0].bindings.arrays[k].fields);
    }
}

scene::SceneAt as_rendered(const Session& session, int frame, glm::ivec2 size) {
    auto overrides = render_settings(session);
    overrides.push_back("output.size=[" + std::to_string(size.x) + "," + std::to_string(size.y) +
                        "]");
    const scene::Scene scene = scene::load(session.scene().file.string(), overrides);
    return scene::at_frame(scene, frame);
}

TEST(Session, ShowsWhatRenderIsTold) {
    // Cameras at a place, on an orbit, over the shoulder; elements of an array.
    for (const char* name : {"blobby75", "barth_sextic", "superquadric", "falling_drops"}) {
        SCOPED_TRACE(name);
        Session session(scene::load(name));
        const glm::ivec2 size(300, 200);
        session.set_size(size);
        expect_same(session.at(3), as_rendered(session, 3, size));

        Look look = session.look();
        look.camera = orbited(session.at(3).camera, {0.31, -0.17});
        for (const SliderRange& span : session.slider_ranges(0)) {
            look.overrides.values[span.name] = 0.4 * span.least + 0.6 * span.most;
        }
        session.set(look);
        EXPECT_EQ(session.at(3).camera.position, look.camera->position);
        EXPECT_EQ(session.at(3).camera.target, look.camera->target);
        expect_same(session.at(3), as_rendered(session, 3, size));
        expect_same(session.at(5), as_rendered(session, 5, size));
    }
}

TEST(Session, ElementsAreMultipliedInRenderToo) {
    Session session(scene::load("blobby75"));
    const scene::SceneAt before = session.at(9);
    Look look = session.look();
    look.overrides.factors = {{"blobs.cx", 1.7}, {"blobs.uz", 0.1}};
    session.set(look);
    const scene::Output& output = session.scene().output;
    const glm::ivec2 size(output.width, output.height);
    const scene::SceneAt held = session.at(9);
    EXPECT_NE(held.surfaces[0].bindings.arrays[0].fields,
              before.surfaces[0].bindings.arrays[0].fields);
    expect_same(held, as_rendered(session, 9, size));
}

TEST(Session, WhatAReloadedSceneHasNoMoreIsNotSaid) {
    Session session(scene::load("blobby75"));
    const glm::ivec2 size(300, 200);
    session.set_size(size);
    Look look = session.look();
    look.overrides.values = {{"gone", 2}, {"blobs.gone", 3}, {"blobs.cx", 0.5}};
    look.overrides.factors = {{"blobs.gone", 2}, {"none.cx", 2}, {"s", 2}};
    session.set(look);
    for (const scene::Override& setting : render_settings(session)) {
        EXPECT_TRUE(setting.starts_with("isolation.")) << setting;
    }
    expect_same(session.at(3), as_rendered(session, 3, size));
}

TEST(Session, AReloadKeepsWhatIsHeld) {
    Session session(scene::load("blobby75"));
    Look look = session.look();
    look.camera = orbited(session.at(1).camera, {0.2, 0});
    look.overrides.values["s"] = 0.9;
    look.isolation.safety = 7;
    session.set(look);
    session.playback = scrubbed(session.playback, 77, 0);
    const std::uint64_t revision = session.revision();
    session.reload(scene::load("blobby75", {"material.color=[1,0,0]"}), 5);
    EXPECT_EQ(session.look(), look);
    EXPECT_GT(session.revision(), revision);
    EXPECT_EQ(frame_at(session.playback, 9).frame, 77);
    EXPECT_EQ(session.at(77).surfaces[0].color, glm::dvec3(1, 0, 0));
}

TEST(Session, SettingsOfAMethodFollowTheFileUntilTheyAreTouched) {
    Session session(scene::load("blobby75"));
    session.reload(scene::load("blobby75", {"isolation.safety=9"}), 0);
    EXPECT_EQ(session.look().isolation.safety, 9);
    Look look = session.look();
    look.isolation.safety = 20;
    session.set(look);
    session.reload(scene::load("blobby75", {"isolation.safety=11"}), 0);
    EXPECT_EQ(session.look().isolation.safety, 20);
}

} // namespace
} // namespace isomotion::player
