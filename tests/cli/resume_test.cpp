// --resume keeps a file if and only if it was recorded as what the same settings would write, and
// is that still.
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
            if (fs::is_directory(*this / name)) continue;
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
                             {"--set", "surface.transform.scale=0.99"},
                             {"--method", "amp-taylor"},
                             {"--size", "40x40"},
                             {"--bits", "16"}};
    for (const Words& change : changes) {
        SCOPED_TRACE(change.back());
        Words resumed = change;
        resumed.push_back("--resume");
        EXPECT_THAT(render_six("a.####.png", resumed).out,
                    HasSubstr("\nnot kept: 6 of other settings (1-6)\n"));
    }
    render_six("fresh.####.png", changes[4]);
    EXPECT_EQ(bytes("a.0004.png"), bytes("fresh.0004.png"));
}

// What shows in the file alone counts too.
TEST_F(Resume, RendersAgainAfterAnotherTitle) {
    render_six("a.####.png");
    std::string text = sphere_scene();
    write("sphere.toml", text.replace(text.find("Sphere"), 6, "Globe"));
    EXPECT_THAT(render_six("a.####.png", {"--resume"}).out,
                HasSubstr("\nnot kept: 6 of other settings (1-6)\n"));
}

TEST_F(Resume, RendersAgainWhatIsNotAsRecordedAndSaysWhy) {
    for (const std::string extension : {".png", ".exr"}) {
        const auto name = [&](int frame) { return "a.000" + std::to_string(frame) + extension; };
        const std::string manifest = extension == ".png" ? "a.manifest" : "a.exr.manifest";
        render_six("a.####" + extension);
        render_six("fresh.####" + extension);
        fs::resize_file(*this / name(2), fs::file_size(*this / name(2)) - 9);
        // A whole picture of another frame.
        fs::copy_file(*this / name(1), *this / name(3), fs::copy_options::overwrite_existing);
        fs::remove(*this / name(4));
        fs::remove(*this / (manifest + "/0005.json")); // the picture itself is right
        write(manifest + "/0006.json", "{");
        const ino_t first = identity(name(1));
        const Ending ending = render_six("a.####" + extension, {"--resume"});
        EXPECT_THAT(ending.out, HasSubstr("drawn 5 in"));
        EXPECT_THAT(ending.out, HasSubstr("\n1 frame kept from an earlier run\n"
                                          "not kept: 1 missing (4); 2 truncated or changed (2-3); "
                                          "2 of an earlier scene (5-6)\n"));
        EXPECT_EQ(identity(name(1)), first);
        for (int frame = 1; frame <= 6; ++frame) {
            EXPECT_EQ(bytes(name(frame)), bytes("fresh" + name(frame).substr(1))) << frame;
        }
        expect_only_whole_files();
        EXPECT_EQ(run({"verify", "a.####" + extension, "--pixels"}).code, 0);
    }
}

// One changed bit in the pixels, where the metadata and its fingerprint are as they were.
TEST_F(Resume, RendersAgainAfterOneChangedByte) {
    render_six("a.####.png");
    const std::string right = bytes("a.0003.png");
    std::string wrong = right;
    wrong[right.size() / 2] ^= 1;
    write("a.0003.png", wrong);
    EXPECT_THAT(render_six("a.####.png", {"--resume"}).out,
                HasSubstr("\nnot kept: 1 truncated or changed (3)\n"));
    EXPECT_EQ(bytes("a.0003.png"), right);
}

// A change of the scene that these frames don't show: they are the new scene's from then on.
TEST_F(Resume, KeepsFramesThatAChangeOfTheSceneLeavesAlone) {
    const std::string keys = "r={keys=[[0,1],[0.1,1.1],[4,";
    render_six("a.####.png", {"--set", keys + "2]],ease=\"hold\"}"});
    const Ending ending =
        render_six("a.####.png", {"--resume", "--set", keys + "3]],ease=\"hold\"}"});
    EXPECT_THAT(ending.out, HasSubstr("\n6 frames kept from an earlier run\n"));
    EXPECT_EQ(run({"verify", "a.####.png"}).code, 0);
}

// One picture has no manifest, and so nothing to trust.
TEST_F(Resume, OnePictureIsDrawnAgain) {
    const Words words{"sphere.toml", "--frames", "3", "-o", "a.png", "--resume"};
    EXPECT_THAT(render(words).out, HasSubstr("\nnot kept: 1 missing (3)\n"));
    EXPECT_THAT(render(words).out, HasSubstr("\nnot kept: 1 of an earlier scene (3)\n"));
    EXPECT_EQ(names(), (std::set<std::string>{"sphere.toml", "a.png"}));
}

TEST_F(Resume, EverythingIsWrittenAgainWithoutIt) {
    render_six("a.####.png");
    const std::string same = bytes("a.0003.png");
    EXPECT_THAT(render_six("a.####.png").out, HasSubstr("drawn 6 in"));
    EXPECT_EQ(bytes("a.0003.png"), same);
}

} // namespace
} // namespace isomotion::cli
