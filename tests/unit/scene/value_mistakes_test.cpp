// Values of the wrong type, or out of their range.
#include "testing.h"

namespace isomotion::scene {
namespace {

constexpr const char* moving_number =
    "must be a number, an expression in t (\"2 + sin(t)\"), or { keys = [[t, value], ...], ease = "
    "\"smooth\" }";
constexpr const char* moving_vector = "must be [x, y, z] or { keys = [[t, [x, y, z]], ...] }";

constexpr const char* moving_color =
    "must be [r, g, b], linear ([1, 0, 0] is red), or { keys = [[t, [r, g, b]], ...] }";

constexpr const char* background =
    "output.background: must be [r, g, b] (linear), { top = [r, g, b], bottom = [r, g, b] } or "
    "\"transparent\"";

class ValueMistakes : public Scenes {
protected:
    // Line `number` of the ball becomes `line`; the rest of the message follows the place.
    void expect(int number, const std::string& line, const std::string& message) const {
        EXPECT_EQ(mistake(ball_with(number, line)),
                  "scene.toml:" + std::to_string(number) + ": " + message)
            << line;
    }
    // The same for the line below a new section's header, line 16.
    void expect_in(const std::string& section, const std::string& line,
                   const std::string& message) const {
        EXPECT_EQ(mistake(ball_and("[" + section + "]\n" + line)),
                  "scene.toml:16: " + section + "." + message)
            << line;
    }
};

TEST_F(ValueMistakes, WrongTypes) {
    expect(1, "title = 3", "title: must be a text in quotes");
    expect(4, "frames = \"many\"", "time.frames: must be an integer");
    expect(4, "frames = 2.5", "time.frames: must be an integer");
    expect(6, "formula = 3", "surface.formula: must be a text in quotes");
    expect(6, "use = [\"sphere\"]", "surface.use: must be a text in quotes");
    expect(7, "bounds = { sphere = [1, 2] }",
           "surface.bounds.sphere: " + std::string(moving_number));
    expect(9, "radius = true", "parameters.radius: " + std::string(moving_number));
    expect(9, "radius = [1, 2]", "parameters.radius: " + std::string(moving_number));
    expect(9, "radius = 1979-05-27", "parameters.radius: " + std::string(moving_number));
    expect(12, "fov = false", "camera.fov: " + std::string(moving_number));
    expect(11, "position = 4", "camera.position: " + std::string(moving_vector));
    expect(11, "position = \"[4, 0, t]\"", "camera.position: " + std::string(moving_vector));
    expect(11, "position = [4, 0]", "camera.position: must have three components: [x, y, z]");
    expect(11, "position = [4, 0, 1, 1]", "camera.position: must have three components: [x, y, z]");
    expect(11, "position = [4, [0], 1]", "camera.position.y: " + std::string(moving_number));
    expect_in("isolation", "method = 3", "method: must be a text in quotes");
    expect_in("isolation", "step = \"small\"", "step: must be a number");
    expect_in("isolation", "bisections = 2.0", "bisections: must be an integer");
    expect_in("material", "color = \"red\"", "color: " + std::string(moving_color));
    expect(14, "background = \"white\"", background);
    expect(14, "background = [1, 2]", background);
    expect(14, "background = [1, 1, \"t\"]", "output.background: must be a number");
}

TEST_F(ValueMistakes, OutOfRange) {
    expect(4, "frames = 0", "time.frames: must be from 1 to 10000000, not 0");
    expect(4, "frames = 10000001", "time.frames: must be from 1 to 10000000, not 10000001");
    expect(4, "seed = -1", "time.seed: must be from 0 to 2147483647, not -1");
    expect_in("isolation", "step = 0", "step: must be from 1e-30 to 1e+30, not 0");
    expect_in("isolation", "step = -0.5", "step: must be from 1e-30 to 1e+30, not -0.5");
    expect_in("isolation", "near = -1", "near: must be from 0 to 1e+30, not -1");
    expect_in("isolation", "far = -1", "far: must be from 0 to 1e+30, not -1");
    expect_in("isolation", "horizon = -1", "horizon: must be from 0 to 1e+30, not -1");
    expect_in("isolation", "bisections = 65", "bisections: must be from 0 to 64, not 65");
    expect_in("isolation", "limit = 0", "limit: must be from 1 to 10000000, not 0");
    expect_in("isolation", "method = \"newton\"",
              "method: there is no method 'newton'; known: marching, amp-sign, amp-taylor, "
              "hermite, interval, affine, sphere");
}

TEST_F(ValueMistakes, FrameRates) {
    for (const char* fps : {"0", "-30", "0.0", "\"0\"", "\"30/0\"", "\"1/0\"", "\"abc\"", "\"\"",
                            "true", "[30]", "\"30 fps\"", "23.97602397602398", "1e-12"}) {
        expect(3, std::string("fps = ") + fps,
               "time.fps: must be above 0: 30, 23.976 (up to nine decimals) or \"30000/1001\"");
    }
    expect(3, "fps = nan", "time.fps: must be finite");
    expect(3, "fps = inf", "time.fps: must be finite");
}

TEST_F(ValueMistakes, Sizes) {
    for (const char* size : {"[0, 64]", "[64, 0]", "[-1, 64]", "[100000, 64]", "[64, 16385]", "64",
                             "[64]", "[64, 64, 3]", "[64.0, 64]", "\"64x64\"", "[]"}) {
        expect(14, std::string("size = ") + size,
               "output.size: must be [width, height], integers from 1 to 16384");
    }
    EXPECT_EQ(loaded(ball_with(14, "size = [16384, 1]")).output.width, 16384);
}

TEST_F(ValueMistakes, NotFinite) {
    for (const std::string number : {"nan", "-nan", "inf", "-inf"}) {
        expect(9, "radius = " + number, "parameters.radius: must be finite");
        expect(7, "bounds = { sphere = " + number + " }", "surface.bounds.sphere: must be finite");
        expect(11, "position = [4, " + number + ", 0]", "camera.position.y: must be finite");
        expect(12, "fov = { keys = [[0, " + number + "]] }", "camera.fov.keys[0]: must be finite");
        expect(12, "fov = { keys = [[0, 1], [" + number + ", 2]] }",
               "camera.fov.keys[1]: must be finite");
        expect(14, "background = [0, 0, " + number + "]", "output.background: must be finite");
        expect_in("isolation", "near = " + number, "near: must be finite");
    }
}

TEST_F(ValueMistakes, Keyframes) {
    expect(9, "radius = { keys = [[0, 1], [2, 1], [1, 3]] }",
           "parameters.radius.keys[2]: times must ascend: 1 comes after 2");
    expect(9, "radius = { keys = [[0, 1], [0, 2]] }",
           "parameters.radius.keys[1]: times must ascend: 0 comes after 0");
    expect(9, "radius = { keys = [[0, 1], 2] }",
           "parameters.radius.keys[1]: must be [time, value]");
    expect(9, "radius = { keys = [[0, 1, 2]] }",
           "parameters.radius.keys[0]: must be [time, value]");
    expect(9, "radius = { keys = [[0, \"t\"]] }", "parameters.radius.keys[0]: must be a number");
    expect(9, "radius = { keys = [[\"0\", 1]] }", "parameters.radius.keys[0]: must be a number");
    expect(9, "radius = { keys = 3 }",
           "parameters.radius: needs keys = [[t, value], ...], at least one");
    for (const char* ease : {"\"bouncy\"", "\"Linear\"", "3", "\"\""}) {
        expect(9, std::string("radius = { keys = [[0, 1]], ease = ") + ease + " }",
               "parameters.radius.ease: must be one of linear, smooth, hold, cubic");
    }
    expect(11, "position = { keys = [[0, 1]] }",
           "camera.position.keys[0]: must be [time, [x, y, z]]");
    expect(11, "position = { keys = [[0, [1, 2]]] }",
           "camera.position.keys[0]: must be [time, [x, y, z]]");
    expect(11, "position = { keys = [[0, [4, 2, \"t\"]]] }",
           "camera.position.keys[0]: must be a number");
    expect(11, "position = { keys = [[1, [4, 2, 0]], [0, [4, 2, 1]]] }",
           "camera.position.keys[1]: times must ascend: 0 comes after 1");
}

// The line is that of the key, also where a value goes over several.
TEST_F(ValueMistakes, InValuesOfSeveralLines) {
    EXPECT_EQ(mistake(ball_with(9, "radius = { keys = [\n[0, 1],\n[2, 1],\n[1, 3]\n] }")),
              "scene.toml:12: parameters.radius.keys[2]: times must ascend: 1 comes after 2");
    EXPECT_EQ(mistake(ball_with(11, "position = [\n4,\n0,\ntrue]")),
              "scene.toml:14: camera.position.z: " + std::string(moving_number));
}

TEST_F(ValueMistakes, Boxes) {
    const auto expect_box = [&](const std::string& box, const std::string& message) {
        expect(7, "bounds = { box = " + box + " }", "surface.bounds.box" + message);
    };
    for (const char* box : {"3", "[[1, 1, 1]]", "[[0, 0, 0], [1, 1, 1], [2, 2, 2]]", "\"1\""}) {
        expect_box(box, ": must be two corners: [[x0, y0, z0], [x1, y1, z1]]");
    }
    expect_box("[-1, 1]", "[0]: " + std::string(moving_vector));
    expect_box("[[-1, -1, -1], [1, 1]]", "[1]: must have three components: [x, y, z]");
    expect_box("[[-1, -1, -1], [1, false, 1]]", "[1].y: " + std::string(moving_number));
}

} // namespace
} // namespace isomotion::scene
