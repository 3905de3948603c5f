#include <fstream>

#include "scene/data_folder.h"
#include "testing.h"

namespace isomotion::scene {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class Files : public Scenes {};

TEST_F(Files, AreFoundByPath) {
    const fs::path file = write("shaders/ball.toml", ball());
    EXPECT_EQ(load(file.string()).title, "A ball");
    EXPECT_EQ(load(file.string()).file, file);
}

TEST_F(Files, OfTheGalleryAreFoundByName) {
    write("animations/ball.toml", ball());
    const Scene scene = load("ball");
    EXPECT_EQ(scene.title, "A ball");
    EXPECT_EQ(scene.file, folder() / "animations" / "ball.toml");
}

TEST_F(Files, MissingOrNoFiles) {
    const std::string path = folder().string();
    EXPECT_EQ(mistake_of_name(path + "/none.toml"), "none.toml: no such file");
    EXPECT_EQ(mistake_of_name("none.toml"), "none.toml: no such file");
    EXPECT_EQ(mistake_of_name("no/where"), "no/where: no such file");
    EXPECT_EQ(mistake_of_name(path + "/shaders"),
              "shaders: is a folder; name a scene file (.toml)");
}

TEST_F(Files, UnknownNamesAreToldTheNearestOrAll) {
    write("animations/blobby75.toml", ball());
    write("animations/melting.toml", ball());
    write("animations/notes.txt", "no scene");
    EXPECT_EQ(mistake_of_name("bloby75"),
              "bloby75: no such file, and no animation of this name; did you mean 'blobby75'?");
    EXPECT_EQ(mistake_of_name("quite_unlike"),
              "quite_unlike: no such file, and no animation of this name; isomotion list names the "
              "2 that there are");
    EXPECT_EQ(mistake_of_name("rho - 1"),
              "rho - 1: no such file, and no animation of this name; a formula of one side has a 0 "
              "on the other: 'rho - 1 = 0'");
    EXPECT_THAT(mistake_of_name("x % 2"), HasSubstr("unexpected"));
    for (const char* solid : {"x < y", "x > 0"})
        EXPECT_EQ(mistake_of_name(solid), "nothing is wrong") << solid;
}

TEST_F(Files, ThatAreNotTomlAreToldTheLine) {
    EXPECT_THAT(mistake(ball_with(10, "[camera")), StartsWith("scene.toml:10: not valid TOML: "));
    EXPECT_THAT(mistake(ball_with(4, "frames = = 3")),
                StartsWith("scene.toml:4: not valid TOML: "));
    EXPECT_THAT(mistake(ball_with(9, "radius = 1\nradius = 2")),
                StartsWith("scene.toml:10: not valid TOML: "));
    EXPECT_THAT(mistake(ball_with(9, "radius = 2*t")),
                StartsWith("scene.toml:9: not valid TOML: "));
    EXPECT_THAT(mistake(ball_and("[camera]")), StartsWith("scene.toml:15: not valid TOML: "));
    EXPECT_THAT(mistake(ball_with(1, "title = \"\xff\"")),
                StartsWith("scene.toml:1: not valid TOML: "));
}

TEST_F(Files, WithLineEndsOfOtherSystemsAreRead) {
    std::string text = ball();
    for (auto at = text.find('\n'); at != text.npos; at = text.find('\n', at + 2)) {
        text.replace(at, 1, "\r\n");
    }
    EXPECT_EQ(loaded(text).title, "A ball");
    text.replace(text.find("fov"), 3, "fob");
    EXPECT_EQ(mistake(text), "scene.toml:12: camera.fob: unknown key; did you mean 'fov'?");
    EXPECT_EQ(loaded("\xEF\xBB\xBF" + ball()).title, "A ball");
}

TEST_F(Files, TheDataFolderIsWhereTheEnvironmentSays) {
    EXPECT_EQ(data_folder(), folder());
    write("animations/b.toml", "");
    write("animations/a.toml", "");
    surface("s", "");
    EXPECT_THAT(animation_names(), ElementsAre("a", "b"));
    EXPECT_THAT(surface_names(), ElementsAre("s"));
}

TEST_F(Files, ADataFolderWithoutDataIsToldWithItsName) {
    fs::remove(folder() / "shaders");
    const std::string message = mistake_of_name("ball");
    EXPECT_THAT(message, AllOf(HasSubstr("ISOMOTION_DATA=" + folder().string()),
                               HasSubstr("has no shaders/ and animations/")));
    // A scene that stands on its own needs none of it.
    EXPECT_EQ(mistake(ball()), "nothing is wrong");
}

} // namespace
} // namespace isomotion::scene
