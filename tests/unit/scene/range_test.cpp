// Values that leave their range while the scene moves.
#include <algorithm>

#include "testing.h"

namespace isomotion::scene {
namespace {

class Range : public Scenes {
protected:
    // What is wrong at t = 2, when nothing was at t = 0.
    std::string at_two(const std::string& text) const {
        const Scene scene = loaded(text);
        try {
            at_time(scene, 2);
        } catch (const SceneError& error) {
            const std::string message = error.what(), file = scene.file.string();
            EXPECT_EQ(message.substr(0, file.size() + 1), file + ":");
            return message.substr(std::min(file.size() + 1, message.size()));
        }
        return "nothing is wrong";
    }
    // The same without the line, which must be the last of these.
    std::string of_line(int number, const std::string& lines) const {
        const std::string told = at_two(ball_with(number, lines));
        const int last = number + int(std::ranges::count(lines, '\n'));
        const std::string place = std::to_string(last);
        return told.starts_with(place + ": ") ? told.substr(place.size()) : told;
    }
    std::string bounds_and(const std::string& line) const {
        return of_line(7, "bounds = { sphere = 1.5 }\n" + line);
    }
};

TEST_F(Range, Bounds) {
    EXPECT_EQ(of_line(7, "bounds = { sphere = \"2 - t\" }"),
              ": surface.bounds.sphere at t = 2: the radius must be above 0, not 0");
    EXPECT_EQ(of_line(7, "bounds = { sphere = \"1 - t\" }"),
              ": surface.bounds.sphere at t = 2: the radius must be above 0, not -1");
    EXPECT_EQ(of_line(7, "bounds = { box = [[-1, \"t - 1\", -1], [1, 1, 1]] }"),
              ": surface.bounds.box.min.y at t = 2: the first corner of the box must be below the "
              "second: 1 and 1");
    EXPECT_EQ(of_line(7, "bounds = { box = [[-1, -1, -1], [1, 1, \"1 - t\"]] }"),
              ": surface.bounds.box.min.z at t = 2: the first corner of the box must be below the "
              "second: -1 and -1");
}

TEST_F(Range, Placement) {
    EXPECT_EQ(bounds_and("transform = { scale = \"2 - t\" }"),
              ": surface.transform.scale at t = 2: must be above 0, not 0");
    EXPECT_EQ(bounds_and("transform = { scale = \"1 - t\" }"),
              ": surface.transform.scale at t = 2: must be above 0, not -1");
}

TEST_F(Range, Camera) {
    const std::string fov = ": camera.fov at t = 2: must be above 0 and below 180, not ";
    EXPECT_EQ(of_line(12, "fov = \"40 - 20*t\""), fov + "0");
    EXPECT_EQ(of_line(12, "fov = \"40 + 70*t\""), fov + "180");
    EXPECT_EQ(of_line(12, "fov = \"40 + 80*t\""), fov + "200");
    EXPECT_EQ(of_line(11, "position = [\"4 - 2*t\", 0, 0]"),
              ": camera.position.x at t = 2: the camera stands at its target; move one of them");
    EXPECT_EQ(of_line(12, "up = [0, 0, \"2 - t\"]"),
              ": camera.up.x at t = 2: `up` has no direction");
}

// The distance from eye to target is 0 in doubles, though it is not stated as 0, or its square is.
TEST_F(Range, TheEyeKeepsADistanceThatDoublesTell) {
    EXPECT_EQ(of_line(11, "position = [\"4*max(0, 1 - t) + 1e-200\", 0, 0]"),
              ": camera.position.x at t = 2: the camera stands at its target; move one of them");
    EXPECT_EQ(of_line(11, "position = [1e-150, 0, 0]"), "nothing is wrong");
    const std::string at_target =
        " at t = 2: the camera comes to stand at its target: it is nearer than the digits of its "
        "coordinates tell; move the scene to the origin, or the camera away";
    EXPECT_EQ(of_line(11, "distance = \"1e-200 + max(0, 1 - t)\""),
              ": camera.distance" + at_target);
    EXPECT_EQ(of_line(11, "target = [\"t*1e20\", \"t*1e20\", \"t*1e20\"]\ndistance = 4"),
              ": camera.distance" + at_target);
}

TEST_F(Range, TheEyeStaysWithinFloats) {
    const std::string beyond = " at t = 2: the camera comes to stand or to look beyond the range "
                               "of float (3.4e+38); make the scene smaller, or `fov` wider";
    EXPECT_EQ(of_line(11, "target = [\"t*1.5e38\", 0, 0]\ndistance = 3e38"),
              ": camera.distance" + beyond);
    std::string on_orbit = ball_with(12, "fov = { keys = [[0, 40], [1, 1e-300]] }");
    const std::string position = "position = [4, 0, 0]";
    on_orbit.replace(on_orbit.find(position), position.size(), "azimuth = 0");
    EXPECT_EQ(at_two(on_orbit), "12: camera.fov" + beyond);
}

TEST_F(Range, LengthsOfTheCameraKeepTheirDigitsInFloats) {
    EXPECT_EQ(of_line(12, "projection = \"orthographic\"\nheight = \"1e-200 + max(0, 1 - t)\""),
              ": camera.height at t = 2: must be at least 1e-18 in the formula's "
              "coordinates, not 1e-200");
    EXPECT_EQ(of_line(12, "aperture = 1\nfocus = \"1e-200 + max(0, 1 - t)\""),
              ": camera.focus at t = 2: must be at least 1e-18 in the formula's "
              "coordinates, not 1e-200");
}

TEST_F(Range, BoundsAreNotTooSmallForSquares) {
    const std::string small = " are too small for the GPU's numbers, which need 1e-18: write the "
                              "formula larger, and give `transform.scale`";
    EXPECT_EQ(of_line(7, "bounds = { sphere = \"1.5*max(0, 1 - t) + 1e-200\" }"),
              ": surface.bounds.sphere at t = 2: bounds of radius 1e-200" + small);
    EXPECT_EQ(of_line(7, "bounds = { box = [[0, 0, 0], [1e-20, 0.75e-20, \"max(0, 1 - t) + "
                         "1e-20\"]] }"),
              ": surface.bounds.box.min.x at t = 2: bounds of radius 8e-21" + small);
    EXPECT_EQ(of_line(7, "bounds = { box = [[0, 0, 0], [1e-20, 1e-20, 1]] }"), "nothing is wrong");
}

TEST_F(Range, Lights) {
    EXPECT_EQ(at_two(ball_and("[[lights]]\ndirection = [0, 0, 1]\n"
                              "[[lights]]\ndirection = [0, 0, \"2 - t\"]")),
              "18: lights[1].direction.x at t = 2: the direction to the light has length 0");
}

// One value that is no number any more is blamed, and not what comes of it.
TEST_F(Range, NotANumber) {
    const std::string nan = " at t = 2: the value is not a number";
    for (const std::string text : {"\"1 + log(1 - t)\"", "\"(2 - t)/(4 - 2*t)\""}) {
        EXPECT_EQ(of_line(9, "radius = " + text), ": parameters.radius" + nan);
        EXPECT_EQ(of_line(7, "bounds = { sphere = 1, centre = [0, " + text + ", 0] }"),
                  ": surface.bounds.centre.y" + nan);
        EXPECT_EQ(bounds_and("transform = { translate = [" + text + ", 0, 0] }"),
                  ": surface.transform.translate.x" + nan);
        EXPECT_EQ(bounds_and("transform = { rotate = [" + text + ", 0, 0] }"),
                  ": surface.transform.rotate.x" + nan);
        EXPECT_EQ(of_line(11, "position = [4, 0, " + text + "]"), ": camera.position.z" + nan);
        EXPECT_EQ(of_line(12, "up = [0, 1, " + text + "]"), ": camera.up.z" + nan);
        EXPECT_EQ(of_line(12, "fov = " + text), ": camera.fov" + nan);
        EXPECT_EQ(at_two(ball_and("[material]\ncolor = [1, 1, " + text + "]")),
                  "16: material.color.z" + nan);
        EXPECT_EQ(
            at_two(ball_and("[[lights]]\ndirection = [0, 0, 1]\ncolor = [1, 1, " + text + "]")),
            "17: lights[0].color.z" + nan);
        // One value for all elements; below, one for each.
        EXPECT_EQ(at_two(blobs("count = 3\nw = 1\ncx = " + text)), "7: arrays.blobs.cx" + nan);
    }
    EXPECT_EQ(at_two(blobs("count = 3\nw = 1\ncx = \"log(3.5 - t - i)\"")),
              "7: arrays.blobs.cx[2]" + nan);
}

// A float on the GPU would be infinite.
TEST_F(Range, TooLargeForAFloat) {
    const std::string large = " at t = 2: the value 1e+39 is beyond the range of float (3.4e+38)";
    EXPECT_EQ(of_line(9, "radius = { keys = [[0, 1], [1, 1e39]] }"), ": parameters.radius" + large);
    EXPECT_EQ(of_line(9, "radius = { keys = [[0, 1], [1, 3e38]] }"), "nothing is wrong");
    EXPECT_EQ(at_two(blobs("count = 2\nw = 1\ncx = \"max(0, t - 1)*1e39*i\"")),
              "7: arrays.blobs.cx[1]" + large);
    EXPECT_EQ(
        of_line(9, "radius = \"1/(2 - t)\""),
        ": parameters.radius at t = 2: the value 1e+300 is beyond the range of float (3.4e+38)");
}

// At the first frame the scene doesn't even load.
TEST_F(Range, WrongFromTheStart) {
    EXPECT_EQ(mistake(ball_with(7, "bounds = { sphere = \"t\" }")),
              "scene.toml:7: surface.bounds.sphere at t = 0: the radius must be above 0, not 0");
    EXPECT_EQ(mistake(ball_with(12, "fov = 200")),
              "scene.toml:12: camera.fov at t = 0: must be above 0 and below 180, not 200");
}

} // namespace
} // namespace isomotion::scene
