// Scenes of strangers: what they may read, and what they may say on a terminal.
#include "cli.h"

#include <cmath>

#include <sys/stat.h>

namespace isomotion::cli {
namespace {

constexpr const char* blobs = R"(title = "Blobs"
[surface]
formula = "sum(blobs, exp(-4*((x-cx)^2 + y^2 + z^2))) - 0.5"
bounds = { sphere = 3 }
[arrays.blobs]
file = "../blobs.csv"
[output]
size = [16, 16]
)";

class Stranger : public Cli {
protected:
    Stranger() {
        std::filesystem::create_directory(folder() / "from_elsewhere");
        write("from_elsewhere/scene.toml", blobs);
        write("blobs.csv", "cx\n0\n1\n");
    }
};

TEST_F(Stranger, ReadsItsOwnFolderUnlessAllowedMore) {
    for (const Words& command : {Words{"show"}, {"render"}, {"accuracy"}, {"topology"}}) {
        Words words{command[0], "from_elsewhere/scene.toml"};
        const Ending refused = run(words);
        EXPECT_EQ(refused.code, 2) << command[0];
        EXPECT_THAT(refused.err,
                    StartsWith("from_elsewhere/scene.toml:6: arrays.blobs.file: "
                               "from_elsewhere/../blobs.csv lies outside the scene's folder; move "
                               "it there, or allow such files with --allow-outside\n"))
            << command[0];
    }
    EXPECT_EQ(run({"show", "from_elsewhere/scene.toml", "--allow-outside"}).code, 0);
    EXPECT_EQ(run({"render", "from_elsewhere/scene.toml", "--allow-outside", "--quiet"}).code, 0);
    EXPECT_THAT(run({"play", "--help"}).out, HasSubstr("--allow-outside"));
}

TEST_F(Stranger, NamesAndValuesThatCommandATerminalAreShownOnly) {
    write("e.json", "{\"events\": [\"\\r\\nforged\"]}");
    const Words lines[] = {
        {"show", "sphere.toml", "\x1b[31mEVIL"},
        {"render", "sphere.toml", "--max-wrong=\x1b[31mEVIL"},
        {"show", "a\rb\x1b[2J.toml"},
        {"verify", "a\rb\x1b[2J.####.png"},
        {"topology", "sphere.toml", "--certify", "off", "--check", "e.json"},
    };
    for (const Words& line : lines) {
        const Ending ending = run(line);
        EXPECT_GE(ending.code, 2) << ending;
        EXPECT_THAT(ending.err + ending.out,
                    Not(AnyOf(HasSubstr("\r"), HasSubstr("\x1b"), HasSubstr("\nforged"))));
    }
}

void expect_finite(const std::filesystem::path& file) {
    for (const image::Channel& channel : image::decode(file).channels) {
        for (const float sample : channel.samples) {
            ASSERT_TRUE(std::isfinite(sample)) << channel.name << " of " << file;
        }
    }
}

TEST_F(Stranger, FiniteScenesGiveFinitePictures) {
    const char* const extremes[] = {
        "[[lights]]\nposition = [3, 1, 2]\nfalloff = 1e18\n",
        "[[lights]]\nposition = [3, 1, 2]\nfalloff = 3e38\ncolor = [1e6, -1e6, 1e6]\n",
        "[[lights]]\nposition = [3e38, 1, 2]\nfalloff = 1e-38\nshadow = true\n",
        "[occlusion]\nradius = 3e38\n",
        "[occlusion]\nradius = 1e-38\n",
        "[fog]\ndensity = 3e38\n",
        "[fog]\ndensity = 3e38\nstart = 3e38\n",
        "[fog]\ndensity = 0\nstart = 3e38\n",
        "[ground]\nheight = -3e38\ncolor = [1e6, 1e6, -1e6]\n",
    };
    for (const std::string extreme : extremes) {
        write("extreme.toml", sphere_scene() + extreme);
        render({"extreme.toml", "--frames", "1", "--size", "24x24", "-o", "a.exr"});
        expect_finite(*this / "a.exr");
    }
    for (const std::string beyond : {"[[lights]]\ndirection = [0, 0, 1]\ncolor = [1e7, 0, 0]\n",
                                     "[ground]\nheight = 0\ncolor = [0, 1e30, 0]\n",
                                     "[fog]\ndensity = 1\ncolor = [0, 0, -1e38]\n"}) {
        write("beyond.toml", sphere_scene() + beyond);
        const Ending ending = run({"show", "beyond.toml"});
        EXPECT_EQ(ending.code, 2) << beyond << ending;
        EXPECT_THAT(ending.err, HasSubstr("the colour's part")) << beyond;
    }
}

// A shader that is not the product's own.
TEST_F(Stranger, PixelsWithoutColourAreCounted) {
    namespace fs = std::filesystem;
    for (const char* part : {"shaders", "animations"})
        fs::copy(fs::path(ISOMOTION_SOURCE_DIR) / part, *this / part, fs::copy_options::recursive);
    std::string fog = bytes("shaders/effects/sky.glsl");
    const std::string exp = "exp(-thick)";
    ASSERT_NE(fog.find(exp), fog.npos);
    write("shaders/effects/sky.glsl",
          fog.replace(fog.find(exp), exp.size(), "1.0 / (thick * 0.0)"));
    write("fog.toml", sphere_scene() + "[fog]\ndensity = 1\n");
    Circumstances circumstances = this->circumstances();
    circumstances.environment["ISOMOTION_DATA"] = folder().string();
    const Ending ending =
        run({"render", "fog.toml", "--frames", "1", "--size", "24x24", "-o", "a.##.exr"},
            circumstances);
    EXPECT_EQ(ending.code, 0) << ending;
    EXPECT_THAT(ending.err, HasSubstr("is infinite or no number"));
    EXPECT_THAT(ending.out, HasSubstr("pixels whose colour is infinite or no number"));
    EXPECT_THAT(run({"verify", "a.##.exr"}).out, HasSubstr("pixels whose colour is infinite"));
}

TEST_F(Stranger, KeepsItsNamesWhereFilesCannot) {
    const std::string name(62, 'p');
    std::string scene = formula_scene("x^2 + y^2 + z^2 - r^2 - 0*" + name);
    write("long.toml", scene + "[parameters." + name + "]\ndefault = 1\n");
    for (const char* file : {"a.png", "a.exr"})
        render({"long.toml", "--frames", "1", "--set", "time.fps=3000000000", "-o", file});
    const auto found = image::decode(*this / "a.exr").metadata;
    EXPECT_NE(image::find(found, "isomotion:parameter." + name), nullptr);
    EXPECT_EQ(image::to_text(*image::find(found, "isomotion:fps")), "3000000000/1");
    EXPECT_EQ(image::find(image::decode(*this / "a.png").metadata, "isomotion:parameter." + name),
              nullptr);
}

TEST_F(Stranger, IsNoPipe) {
    ASSERT_EQ(::mkfifo((*this / "pipe.toml").c_str(), 0600), 0);
    for (const char* scene : {"pipe.toml", "/dev/zero"}) {
        const Ending ending = run({"show", scene});
        EXPECT_EQ(ending.code, 2);
        EXPECT_THAT(ending.err, HasSubstr("is a pipe or a device; name a regular file"));
    }
}

TEST_F(Stranger, DoesNotCommandTheTerminal) {
    std::string titled = sphere_scene();
    titled.replace(titled.find("Sphere"), 6, "\\u001b]0;owned\\u0007");
    write("from_elsewhere/scene.toml", titled);
    const Ending title = run({"show", "from_elsewhere/scene.toml"});
    EXPECT_EQ(title.code, 2);
    write("from_elsewhere/scene.toml", sphere_scene() + "\"\\u001b[2J\\r\\nall fine\" = 1\n");
    const Ending key = run({"show", "from_elsewhere/scene.toml"});
    EXPECT_EQ(key.code, 2);
    const Ending name = run({"show", "no\x1b[2Jsuch.toml"});
    EXPECT_EQ(name.code, 2);
    // A timeline that is checked, and the name of a picture whose texels are mended.
    run({"topology", "sphere.toml", "--certify", "off", "--frames", "1-3", "-o", "t.json"});
    std::string timeline = bytes("t.json");
    const std::size_t doubts = timeline.find("\"doubts\": [");
    ASSERT_NE(doubts, timeline.npos);
    timeline.insert(doubts + 11, "\"\\u001b[2J\\nall fine\"" +
                                     std::string(timeline[doubts + 11] == ']' ? "" : ","));
    write("t.json", timeline);
    const Ending checked = run(
        {"topology", "sphere.toml", "--certify", "off", "--frames", "1-3", "--check", "t.json"});
    EXPECT_EQ(checked.code, 2) << checked;
    EXPECT_THAT(checked.err, HasSubstr("must be one printable line"));
    write("from_elsewhere/a\x1b[2J.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n"
                                         "\xff\xff\xff\xa0\xff\xff\xff\xa0");
    write("from_elsewhere/scene.toml",
          sphere_scene() + "[environment]\nmap = \"a\\u001b[2J.hdr\"\n");
    const Ending mended = run(
        {"render", "from_elsewhere/scene.toml", "--frames", "1", "--size", "8x8", "-o", "a.png"});
    EXPECT_THAT(mended.err, HasSubstr("2 texels were"));
    for (const std::string& text :
         {title.err, key.err, name.err, checked.err + checked.out, mended.err + mended.out}) {
        EXPECT_EQ(text.find('\x1b'), text.npos) << text;
        EXPECT_EQ(text.find("\nall fine"), text.npos) << text;
        EXPECT_EQ(text.find('\r'), text.npos) << text;
    }
}

} // namespace
} // namespace isomotion::cli
