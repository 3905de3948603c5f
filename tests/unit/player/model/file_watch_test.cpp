// Real files. Times are set, not waited for.
#include "player/model/file_watch.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>

#include "unit/image/places.h"
#include "unit/scene/testing.h"

namespace isomotion::player {
namespace {
namespace fs = std::filesystem;

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

class Watching : public testing::Test {
protected:
    // Writes a file in place, as a text that is saved at this second.
    fs::path write(const std::string& name, const std::string& text, int second) const {
        const fs::path file = folder / name;
        std::ofstream(file) << text;
        fs::last_write_time(file, begin + std::chrono::seconds(second));
        return file;
    }
    // What two looks in a row tell: the first sees it, the second sees that it keeps still.
    static std::vector<fs::path> after_two_looks(FileWatch& watch) {
        EXPECT_THAT(watch.changed(), IsEmpty());
        return watch.changed();
    }

    image::TemporaryFolder folder;
    const fs::file_time_type begin = fs::file_time_type::clock::now() - std::chrono::hours(1);
};

TEST_F(Watching, NothingHappensUntilSomethingDoes) {
    FileWatch watch({write("a", "1", 0), folder / "missing", folder.path()});
    for (int k = 0; k < 5; ++k) EXPECT_THAT(watch.changed(), IsEmpty());
    write("beside", "a folder that changes is no file that does", 0);
    for (int k = 0; k < 5; ++k) EXPECT_THAT(watch.changed(), IsEmpty());
    EXPECT_THAT(FileWatch().changed(), IsEmpty());
}

TEST_F(Watching, AChangeIsToldOnce) {
    const fs::path a = write("a", "1", 0), b = write("b", "1", 0);
    FileWatch watch({a, b});
    write("a", "22", 0); // another size at the same time
    EXPECT_THAT(after_two_looks(watch), ElementsAre(a));
    for (int k = 0; k < 3; ++k) EXPECT_THAT(watch.changed(), IsEmpty());
    write("b", "2", 1); // the same size at another time
    EXPECT_THAT(after_two_looks(watch), ElementsAre(b));
    write("a", "3", 0), write("b", "3", 2);
    EXPECT_THAT(after_two_looks(watch), ElementsAre(a, b));
    EXPECT_THAT(watch.changed(), IsEmpty());
}

// Some editors write a new file and give it the old one's name.
TEST_F(Watching, AnotherFileOfTheSameNameIsAChange) {
    const fs::path a = write("a", "1", 0);
    FileWatch watch({a});
    fs::rename(write("a.new", "2", 0), a); // the same size and time
    EXPECT_THAT(after_two_looks(watch), ElementsAre(a));
    // Written before the other is removed: a file system may give a freed inode to the next file.
    const fs::path elsewhere = write("elsewhere", "3", 0);
    fs::remove(a);
    fs::create_symlink(elsewhere, a);
    EXPECT_THAT(after_two_looks(watch), ElementsAre(a));
    write("elsewhere", "33", 0);
    EXPECT_THAT(after_two_looks(watch), ElementsAre(a)) << "what it stands for";
}

TEST_F(Watching, AFileThatIsGoneForAMomentIsWaitedFor) {
    const fs::path a = write("a", "1", 0);
    FileWatch watch({a});
    fs::rename(a, folder / "a~");
    for (int k = 0; k < 5; ++k) EXPECT_THAT(watch.changed(), IsEmpty());
    write("a", "2", 5);
    EXPECT_THAT(after_two_looks(watch), ElementsAre(a));
    // It comes back as it was: nothing has changed.
    fs::rename(a, folder / "a~");
    EXPECT_THAT(watch.changed(), IsEmpty());
    fs::rename(folder / "a~", a);
    for (int k = 0; k < 3; ++k) EXPECT_THAT(watch.changed(), IsEmpty());
}

TEST_F(Watching, AFileThatAppearsIsAChange) {
    FileWatch watch({folder / "a"});
    write("a", "1", 0);
    EXPECT_THAT(after_two_looks(watch), ElementsAre(folder / "a"));
}

TEST_F(Watching, AFileThatIsBeingWrittenIsNotReadYet) {
    const fs::path a = write("a", "1", 0);
    FileWatch watch({a});
    for (int k = 1; k <= 5; ++k) {
        write("a", std::string(std::size_t(k), 'x'), k);
        EXPECT_THAT(watch.changed(), IsEmpty()) << k;
    }
    EXPECT_THAT(watch.changed(), ElementsAre(a));
    // Undone before anyone looked twice: as if nothing had been.
    const fs::path kept = folder / "kept";
    fs::rename(a, kept);
    write("a", "other", 9);
    EXPECT_THAT(watch.changed(), IsEmpty());
    fs::rename(kept, a);
    for (int k = 0; k < 3; ++k) EXPECT_THAT(watch.changed(), IsEmpty());
}

TEST_F(Watching, OtherFilesMayBeWatchedFromNowOn) {
    const fs::path a = write("a", "1", 0), b = write("b", "1", 0), c = write("c", "1", 0);
    FileWatch watch({a, b});
    write("a", "22", 0), write("b", "22", 0), write("c", "22", 0);
    EXPECT_THAT(watch.changed(), IsEmpty());
    watch.watch({b, c, c});
    EXPECT_THAT(watch.changed(), ElementsAre(b)) << "what was not told yet is not lost";
    write("a", "333", 0), write("c", "333", 0);
    EXPECT_THAT(after_two_looks(watch), ElementsAre(c));
}

class SceneFiles : public scene::Scenes {};

TEST_F(SceneFiles, AreAllThatASceneWasMadeOf) {
    surface("drops", "title = \"drops\"\nsource = \"test\"\n"
                     "formula = \"sum(drops, exp(-(x-px)^2 - y^2 - z^2)) - 0.5\"\n"
                     "bounds = { sphere = 9 }\n[arrays.drops]\ncount = 1\npx = [0]\n");
    std::filesystem::create_directories(folder() / "data");
    write("data/drops.csv", "px\n0\n1\n");
    write("sky.exr", "loading a scene reads no picture");
    const scene::Scene scene =
        loaded("[surface]\nuse = \"drops\"\n[arrays.drops]\nfile = \"data/drops.csv\"\n"
               "[environment]\nmap = \"sky.exr\"\n");
    EXPECT_THAT(files_of(scene),
                UnorderedElementsAre(folder() / "scene.toml",
                                     folder() / "animations/surfaces/drops.toml",
                                     folder() / "data/drops.csv", folder() / "sky.exr"));
    // While it is being edited it may say nothing at all.
    write("scene.toml", "[surface");
    EXPECT_THAT(files_of(scene), testing::Contains(folder() / "scene.toml"));
    EXPECT_THAT(files_of(loaded(scene::ball())), ElementsAre(folder() / "scene.toml"));
}

TEST_F(SceneFiles, AreThoseThatABrokenOneNamesToo) {
    const scene::Scene scene = loaded(scene::ball());
    // No such surface, array or picture; the sum is of what is not there.
    write("scene.toml", "[surface]\nuse = \"none\"\nformula = 3\n[arrays.a]\nfile = \"a.csv\"\n"
                        "[arrays.b]\nfile = 4\n[environment]\nmap = \"sky.exr\"\n");
    const auto files = files_of(scene);
    for (const char* name : {"scene.toml", "animations/surfaces/none.toml", "a.csv", "sky.exr"}) {
        EXPECT_THAT(files, testing::Contains(folder() / name));
    }
}

TEST_F(SceneFiles, ShadersAreFoundInEveryFolder) {
    ::setenv("ISOMOTION_DATA", ISOMOTION_SOURCE_DIR, 1);
    const auto files = shader_files();
    const fs::path shaders = fs::path(ISOMOTION_SOURCE_DIR) / "shaders";
    EXPECT_THAT(files, testing::Contains(shaders / "prelude.glsl"));
    EXPECT_THAT(files, testing::Contains(shaders / "march" / "march.glsl"));
    EXPECT_TRUE(std::ranges::is_sorted(files));
}

} // namespace
} // namespace isomotion::player
