// Which files a scene may name, and what lies in place of files.
#include "testing.h"

#include <fstream>

#include <sys/stat.h>

#include <fmt/format.h>

#include "base/fingerprint.h"
#include "base/printable.h"
#include "base/regular_file.h"
#include "scene/limits.h"
#include "scene/source_print.h"

namespace isomotion::scene {
namespace {

namespace fs = std::filesystem;
using testing::AnyOf;
using testing::ContainsRegex;
using testing::HasSubstr;

std::string blobs_of(const std::string& file) {
    return "[surface]\nformula = \"sum(blobs, exp(-4*((x-cx)^2 + y^2 + z^2))) - 0.5\"\n"
           "bounds = { sphere = 3 }\n[arrays.blobs]\nfile = \"" +
           file + "\"\n";
}

std::string with_map(const std::string& file) {
    return ball_and("[environment]\nmap = \"" + file + "\"");
}

// A scene in scenes/ of the folder, which is not its own: outside.csv and outside.exr lie there.
class Outside : public Scenes {
protected:
    Outside() {
        fs::create_directories(folder() / "scenes" / "below");
        fs::create_directories(folder() / "media");
        for (const char* table : {"outside.csv", "scenes/own.csv", "scenes/below/own.csv",
                                  "animations/own.csv", "scenes2.csv"}) {
            write(table, "cx\n0\n");
        }
        for (const char* map : {"outside.exr", "media/sky.exr"}) write(map, "");
    }

