#include "base/confines.h"

#include <fcntl.h>

#include "base/file.h"
#include "base/input_error.h"
#include "base/regular_file.h"
#include "unit/base/places.h"

namespace isomotion::base {
namespace {

namespace fs = std::filesystem;

// own/, with own/below/, and what lies beside it under names that begin alike.
class Confined : public testing::Test {
protected:
    Confined() {
        fs::create_directories(folder_ / "own/below");
        fs::create_directory(folder_ / "own2");
        for (const char* name : {"own/a", "own/below/a", "own2/a", "outside"})
            std::ofstream(folder_ / name) << name;
        within_ = Confines({*place_of(open_folder(folder_ / "own"))}, "lies outside");
    }

    std::string read(const std::string& name) const {
        try {
            return read_whole_text(folder_ / name, 1000, within_);
        } catch (const InputError& error) {
            EXPECT_EQ(error.what(), (folder_ / name).string() + " lies outside");
            return "refused";
        }
    }
    FileDescriptor opened(const std::string& name) const {
        return FileDescriptor(::open((folder_ / name).c_str(), O_RDONLY | O_CLOEXEC));
    }

    TemporaryFolder folder_;
    Confines within_;
};

TEST_F(Confined, FilesLieInTheFolderByWhateverName) {
    fs::create_directory_symlink("own", folder_ / "link");
    fs::create_symlink("below/a", folder_ / "own/inwards");
    EXPECT_EQ(read("own/a"), "own/a");
    EXPECT_EQ(read("own2/../own/a"), "own/a");
    EXPECT_EQ(read("own/below/a"), "own/below/a");
    EXPECT_EQ(read("link/a"), "own/a");
    EXPECT_EQ(read("own/inwards"), "own/below/a");

    fs::create_symlink("../outside", folder_ / "own/outwards");
    fs::create_directory_symlink("..", folder_ / "own/up");
    for (const char* name : {"outside", "own2/a", "own/../outside", "own/outwards",
                             "own/up/outside", "link/../own2/a"})
        EXPECT_EQ(read(name), "refused") << name;
    EXPECT_EQ(read_whole_text(folder_ / "outside", 1000), "outside") << "without confines";
}

// A link may be put in a file's place between the look at it and its opening.
TEST_F(Confined, TheOpenFileIsAskedAndNotItsName) {
    fs::create_symlink("../outside", folder_ / "own/b");
    const FileDescriptor outside = opened("own/b");
    fs::remove(folder_ / "own/b");
    fs::copy_file(folder_ / "own/a", folder_ / "own/b");
    EXPECT_FALSE(within_.hold(outside));

    const FileDescriptor inside = opened("own/b");
    fs::remove(folder_ / "own/b");
    fs::create_symlink("../outside", folder_ / "own/b");
    EXPECT_TRUE(within_.hold(inside));
    EXPECT_FALSE(within_.hold(opened("own/b")));
}

// The folder is the one that was open, whatever takes its name.
TEST_F(Confined, AnotherFolderUnderTheNameIsNotTheFolder) {
    fs::create_directory_symlink("own", folder_ / "link");
    const FileDescriptor folder = open_folder(folder_ / "link");
    const Confines within({*place_of(folder)}, "lies outside");
    fs::remove(folder_ / "link");
    fs::create_directory_symlink("own2", folder_ / "link");
    EXPECT_EQ(read_whole_text(folder, folder_ / "link/a", 1000), "own/a");
    EXPECT_THROW(RegularFile(folder_ / "link/a", within), InputError);
}

TEST_F(Confined, TheCurrentFolderHasNoName) {
    EXPECT_EQ(place_of(open_folder("")), fs::current_path());
    EXPECT_FALSE(open_folder(folder_ / "none"));
    EXPECT_FALSE(open_folder(folder_ / "outside")) << "a file";
    EXPECT_EQ(place_of(FileDescriptor()), std::nullopt);
}

} // namespace
} // namespace isomotion::base
