// What is played, stepped and scrubbed is what is shown; what rests costs nothing.
#include "playing.h"

#include <chrono>
#include <cmath>
#include <thread>

#include "image/decode.h"
#include "player/draw/views.h"

namespace isomotion::player {
namespace {

using testing::ElementsAreArray;
using testing::HasSubstr;

std::function<bool(const Json&)> shows_frame(int frame) {
    return [frame](const Json& line) { return line.value("frame", 0) == frame; };
}

TEST_F(Playing, ShowsAtRestWhatRenderWritesPixelByPixel) {
    play({"--paused", "sphere.toml"});
    for (int k = 0; k < 4; ++k) key("Right");
    const Json line = await_rest("frame 5", shows_frame(5));
    const int width = line["size"][0], height = line["size"][1];
    ASSERT_GE(width, 200);
    ASSERT_EQ(line["samples"], 16);
    const cli::Ending rendered =
        run({"render", "sphere.toml", "--frames", "5", "--set", "output.samples=16", "--size",
             std::to_string(width) + "x" + std::to_string(height), "-o", "frame.png"});
    ASSERT_EQ(rendered.code, 0) << rendered;
    // The cursor is on the screen too.
    EXPECT_TRUE(display().drive({"mousemove", std::to_string(Display::width - 1), "0"}));
    const auto codes = shaded(image::decode(*this / "frame.png")).rgba;
    const auto differing = [&] {
        const auto shown = picture(line);
        int count = 0;
        for (std::size_t k = 0; k < shown.size(); ++k) {
            for (std::size_t c = 0; c < 3; ++c) count += shown[k][c] != codes[4 * k + c];
        }
        return count;
    };
    EXPECT_TRUE(screen_comes_to([&] { return differing() == 0; }))
        << differing() << " codes differ";
}

TEST_F(Playing, PlaysUntilPausedAndThenDoesNothing) {
    play({"sphere.toml"});
    await("some frame", [](const Json& line) { return line.value("frame", 0) > 10; });
    mark(); // beyond frame 10: an earlier one is of the next round
    await("the next round", [](const Json& line) { return line.value("frame", 99) <= 10; });
    mark();
    key("space");
    const Json rest = await_rest("a pause");
    await("its audit", [](const Json& line) { return line.contains("audited"); });
    // Until what is left of the last frames and events is done.
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    const double before = cpu_seconds();
    const std::size_t lines = log().size();
    std::this_thread::sleep_for(std::chrono::seconds(3));
    EXPECT_LE(cpu_seconds() - before, 0.03) << "in 3 s";
    EXPECT_EQ(log().size(), lines);
    mark();
    key("space");
    await("playing again", [&](const Json& line) {
        return line.contains("frame") && line["frame"] != rest["frame"];
    });
    quit();
}

TEST_F(Playing, AuditsThePictureAtRest) {
    play({"--paused", "sphere.toml"});
    const auto audit = [](const Json& line) { return line.contains("audited"); };
    const Json right = await("an audit", audit);
    EXPECT_GE(right["audited"], 64);
    EXPECT_EQ(right["wrong"], 0);
    EXPECT_TRUE(right["wrong_pixels"].empty());
    // What is wrong is told by its pixels, and what changes is audited anew.
    write("sphere.toml", growing_sphere("max(x^2 + y^2 + z^2 - 1 - 0*r, 0.02 - abs(x - y))") +
                             "[isolation]\nmethod = \"marching\"\nstep = 0.5\n");
    const Json wrong =
        await("wrong rays", [&](const Json& line) { return audit(line) && line["wrong"] > 0; });
    ASSERT_FALSE(wrong["wrong_pixels"].empty());
    const int width = await_rest("the picture")["size"][0];
    for (const Json& pixel : wrong["wrong_pixels"]) EXPECT_LT(pixel[0], width);
    quit();
}

TEST_F(Playing, StepsJumpsAndScrubs) {
    play({"--paused", "sphere.toml"});
    await_rest("the first frame", shows_frame(1));
    key("Left"); // it loops
    await_rest("the last frame", shows_frame(64));
    mark();
    key("Home");
    await_rest("the first frame", shows_frame(1));
    key("End");
    await_rest("the last frame", shows_frame(64));
    mark();
    drag(place_of("timeline", 0.2), place_of("timeline", 0.5));
    const Json middle = await_rest("what was scrubbed to");
    EXPECT_NEAR(middle["frame"].get<int>(), 32.5, 1.5);
    mark();
    key("Right");
    await_rest("a frame on", shows_frame(middle["frame"].get<int>() + 1));
    quit();
}

TEST_F(Playing, SaysWhatToDoWithoutADisplay) {
    const cli::Ending end = cli::run(
        {cli::tested_program(ISOMOTION_PROGRAM), "play", "sphere.toml"},
        {.folder = *this / ".",
         .environment = {
             {"DISPLAY", {}}, {"WAYLAND_DISPLAY", {}}, {"ISOMOTION_DATA", ISOMOTION_SOURCE_DIR}}});
    EXPECT_EQ(end.code, 3) << end;
    EXPECT_THAT(end.err, HasSubstr("no display"));
    EXPECT_THAT(end.err, HasSubstr("isomotion render"));
}

TEST_F(Playing, SaysWhatIsWrongInASceneWhereItWasCalled) {
    write("wrong.toml", growing_sphere("x^2 + y^2 + z^2 - q"));
    const cli::Ending end = cli::run(
        {cli::tested_program(ISOMOTION_PROGRAM), "play", "wrong.toml"},
        {.folder = *this / ".",
         .environment = {{"DISPLAY", display().name()}, {"ISOMOTION_DATA", ISOMOTION_SOURCE_DIR}}});
    EXPECT_EQ(end.code, 2) << end;
    EXPECT_THAT(end.err, HasSubstr("wrong.toml:7: surface.formula: "));
}

} // namespace
} // namespace isomotion::player