    std::string mistake_in_folder(const std::string& text, Reach reach = Reach::own_folder) {
        try {
            load(write("scenes/scene.toml", text).string(), {}, reach);
            return "nothing is wrong";
        } catch (const SceneError& error) {
            return error.what();
        }
    }
};

TEST_F(Outside, IsNamedInNoWay) {
    fs::create_symlink(folder() / "outside.csv", folder() / "scenes" / "link.csv");
    fs::create_directory_symlink(folder(), folder() / "scenes" / "up");
    fs::create_directory_symlink(folder() / "scenes" / "below", folder() / "scenes" / "down");
    for (const std::string& file :
         {std::string("../outside.csv"), std::string("below/../../outside.csv"),
          "/" + folder().string() + "/outside.csv", folder().string() + "/outside.csv",
          folder().string() + "//outside.csv", std::string("link.csv"),
          std::string("up/outside.csv"), std::string("down/../../outside.csv"),
          std::string("../scenes2.csv")}) {
        EXPECT_THAT(mistake_in_folder(blobs_of(file)),
                    AllOf(HasSubstr("scene.toml:5: arrays.blobs.file: "),
                          HasSubstr("lies outside the scene's folder; move it there, or allow such "
                                    "files with --allow-outside")))
            << file;
        EXPECT_EQ(mistake_in_folder(blobs_of(file), Reach::anywhere), "nothing is wrong") << file;
    }
    EXPECT_THAT(mistake_in_folder(with_map("../outside.exr")),
                HasSubstr("environment.map: " + (folder() / "scenes/../outside.exr").string() +
                          " lies outside"));
    // From the program's media/, too, no way leads out.
    EXPECT_THAT(mistake_in_folder(with_map("../shaders/../outside.exr")),
                HasSubstr("lies outside"));
}

TEST_F(Outside, IsNotWhatLiesInTheFolderOrComesWithTheProgram) {
    fs::create_directory_symlink(folder() / "scenes" / "below", folder() / "scenes" / "down");
    for (const std::string& file :
         {std::string("own.csv"), std::string("./own.csv"), std::string("below/own.csv"),
          std::string("below/../own.csv"), std::string("down/own.csv"),
          std::string("../scenes/own.csv"), (folder() / "scenes" / "own.csv").string(),
          std::string("../animations/own.csv")}) {
        EXPECT_EQ(mistake_in_folder(blobs_of(file)), "nothing is wrong") << file;
    }
    EXPECT_EQ(mistake_in_folder(with_map("sky.exr")), "nothing is wrong");
}

TEST_F(Outside, IsASceneInTheCurrentFolder) {
    const fs::path before = fs::current_path();
    write("scenes/scene.toml", blobs_of("../outside.csv"));
    write("scenes/other.toml", blobs_of("own.csv"));
    fs::current_path(folder() / "scenes");
    EXPECT_THROW(load("scene.toml"), SceneError);
    EXPECT_NO_THROW(load("other.toml"));
    fs::current_path(before);
}

TEST_F(Outside, IsWhatTheUserNames) {
    const std::string file = write("scenes/scene.toml", blobs_of("own.csv")).string();
    const std::string outside = (folder() / "outside.csv").string();
    EXPECT_NO_THROW(load(file, {"arrays.blobs.file=\"" + outside + "\""}));
}

// What was looked at when the scene was read is another file when it is opened.
TEST_F(Outside, IsNotReadThroughALinkMadeMeanwhile) {
    write("scenes/map.exr", "");
    for (int frame = 1; frame <= 9; ++frame)
        write(fmt::format("scenes/p.{}.csv", frame), fmt::format("cx\n{}\n", frame));
    write("outside.csv", "cx\n77\n");
    const auto file =
        write("scenes/scene.toml", blobs_of("p.#.csv") + "[time]\nfps = 10\nframes = 9\n"
                                                         "[environment]\nmap = \"map.exr\"\n");
    const auto with_links = [&](const Scene& scene) {
        for (const char* name : {"p.2.csv", "p.3.csv", "map.exr"}) {
            fs::remove(folder() / "scenes" / name);
            fs::create_symlink(std::string("../outside") + fs::path(name).extension().string(),
                               folder() / "scenes" / name);
        }
        return scene;
    };
    const std::string text = file.string();
    const auto refusal = HasSubstr("lies outside the scene's folder");
    const Scene scene = with_links(load(text));
    EXPECT_EQ(scene.surfaces[0].animation.at(scene.timeline.time(1)).arrays[0].fields[0].front(),
              1);
    for (const int frame : {2, 3}) { // no longer in memory
        EXPECT_THAT([&] { scene.surfaces[0].animation.at(scene.timeline.time(frame)); },
                    testing::ThrowsMessage<SceneError>(refusal));
    }
    EXPECT_THAT([&] { base::RegularFile(scene.environment->map, scene.environment->within); },
                testing::ThrowsMessage<SceneError>(refusal));
    base::Fingerprint print;
    EXPECT_THROW(add_array(print, scene.surfaces[0].animation, 0), SceneError);

    // Whoever allows others has them.
    write("scenes/own.csv", "");
    const Scene free = load(text, {}, Reach::anywhere);
    EXPECT_EQ(free.surfaces[0].animation.at(free.timeline.time(2)).arrays[0].fields[0].front(), 77);
    EXPECT_NO_THROW(base::RegularFile(free.environment->map, free.environment->within));
}

// The folder whose files a scene may name is the one in which the scene was read.
TEST_F(Outside, IsAFolderThatTakesTheNameOfTheScenes) {
    fs::create_directories(folder() / "private");
    write("private/map.exr", "");
    write("scenes/map.exr", "");
    write("scenes/scene.toml", with_map("map.exr"));
    fs::create_directory_symlink("scenes", folder() / "link");
    const Scene scene = load((folder() / "link/scene.toml").string());
    EXPECT_NO_THROW(base::RegularFile(scene.environment->map, scene.environment->within));
    fs::remove(folder() / "link");
    fs::create_directory_symlink("private", folder() / "link");
    EXPECT_THROW(base::RegularFile(scene.environment->map, scene.environment->within), SceneError);
}

TEST_F(Outside, SurfacesAreNamesOfTheCatalogue) {
    write("outside.toml", "formula = \"x\"\nbounds = { sphere = 1 }\n");
    for (const char* name :
         {"../../outside", "../surfaces/../../outside", "/etc/passwd", "", "a\\u0000b", "."}) {
        EXPECT_THAT(mistake_in_folder(std::string("[surface]\nuse = \"") + name + "\"\n"),
                    HasSubstr("surface.use: there is no surface"))
            << name;
    }
}

TEST_F(Outside, IsNoFile) {
    ASSERT_EQ(::mkfifo((folder() / "scenes" / "pipe").c_str(), 0600), 0);
    fs::create_symlink("/dev/zero", folder() / "scenes" / "zero");
    fs::create_symlink("loop", folder() / "scenes" / "loop");
    for (const char* file : {"pipe", "zero", "below", "", ".", "/dev/zero", "loop", "none.csv",
                             "own.csv\\u0000.txt"}) {
        for (const Reach reach : {Reach::own_folder, Reach::anywhere}) {
            const auto refused = [](const std::string& key) {
                return AnyOf(HasSubstr(key + ": there is no file"),
                             ContainsRegex(key + ": .* is a pipe or a device"));
            };
            EXPECT_THAT(mistake_in_folder(blobs_of(file), reach), refused("arrays.blobs.file"))
                << file;
            EXPECT_THAT(mistake_in_folder(with_map(file), reach), refused("environment.map"))
                << file;
        }
    }
}

TEST_F(Scenes, AreRegularFiles) {
    ASSERT_EQ(::mkfifo((folder() / "pipe.toml").c_str(), 0600), 0);
    fs::create_symlink("/dev/zero", folder() / "zero.toml");
    EXPECT_EQ(mistake_of_name((folder() / "pipe.toml").string()),
              "pipe.toml: is a pipe or a device; name a regular file");
    EXPECT_EQ(mistake_of_name((folder() / "zero.toml").string()),
              "zero.toml: is a pipe or a device; name a regular file");
    EXPECT_THAT(mistake_of_name(folder().string()), HasSubstr("is a folder"));
    ::chmod(write("shut.toml", ball()).c_str(), 0);
    if (::geteuid() != 0) { // root may read it all the same
        EXPECT_THAT(mistake_of_name((folder() / "shut.toml").string()),
                    HasSubstr("shut.toml: cannot be read: Permission denied"));
    }
}

TEST_F(Scenes, ArePrinted) {
    for (const auto& [text, shown] :
         {std::pair<std::string, std::string>{"plain, ä, 形, 🎥\n\ttext\r\n",
                                              "plain, ä, 形, 🎥\n\ttext\n"},
          {"\x1b[31mred\x07", "\uFFFD[31mred\uFFFD"},
          {"over\rwritten", "over\uFFFDwritten"},
          {std::string("\0end", 4), "\uFFFDend"},
          {"\x7f\xc2\x9b", "\uFFFD\uFFFD"},                           // DEL, a CSI of one character
          {"\xe2\x80\xae", "\uFFFD"},                                 // right to left from here on
          {"\xff\xc0\xaf\xe2\x82", "\uFFFD\uFFFD\uFFFD\uFFFD\uFFFD"}, // no UTF-8
          {"\xed\xa0\x80", "\uFFFD\uFFFD\uFFFD"}}) {                  // half of a character
        EXPECT_EQ(base::printable(text), shown);
        EXPECT_EQ(base::is_one_printable_line(text), false);
    }
    EXPECT_TRUE(base::is_one_printable_line("ä, 形, 🎥"));
}

// Whatever a scene calls things, what is said about it is text, and of one line but for a
// formula's.
TEST_F(Scenes, HaveMistakesThatAreTold) {
    for (const std::string& text :
         {ball_and("\"evil\\u001b]0;title\\u0007\\n/etc/passwd:1: \" = 1"),
          ball_and("[output.\"\\u001b[2J\\n\"]"), ball_with(1, "title = \"\\u001b[2J\""),
          ball_with(9, "radius = \"1 + \\u001b[2J\""), ball_with(9, "radius = 1\n\"a\\nb\" = 2"),
          ball_with(6, "formula = \"x + \\u009b\\r\""), ball_with(6, "use = \"\\u001b[2J\\n\"")}) {
        const std::string message = mistake(text);
        EXPECT_THAT(message, testing::StartsWith("scene.toml:")) << message;
        EXPECT_EQ(base::printable(message), message);
        EXPECT_EQ(message.find("\n/etc"), message.npos) << message;
    }
}

} // namespace
} // namespace isomotion::scene
