// A window that shrinks, vanishes or loses its display ends nothing that it should not.
#include "playing.h"

#include <chrono>
#include <csignal>
#include <thread>

namespace isomotion::player {
namespace {

class WindowTest : public Playing {
protected:
    bool window(std::vector<std::string> words) {
        words.insert(words.begin(), {"search", "--name", "isomotion"});
        return display().drive(words);
    }
};

TEST_F(WindowTest, FollowsItsSize) {
    play({"sphere.toml"});
    await("a picture", [](const Json& l) { return l.contains("frame"); });
    EXPECT_TRUE(window({"windowsize", "1", "1"}));
    const auto height = [](const Json& l) { return l.contains("size") ? int(l["size"][1]) : 0; };
    for (const bool large : {false, true, false}) {
        SCOPED_TRACE(large);
        mark();
        EXPECT_TRUE(large ? window({"windowsize", "900", "690"})
                          : window({"windowsize", "500", "330"}));
        await("a picture of that size", [&](const Json& l) {
            return large ? height(l) > 500 : 0 < height(l) && height(l) < 330;
        });
    }
    quit();
}

TEST_F(WindowTest, OutlivesBeingHidden) {
    play({"sphere.toml"});
    await("a picture", [](const Json& l) { return l.contains("frame"); });
    EXPECT_TRUE(window({"windowunmap", "--sync"}));
    EXPECT_TRUE(window({"windowmap", "--sync", "windowfocus", "--sync"}));
    mark();
    await("a picture", [](const Json& l) { return l.contains("frame"); });
    quit();
}

// The window is another one then; scene, frame and what is held are as they were.
TEST_F(WindowTest, GoesOnAfterTheDriverIsReset) {
    const std::string when = (*this / "reset").string();
    play({"--paused", "sphere.toml"}, {{"LD_PRELOAD", RESETTING_DRIVER}, {"RESET_WHEN", when}});
    await_rest("a picture");
    key("End");
    const Json before =
        await_rest("the last frame", [](const Json& l) { return l["frame"] == 64; });
    // Resets at once are not survived: a driver that does nothing else would never be left alone.
    std::this_thread::sleep_for(std::chrono::milliseconds(2100));
    mark();
    write("reset", "");
    key("Left");
    await("the reset", [](const Json& l) {
        return l.contains("error") && l["error"] == "the graphics driver was reset";
    });
    EXPECT_FALSE(std::filesystem::exists(when));
    const Json after = await_rest("a picture", [](const Json& l) { return l["frame"] == 63; });
    EXPECT_EQ(after["verdicts"].size(), before["verdicts"].size());
    EXPECT_TRUE(window({"windowfocus", "--sync"}));
    quit();
}

TEST_F(WindowTest, EndsWhenTheDriverIsResetAtOnce) {
    const std::string when = (*this / "reset").string();
    write("reset", "");
    const cli::Ending end =
        cli::run({cli::tested_program(ISOMOTION_PROGRAM), "play", "--forget", "sphere.toml"},
                 {.folder = *this / "",
                  .environment = {{"DISPLAY", display().name()},
                                  {"ISOMOTION_DATA", ISOMOTION_SOURCE_DIR},
                                  {"LD_PRELOAD", RESETTING_DRIVER},
                                  {"RESET_WHEN", when}}});
    EXPECT_EQ(end.code, 3);
    EXPECT_THAT(end.err, testing::HasSubstr("the graphics driver was reset"));
}

TEST_F(WindowTest, GoesToFullScreenAndBack) {
    play({"--paused", "sphere.toml"});
    EXPECT_TRUE(window({"windowsize", "480", "480"}));
    const auto height = [](const Json& line) { return line["size"][1].get<int>(); };
    const Json before =
        await_rest("a small picture", [&](const Json& l) { return height(l) < 260; });
    mark();
    key("F11");
    await_rest("a large picture", [&](const Json& l) { return height(l) > 320; });
    mark();
    key("F11");
    const Json again =
        await_rest("a small picture", [&](const Json& l) { return height(l) < 260; });
    EXPECT_EQ(again["size"], before["size"]);
    quit();
}

void expect_told(const cli::Ending& end) {
    EXPECT_EQ(end.code, 3) << end;
    EXPECT_THAT(end.err, testing::HasSubstr("the display is gone")) << end;
}

TEST_F(WindowTest, TellsThatItsWindowWasKilled) {
    play({"sphere.toml"});
    await("a picture", [](const Json& l) { return l.contains("frame"); });
    EXPECT_TRUE(window({"windowkill"}));
    expect_told(ending());
}

TEST_F(WindowTest, TellsThatTheDisplayEnded) {
    play({"sphere.toml"});
    await("a picture", [](const Json& l) { return l.contains("frame"); });
    display().end();
    expect_told(ending());
}

} // namespace
} // namespace isomotion::player
