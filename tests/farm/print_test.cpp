// The printed lines are commands, each for itself, wherever the files are.
#include <algorithm>

#include "cli.h"

namespace isomotion::farm {
namespace {

namespace fs = std::filesystem;
using cli::Words;
using testing::IsEmpty;

class Print : public cli::Cli {
protected:
    static constexpr const char* place = "it's a \"place\"\n$HOME 100%";
    cli::Ending printed(Words more = {}) const {
        fs::create_directories(*this / place);
        fs::copy_file(*this / "sphere.toml", *this / place / "-s c.toml",
                      fs::copy_options::overwrite_existing);
        Words words{"submit", "./-s c.toml", "--engine", "print", "--frames",
                    "1-10",   "--chunk",     "3",        "-o",    "o'\n#/a $x.##.png"};
        words.insert(words.end(), more.begin(), more.end());
        cli::Circumstances there = circumstances();
        there.folder = *this / place;
        return run(words, there);
    }
    void expect_frames() const {
        render({"sphere.toml", "--frames", "1-10", "-o", "one/a.##.png"});
        for (int frame = 1; frame <= 10; ++frame) {
            const std::string number = frame < 10 ? "0" + std::to_string(frame) : "10";
            EXPECT_EQ(bytes("one/a." + number + ".png"),
                      bytes(std::string(place) + "/o'\n#/a $x." + number + ".png"));
        }
    }
};

TEST_F(Print, LinesAreRunByXargs) {
    const cli::Ending ending = printed();
    ASSERT_EQ(ending.code, 0) << ending;
    EXPECT_THAT(ending.err, IsEmpty());
    EXPECT_EQ(std::ranges::count(ending.out, '\n'), 5); // 4 chunks and the joining
    write("lines", ending.out);
    // From another folder, and without what this one's environment says.
    const cli::Ending done =
        cli::run({"/bin/sh", "-c", "head -n -1 lines | xargs -d '\\n' -n 1 -P 2 sh -c"},
                 {.folder = folder(), .environment = {{"ISOMOTION_DATA", std::nullopt}}});
    EXPECT_EQ(done.code, 0) << done;
    expect_frames();
}

TEST_F(Print, TheLastLineDoesWhatIsLeft) {
    const cli::Ending ending = printed({"--workers", "2"});
    ASSERT_EQ(ending.code, 0) << ending;
    write("lines", ending.out);
    const cli::Ending done =
        cli::run({"/bin/sh", "-c", "sed -n '1p;$p' lines | sh"}, {.folder = folder()});
    EXPECT_EQ(done.code, 0) << done;
    EXPECT_THAT(done.out, testing::HasSubstr("\n2 frames kept from an earlier run\n"));
    expect_frames();
}

} // namespace
} // namespace isomotion::farm
