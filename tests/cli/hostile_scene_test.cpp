// Scenes of strangers: what they may read, and what they may say on a terminal.
#include "cli.h"

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
    for (const std::string& text : {title.err, key.err, name.err}) {
        EXPECT_EQ(text.find('\x1b'), text.npos) << text;
        EXPECT_EQ(text.find("\nall fine"), text.npos) << text;
        EXPECT_EQ(text.find('\r'), text.npos) << text;
    }
}

} // namespace
} // namespace isomotion::cli
