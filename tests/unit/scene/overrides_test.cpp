#include "testing.h"

namespace isomotion::scene {
namespace {

using testing::StartsWith;

class Overrides : public Scenes {
protected:
    SceneAt set(const std::vector<Override>& overrides, double time = 0) const {
        return at_time(loaded(ball(), overrides), time);
    }
    std::string wrong(const std::vector<Override>& overrides) const {
        return mistake(ball(), overrides);
    }
};

TEST_F(Overrides, AParameterByItsName) {
    EXPECT_EQ(set({"radius=2"}).surfaces[0].bindings.parameters[0], 2);
    EXPECT_EQ(set({"radius=-1.5e-3"}).surfaces[0].bindings.parameters[0], -1.5e-3f);
    EXPECT_EQ(set({"parameters.radius=2"}).surfaces[0].bindings.parameters[0], 2);
}

TEST_F(Overrides, AnExpressionWithAndWithoutQuotes) {
    EXPECT_EQ(set({"radius=2+t"}, 3).surfaces[0].bindings.parameters[0], 5);
    EXPECT_EQ(set({"radius=\"2+t\""}, 3).surfaces[0].bindings.parameters[0], 5);
    EXPECT_EQ(set({"radius='2+t'"}, 3).surfaces[0].bindings.parameters[0], 5);
    EXPECT_EQ(set({"radius=2 + max(t, 1)"}, 3).surfaces[0].bindings.parameters[0], 5);
}

TEST_F(Overrides, Keyframes) {
    EXPECT_EQ(set({"radius={ keys = [[0, 1], [1, 3]] }"}, 0.5).surfaces[0].bindings.parameters[0],
              2);
}

TEST_F(Overrides, AnyKeyOfTheFile) {
    EXPECT_EQ(set({"camera.fov=30"}).camera.fov, 30);
    EXPECT_EQ(set({"camera.up=[0,1,0]"}).camera.up, glm::dvec3(0, 1, 0));
    EXPECT_EQ(set({"camera.up=[0, '1+t', 0]"}, 1).camera.up, glm::dvec3(0, 2, 0));
    EXPECT_EQ(set({"surface.bounds.sphere=3"}).surfaces[0].bounds.radius, 3);
    EXPECT_EQ(loaded(ball(), {"output.size=[32, 16]"}).output.height, 16);
    EXPECT_EQ(loaded(ball(), {"time.fps=24000/1001"}).timeline.fps.denominator, 1001);
}

TEST_F(Overrides, AWholeCameraInPlaceOfTheScenes) {
    const CameraAt camera = set({"camera={azimuth = 0, elevation = 0, distance = 7}"}).camera;
    EXPECT_EQ(camera.position - camera.target, glm::dvec3(7, 0, 0));
    const std::string parallel =
        "camera={position=[0,1,0], projection='orthographic', height='1+t'}";
    EXPECT_EQ(set({parallel}, 2).camera.height, 3);
    EXPECT_EQ(set({parallel}).camera.position, glm::dvec3(0, 1, 0));
    EXPECT_THAT(wrong({"camera={positions=[0,1,0]}"}), testing::HasSubstr("positions"));
}

TEST_F(Overrides, SectionsTheFileDoesNotHave) {
    EXPECT_EQ(set({"material.color=[1, 0, 0]"}).surfaces[0].color, glm::dvec3(1, 0, 0));
    EXPECT_EQ(set({"surface.transform.scale=2"}).surfaces[0].placement.scale, 2);
    EXPECT_EQ(loaded(ball(), {"isolation.method=amp-taylor"}).surfaces[0].isolation.method,
              Method::amp_taylor);
}

TEST_F(Overrides, TheLastOfTwoHolds) {
    EXPECT_EQ(set({"radius=2", "radius=3"}).surfaces[0].bindings.parameters[0], 3);
}

TEST_F(Overrides, WhatIsNoSetting) {
    EXPECT_EQ(wrong({"radius"}), "--set radius: write name=value");
    EXPECT_EQ(wrong({"=3"}), "--set =3: write name=value");
    EXPECT_EQ(wrong({"radius="}), "--set radius=: write name=value");
    EXPECT_EQ(wrong({""}), "--set : write name=value");
    EXPECT_EQ(wrong({"title.long=3"}), "--set title.long=3: 'title' is not a table");
    EXPECT_EQ(mistake(ball_and("[[lights]]\ndirection = [0, 0, 1]"), {"lights.color=[1, 1, 1]"}),
              "--set lights.color=[1, 1, 1]: 'lights' is a list: write lights[0] for its first");
}

TEST_F(Overrides, ListsAndSectionsAreSetKeyByKey) {
    for (const char* list : {"lights", "sections"}) {
        const std::string setting = fmt::format("{}=[{{direction=[0,0,1]}}]", list);
        EXPECT_EQ(wrong({setting}), fmt::format("--set {}: '{}' is a list of the scene file; set "
                                                "keys of its tables: {}[0].key=value",
                                                setting, list, list));
    }
    EXPECT_EQ(wrong({"surfaces=[]"}), "--set surfaces=[]: 'surfaces' is a list of the scene file; "
                                      "set keys of its tables: surfaces.NAME.key=value");
    EXPECT_EQ(wrong({"output={size=[8,8]}"}), "--set output={size=[8,8]}: 'output' is a table; set "
                                              "its keys: output.key=value");
    EXPECT_THAT(wrong({"radius=[1]"}), StartsWith("--set: parameters.radius: must be a number"));
}

TEST_F(Overrides, ACountOfAnArrayThatNothingUses) {
    const std::string why = ": no formula and no colour sums or picks over an array of this name";
    EXPECT_EQ(wrong({"arrays.p.count=3"}), "--set: arrays.p.count" + why);
    EXPECT_EQ(mistake(blobs("count = 2\ncx = \"i\"\nw = 1"), {"arrays.blob.count=3"}),
              "--set: arrays.blob.count" + why);
    const Scene scene = loaded(blobs("count = 2\ncx = \"i\"\nw = 1"), {"arrays.blobs.count=3"});
    EXPECT_EQ(at_time(scene, 0).surfaces[0].bindings.counts(), std::vector{3});
    EXPECT_EQ(loaded(ball_and("[arrays.p]\ncount = 3")).surfaces[0].animation.arrays().size(), 1u);
}

TEST_F(Overrides, ATableOfAListByItsNumber) {
    const std::string two = ball_and("[[lights]]\ndirection = [0, 0, 1]\n"
                                     "[[lights]]\ndirection = [0, 1, 0]");
    const SceneAt now = at_time(loaded(two, {"lights[1].color=[1, 0, 0]"}), 0);
    EXPECT_EQ(now.lights[0].color, glm::dvec3(1));
    EXPECT_EQ(now.lights[1].color, glm::dvec3(1, 0, 0));
    EXPECT_EQ(mistake(two, {"lights[2].color=[1, 0, 0]"}),
              "--set lights[2].color=[1, 0, 0]: the scene lists no lights[2]");
    EXPECT_EQ(wrong({"lights[0].color=[1, 0, 0]"}),
              "--set lights[0].color=[1, 0, 0]: the scene lists no lights[0]");
}

// Where keys exclude each other, the one that is set holds.
TEST_F(Overrides, TakeThePlaceOfWhatTheyExclude) {
    EXPECT_EQ(loaded(ball_with(4, "seconds = 3"), {"time.frames=7"}).timeline.frames, 7);
    EXPECT_EQ(loaded(ball(), {"time.seconds=3"}).timeline.frames, 90);
    EXPECT_EQ(set({"surface.bounds.box=[[-1, -1, -1], [1, 1, 2]]"}).surfaces[0].bounds.max.z, 2);
    EXPECT_NEAR(set({"camera.elevation=90"}).camera.position.x, 0, 1e-12);
    EXPECT_THAT(wrong({"time.frames=7", "time.seconds=3"}),
                StartsWith("--set: time.seconds: says again how long the scene is"));
}

TEST_F(Overrides, FewerFramesHaveThePosterAmongThem) {
    const std::string late = ball() + "poster = 40\n";
    EXPECT_EQ(loaded(late).output.poster, 40);
    EXPECT_EQ(loaded(late, {"time.frames=7"}).output.poster, 7);
    EXPECT_EQ(loaded(late, {"time.seconds=1"}).output.poster, 30);
    EXPECT_EQ(mistake(late, {"time.frames=7", "output.poster=8"}),
              "--set: output.poster: must be from 1 to 7, a frame of the scene, not 8");
    EXPECT_THAT(mistake(ball() + "poster = 61\n"),
                StartsWith("scene.toml:15: output.poster: must be from 1 to 60, "));
}

TEST_F(Overrides, KeysWithoutTheirSectionAreToldIt) {
    EXPECT_EQ(wrong({"frames=7"}), "--set: parameters.frames: nothing uses this parameter; did you "
                                   "mean the scene's key time.frames?");
}

TEST_F(Overrides, UnknownNamesAreThoseOfTheCommandLine) {
    EXPECT_EQ(wrong({"raduis=2"}),
              "--set: parameters.raduis: nothing uses this parameter; did you mean 'radius'?");
    EXPECT_EQ(wrong({"camera.fvo=30"}), "--set: camera.fvo: unknown key; did you mean 'fov'?");
    EXPECT_EQ(wrong({"camra.fov=30"}), "--set: camra: unknown key; did you mean 'camera'?");
    EXPECT_EQ(wrong({"camera..fov=30"}),
              "--set: camera.: unknown key; known here: aperture, azimuth, distance, elevation, "
              "focus, fov, height, position, projection, shutter, target, up, zoom");
}

TEST_F(Overrides, ValuesAreCheckedAsInAFile) {
    EXPECT_EQ(wrong({"radius=nan"}), "--set: parameters.radius: must be finite");
    EXPECT_EQ(wrong({"radius=2+q"}),
              "--set: parameters.radius: unknown name 'q'; known: t, radius, pi\n"
              "    2+q\n"
              "      ^");
    EXPECT_THAT(wrong({"camera.up=[0,1"}), StartsWith("--set: camera.up: must be [x, y, z] or "));
    EXPECT_THAT(wrong({"camera.fov=[0]"}), StartsWith("--set: camera.fov: must be a number"));
    EXPECT_EQ(wrong({"time.frames=many"}), "--set: time.frames: must be an integer");
    EXPECT_EQ(wrong({"output.size=[0, 64]"}),
              "--set: output.size: must be [width, height], integers from 1 to 16384");
    EXPECT_EQ(wrong({"surface.formula=x - yy"}),
              "--set: surface.formula: unknown name 'yy'; did you mean 'y'?\n"
              "    x - yy\n"
              "        ^");
}

// A mistake elsewhere keeps its place in the file.
TEST_F(Overrides, TheFilesOwnMistakesStayTheFiles) {
    EXPECT_EQ(mistake(ball_with(12, "fob = 40"), {"camera.up=[0, 1, 0]"}),
              "scene.toml:12: camera.fob: unknown key; did you mean 'fov'?");
    EXPECT_EQ(mistake(ball_with(12, "fov = true"), {"camera.fov=40"}), "nothing is wrong");
}

} // namespace
} // namespace isomotion::scene
