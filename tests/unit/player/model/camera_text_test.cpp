// What the copy button gives, read by the loader of scenes.
#include "player/model/camera_text.h"

#include <cmath>

#include "player/model/orbit.h"
#include "unit/formula/testing.h"
#include "unit/scene/testing.h"

namespace isomotion::player {
namespace {

using formula::Random;
using scene::CameraAt;
using Projection = scene::Camera::Projection;

class CameraText : public scene::Scenes {
protected:
    scene::Scene scene_with(const std::string& camera) const {
        return loaded("[surface]\nformula = \"x^2 + y^2 + z^2 - 1\"\nbounds = { sphere = 1.5 }\n" +
                      camera);
    }
    CameraAt read(const std::string& camera) const { return at_time(scene_with(camera), 0).camera; }
};

void expect_same(const CameraAt& a, const CameraAt& b) {
    EXPECT_EQ(a.position, b.position);
    EXPECT_EQ(a.target, b.target);
    EXPECT_EQ(a.up, b.up);
    EXPECT_EQ(a.zoom, b.zoom);
    EXPECT_EQ(a.projection, b.projection);
    EXPECT_EQ(a.aperture, b.aperture);
    if (a.projection == Projection::perspective) {
        EXPECT_EQ(a.fov, b.fov);
    } else {
        EXPECT_EQ(a.height, b.height);
    }
    if (a.aperture > 0) {
        EXPECT_EQ(a.focus, b.focus);
    }
}

TEST_F(CameraText, ReadsBackAsTheSameCameraToTheLastBit) {
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const auto number = [&] { return random.in(-1, 1) * std::exp(random.in(-40, 40)); };
        CameraAt camera;
        for (int k = 0; k < 3; ++k) {
            camera.position[k] = random.below(4) == 0 ? random.below(9) - 4 : number();
            camera.target[k] = random.below(4) == 0 ? -0.0 : number();
            camera.up[k] = number();
        }
        if (random.below(2) == 0) camera.up = {0, 0, 1};
        camera.fov = random.below(2) == 0 ? 1 + random.below(178) : random.in(1e-3, 179);
        camera.zoom = random.below(2) == 0 ? 1 : std::abs(number()) + 1e-9;
        camera.height = std::abs(number()) + 1e-9;
        camera.aperture = random.below(2) == 0 ? 0 : std::abs(number());
        camera.focus = std::abs(number()) + 1e-9;
        camera.projection =
            random.below(2) == 0 ? Projection::perspective : Projection::orthographic;
        expect_same(read(camera_text(camera)), camera);
    }
}

TEST_F(CameraText, WhatWasMovedByHandReadsBackToo) {
    const CameraAt start = read("[camera]\nprojection = \"orthographic\"\n");
    for (const CameraAt& from : {start, read("")}) {
        CameraAt camera = orbited(from, {0.123, -0.077});
        camera = panned(dollied(camera, 0.3, {0.1, 0.2}), {0.03, 0.01});
        EXPECT_NE(camera.position, from.position);
        expect_same(read(camera_text(camera)), camera);
    }
}

TEST_F(CameraText, IsWhatAPersonWouldWrite) {
    EXPECT_EQ(camera_text(read("[camera]\nposition = [3, 2.5, -1e-7]\nfov = 35\n")),
              "[camera]\nposition = [3, 2.5, -1e-07]\ntarget = [0, 0, 0]\nfov = 35\n");
    EXPECT_EQ(camera_text(read("[camera]\nposition = [0.1, 0, 1e20]\ntarget = [1, 2, 3]\n"
                               "up = [0, 1, 0]\nprojection = \"orthographic\"\nheight = 4\n"
                               "zoom = 1.25\naperture = 0.5\nfocus = 2\n"),
                          0.5),
              "[camera]\nposition = [0.1, 0, 1e+20]\ntarget = [1, 2, 3]\nup = [0, 1, 0]\n"
              "projection = \"orthographic\"\nheight = 4\nzoom = 1.25\naperture = 0.5\nfocus = 2\n"
              "shutter = 0.5\n");
}

TEST_F(CameraText, KeepsTheShutter) {
    EXPECT_EQ(scene_with(camera_text(read(""), 0.3)).camera.shutter, 0.3);
    EXPECT_EQ(scene_with(camera_text(read(""))).camera.shutter, 0);
}

} // namespace
} // namespace isomotion::player
