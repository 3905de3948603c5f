// --resume keeps a file if and only if the same settings would write it again.
#include "cli.h"

#include <sys/stat.h>

namespace isomotion::cli {
namespace {

namespace fs = std::filesystem;

class Resume : public Cli {
protected:
    Ending render_six(const std::string& output, Words more = {}) const {
        more.insert(more.begin(), {"sphere.toml", "--frames", "1-6", "-o", output});
        return render(more);
    }
    // A file that was written again is another file under the old name.
    ino_t identity(const std::string& name) const {
        struct stat found = {};
        EXPECT_EQ(::stat((*this / name).c_str(), &found), 0) << name;
        return found.st_ino;
    }
};

TEST_F(Resume, KeepsEverythingWhereNothingChanged) {
    for (const std::string output : {"a.####.png", "a.####.exr"}) {
        render_six(output);
        std::map<std::string, std::pair<ino_t, fs::file_time_type>> before;
        for (const auto& name : names()) {
            before[name] = {identity(name), fs::last_write_time(*this / name)};
        }
        const Ending ending = render_six(output, {"--resume"});
        EXPECT_THAT(ending.out, HasSubstr("\n6 frames kept from an earlier run\n"));
        EXPECT_THAT(ending.out, Not(HasSubstr("drawn")));
        for (const auto& [name, file] : before) {
            EXPECT_EQ(identity(name), file.first) << name;
            EXPECT_EQ(fs::last_write_time(*this / name), file.second) << name;
        }
    }
}

TEST_F(Resume, RendersAgainAfterAChangedSetting) {
    render_six("a.####.png");
    const Words changes[] = {{"--set", "r=0.9 + t"},
                             {"--set", "surface.placement.scale=0.99"},
                             {"--method", "amp-taylor"},
                             {"--size", "40x40"},
                             {"--bits", "16"}};
    for (const Words& change : changes) {
        SCOPED_TRACE(change.back());
        Words resumed = change;
        resumed.push_back("--resume");
        EXPECT_THAT(render_six("a.####.png", resumed).out, Not(HasSubstr("kept")));
    }
    render_six("fresh.####.png", changes[4]);
    EXPECT_EQ(bytes("a.0004.png"), bytes("fresh.0004.png"));
}

// What shows in the file alone counts too.
TEST_F(Resume, RendersAgainAfterAnotherTitle) {
    render_six("a.####.png");
    std::string text = sphere_scene();
    write("sphere.toml", text.replace(text.find("Sphere"), 6, "Globe"));
    EXPECT_THAT(render_six("a.####.png", {"--resume"}).out, Not(HasSubstr("kept")));
}

TEST_F(Resume, RendersAgainWhereAFileIsBrokenOrForeign) {
    for (const std::string extension : {".png", ".exr"}) {
        const auto name = [&](int frame) { return "a.000" + std::to_string(frame) + extension; };
        render_six("a.####" + extension);
        render_six("fresh.####" + extension);
        fs::resize_file(*this / name(2), fs::file_size(*this / name(2)) - 9);
        fs::resize_file(*this / name(3), 0);
        write(name(4), "not a picture");
        fs::remove(*this / name(5));
        // A whole picture of another frame.
        fs::copy_file(*this / name(1), *this / name(6), fs::copy_options::overwrite_existing);
        const ino_t first = identity(name(1));
        const Ending ending = render_six("a.####" + extension, {"--resume"});
        EXPECT_THAT(ending.out, HasSubstr("drawn 5 in"));
        EXPECT_THAT(ending.out, HasSubstr("\n1 frame kept from an earlier run\n"));
        EXPECT_EQ(identity(name(1)), first);
        for (int frame = 1; frame <= 6; ++frame) {
            EXPECT_EQ(bytes(name(frame)), bytes("fresh" + name(frame).substr(1))) << frame;
        }
        expect_only_whole_files();
    }
}

TEST_F(Resume, EverythingIsWrittenAgainWithoutIt) {
    render_six("a.####.png");
    const std::string same = bytes("a.0003.png");
    EXPECT_THAT(render_six("a.####.png").out, HasSubstr("drawn 6 in"));
    EXPECT_EQ(bytes("a.0003.png"), same);
}

} // namespace
} // namespace isomotion::cli
