// What the machine refuses: exit code 3, the reason, and nothing half written.
#include "cli.h"

#include <cstdlib>

#include <sys/mount.h>
#include <sys/stat.h>

namespace isomotion::cli {
namespace {

class Machine : public Cli {
protected:
    Ending render_to(const std::string& output) const {
        return run({"render", "sphere.toml", "--frames", "1-3", "-o", output});
    }
    void expect_refusal(const Ending& ending, const std::string& message) const {
        EXPECT_EQ(ending.code, 3) << ending;
        EXPECT_THAT(ending.err, HasSubstr(message));
        expect_only_whole_files();
    }
};

TEST_F(Machine, OutputBelowAFile) {
    expect_refusal(render_to("sphere.toml/a.####.png"), "cannot be created: Not a directory");
    expect_refusal(render_to("sphere.toml/deeper/a.####.png"),
                   "cannot be created: Not a directory");
    expect_refusal(run({"render", "sphere.toml", "--movie", "sphere.toml/a.mp4"}),
                   "sphere.toml: the folder cannot be created: Not a directory");
    EXPECT_EQ(bytes("sphere.toml"), sphere_scene());
}

// Even root can make nothing here.
TEST_F(Machine, OutputInProc) {
    if (!std::filesystem::is_directory("/proc/self")) GTEST_SKIP() << "no /proc here";
    expect_refusal(render_to("/proc/a.####.png"), "/proc/a.manifest: the folder cannot be");
    expect_refusal(run({"render", "sphere.toml", "--frames", "1", "-o", "/proc/a.png"}),
                   "/proc/a.png: cannot be created");
    expect_refusal(render_to("/proc/deeper/a.####.png"), "/proc/deeper: the folder cannot be");
}

TEST_F(Machine, AFolderIsWhereAFrameBelongs) {
    std::filesystem::create_directory(*this / "a.0002.png");
    expect_refusal(render_to("a.####.png"), "a.0002.png: cannot be replaced: Is a directory");
    EXPECT_TRUE(std::filesystem::is_directory(*this / "a.0002.png"));
}

TEST_F(Machine, APipeOrADeviceIsWhereAFrameBelongs) {
    ASSERT_EQ(::mkfifo((*this / "p.0001.png").c_str(), 0600), 0);
    std::filesystem::create_symlink("/dev/zero", *this / "d.0001.png");
    for (const char* name : {"p.####.png", "d.####.png"}) {
        const Ending ending = run(
            {"render", "sphere.toml", "--frames", "1-2", "--size", "8x8", "--quiet", "-o", name});
        EXPECT_EQ(ending.code, 3) << name << ending;
        EXPECT_THAT(ending.err, HasSubstr("0001.png: cannot be replaced")) << name;
    }
}

TEST_F(Machine, ReadOnlyDisk) {
    const image::TemporaryFolder place;
    const image::Disk disk(place, MS_RDONLY, "");
    if (!disk) GTEST_SKIP() << "mounting a file system is not allowed here";
    expect_refusal(render_to(place / "a.####.png"), "folder cannot be created: Read-only");
    expect_refusal(run({"render", "sphere.toml", "--frames", "1", "-o", place / "a.png"}),
                   "a.png: cannot be created: Read-only");
    expect_refusal(render_to(place / "new/a.####.png"), "folder cannot be created: Read-only");
}

// Less than a compiler of shaders or a nested formula needs.
TEST_F(Machine, ASmallStack) {
    std::string nested = "z";
    for (int k = 0; k < 100; ++k) nested = "sin(" + nested + "+x)";
    write("nested.toml", formula_scene(nested + " - r"));
    for (const Words& words : {Words{"show", "nested.toml"},
                               {"render", "nested.toml", "--frames", "1", "-o", "a.png"}}) {
        Words limited{"/bin/sh", "-c", R"(ulimit -s 128; exec "$0" "$@")",
                      tested_program(ISOMOTION_PROGRAM)};
        limited.insert(limited.end(), words.begin(), words.end());
        const Ending ending = cli::run(limited, circumstances());
        EXPECT_EQ(ending.code, 0) << ending;
    }
}

// Redirections of a shell; {0} stands for the command.
TEST_F(Machine, OutputsThatCannotBeWritten) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    const auto shell = [this](const std::string& redirection, Words words) {
        Words all{"/bin/sh", "-c", R"(exec "$0" "$@" )" + redirection,
                  tested_program(ISOMOTION_PROGRAM)};
        all.insert(all.end(), words.begin(), words.end());
        return cli::run(all, circumstances());
    };
    const Words render{"render", "sphere.toml", "--frames", "1-3", "-o", "a.####.png"};
    // Messages are dropped; frames are not.
    for (const char* redirection : {"2>/dev/full", "2>&-", "2>&- 1>&- 0<&-"}) {
        std::filesystem::remove_all(*this / "a.manifest");
        const Ending ending = shell(redirection, render);
        EXPECT_EQ(ending.signal, 0) << redirection;
        EXPECT_EQ(run({"verify", "a.####.png"}).code, 0) << redirection << ending;
        EXPECT_THAT(bytes("a.manifest/writers"), StartsWith("Locked by every process"))
            << redirection;
        EXPECT_THAT(bytes("a.manifest/writers"), Not(HasSubstr("warning"))) << redirection;
    }
    // A reader that has gone: of the messages, then of the result.
    write("nothing.toml", formula_scene("x^2 + y^2 + z^2 + 1 + 0*r")); // is warned of
    for (const char* number : {"2", "1"}) {
        std::filesystem::remove_all(*this / "b.manifest");
        const Ending ending =
            cli::run({"/bin/sh", "-c",
                      "mkfifo p; : <p & exec 4>p; wait; rm p; exec \"$0\" \"$@\" " +
                          std::string(number) + ">&4",
                      cli::tested_program(ISOMOTION_PROGRAM), "render", "nothing.toml", "--frames",
                      "1-3", "--size", "16x16", "-o", "b.####.png"},
                     circumstances());
        EXPECT_EQ(ending.signal, 0) << number << ending;
        EXPECT_EQ(ending.code, *number == '1' ? 3 : 0) << ending;
        EXPECT_EQ(run({"verify", "b.####.png"}).code, 0) << number << ending;
    }
    // Files are written and claims judged whatever becomes of what is said of them.
    write("claims.json", R"({"components": {"1": 7}})");
    const Words topology{"topology", "sphere.toml", "--certify", "off",     "--frames",
                         "1-3",      "-o",          "t.json",    "--check", "claims.json"};
    EXPECT_THAT(shell(">/dev/full", topology).err, HasSubstr("components.1 = 7: "));
    EXPECT_THAT(bytes("t.json"), HasSubstr("isomotion"));
    // What is the result itself is not lost in silence.
    for (const Words& words : {Words{"list"},
                               {"show", "sphere.toml"},
                               {"verify", "a.####.png"},
                               {"submit", "sphere.toml", "--engine", "print"}}) {
        const Ending ending = shell(">/dev/full", words);
        EXPECT_EQ(ending.code, 3) << words[0] << ending;
        EXPECT_THAT(ending.err, HasSubstr("standard output cannot be written: No space left"))
            << words[0];
    }
}

TEST_F(Machine, APipeUnderAHiddenName) {
    std::filesystem::create_directory(*this / "a.manifest");
    for (const char* name : {"a.manifest/writers", ".a.0001.part.png",
                             "a.manifest/.sequence.part.json", "a.manifest/.0001.part.json"}) {
        ASSERT_EQ(::mkfifo((*this / name).c_str(), 0600), 0);
        const Ending ending = run({"render", "sphere.toml", "--frames", "1-2", "--size", "8x8",
                                   "--quiet", "-o", "a.####.png"});
        EXPECT_EQ(ending.code, 3) << name << ending;
        std::filesystem::remove(*this / name);
    }
}

// A link, and a file that is no manifest's: neither is written through or replaced.
TEST_F(Machine, WhatIsWhereAManifestBelongs) {
    std::filesystem::create_directory(*this / "precious");
    write("precious/sequence.json", "{\"precious\": 1}");
    std::filesystem::create_directory_symlink("precious", *this / "a.manifest");
    const auto refused = [&](const char* message) {
        const Ending ending = run({"render", "sphere.toml", "--frames", "1-2", "--size", "8x8",
                                   "--quiet", "-o", "a.####.png"});
        EXPECT_EQ(ending.code, 3) << ending;
        EXPECT_THAT(ending.err, HasSubstr(message));
        EXPECT_EQ(names("precious"), std::set<std::string>{"sequence.json"});
        EXPECT_EQ(bytes("precious/sequence.json"), "{\"precious\": 1}");
    };
    refused("a.manifest: is a link");
    std::filesystem::remove(*this / "a.manifest");
    std::filesystem::create_directory(*this / "a.manifest");
    write("a.manifest/sequence.json", "{\"precious\": 1}");
    refused("a.manifest/sequence.json: is no manifest");
    EXPECT_EQ(bytes("a.manifest/sequence.json"), "{\"precious\": 1}");
}

// Some daemons start programs so that the kernel forgets how children end.
TEST_F(Machine, EndsOfChildrenThatAParentIgnored) {
    const auto ignoring = [this](Words words) {
        Words all{"/bin/sh", "-c", R"(trap '' CHLD; exec "$0" "$@")",
                  cli::tested_program(ISOMOTION_PROGRAM)};
        all.insert(all.end(), words.begin(), words.end());
        return cli::run(all, circumstances());
    };
    const Ending ending = ignoring({"submit", "sphere.toml", "--frames", "1-4", "--size", "16x16",
                                    "--chunk", "2", "-o", "a.####.png"});
    EXPECT_EQ(ending.code, 0) << ending;
    EXPECT_EQ(run({"verify", "a.####.png"}).code, 0);
    if (std::system("command -v ffmpeg >/dev/null")) GTEST_SKIP() << "ffmpeg is not installed";
    const Ending movie = ignoring(
        {"render", "sphere.toml", "--frames", "1-4", "--size", "16x16", "--movie", "a.gif"});
    EXPECT_EQ(movie.code, 0) << movie;
}

TEST_F(Machine, FullDisk) {
    const image::TemporaryFolder place;
    const image::Disk disk(place, 0, "size=64k");
    if (!disk) GTEST_SKIP() << "mounting a file system is not allowed here";
    const Ending ending = run({"render", "sphere.toml", "--frames", "1-9", "--size", "96x96",
                               "--channels", "z,n,p", "-o", place / "a.####.exr"});
    expect_refusal(ending, "cannot be written: No space left on device");
    EXPECT_THAT(ending.err, HasSubstr(place / "a.")); // names the file, not a hidden one
    for (const std::string& name : place.names()) {
        if (name == "a.exr.manifest") continue;
        EXPECT_THAT(name, StartsWith("a.000"));
        EXPECT_NO_THROW(image::decode(place / name)) << name;
    }
}

TEST_F(Machine, FullDiskUnderTheMovie) {
    const image::TemporaryFolder place;
    const image::Disk disk(place, 0, "size=4k");
    if (!disk) GTEST_SKIP() << "mounting a file system is not allowed here";
    if (std::system("command -v ffmpeg >/dev/null")) GTEST_SKIP() << "ffmpeg is not installed";
    const Ending ending = run({"render", "sphere.toml", "--frames", "1-6", "--size", "160x160",
                               "-o", "a.####.png", "--movie", place / "a.gif"});
    expect_refusal(ending, "a.gif: ffmpeg failed");
    EXPECT_THAT(ending.err, HasSubstr("No space left on device"));
    EXPECT_THAT(place.names(), IsEmpty());
    EXPECT_EQ(names().size(), 1u + 6u + 1u);
}

TEST_F(Machine, NoDriver) {
    Circumstances circumstances = this->circumstances();
    circumstances.environment["__EGL_VENDOR_LIBRARY_FILENAMES"] = "/nonexistent/driver";
    circumstances.environment["ISOMOTION_OSMESA"] = "/nonexistent/driver";
    const Ending ending =
        run({"render", "sphere.toml", "--frames", "1", "-o", "a.png"}, circumstances);
    expect_refusal(ending, "no OpenGL context can be made here");
    EXPECT_THAT(ending.err, HasSubstr("\n  egl, surfaceless: "));
    EXPECT_THAT(ending.err, HasSubstr("\n  osmesa: /nonexistent/driver: cannot open"));
    EXPECT_THAT(ending.err, HasSubstr("libgl1-mesa-dri"));
    EXPECT_EQ(names(), std::set<std::string>{"sphere.toml"});

    const Ending examined = run({"doctor"}, circumstances);
    EXPECT_EQ(examined.code, 3);
    EXPECT_THAT(examined.out, HasSubstr("egl      does not work: "));
    EXPECT_THAT(examined.out, HasSubstr("osmesa   does not work: "));

    // What needs no driver goes on.
    EXPECT_EQ(run({"show", "sphere.toml", "--shader"}, circumstances).code, 0);
}

// Mesa crashes as it is loaded where it is told to use a driver that it doesn't have.
TEST_F(Machine, ADriverThatCrashes) {
    Circumstances circumstances = this->circumstances();
    circumstances.environment["GALLIUM_DRIVER"] = "nope";
    for (const Words& words :
         {Words{"render", "sphere.toml", "--frames", "1", "-o", "a.png"},
          Words{"accuracy", "sphere.toml", "--frames", "1"}, Words{"page", "sphere.toml"}}) {
        const Ending ending = run(words, circumstances);
        // Other drivers than Mesa's do not read the variable.
        EXPECT_EQ(ending.signal, 0) << ending;
        if (ending.code == 0) continue;
        EXPECT_EQ(ending.code, 3) << ending;
        EXPECT_THAT(ending.err, testing::AnyOf(HasSubstr("the program crashed before the first "
                                                         "picture was drawn, most likely in"),
                                               HasSubstr("no OpenGL context can be made here")));
    }
}

// Mesa 22 crashes as it compiles for vectors of a width that it seldom meets.
TEST_F(Machine, ADriverThatCrashesAsItCompiles) {
    Circumstances circumstances = this->circumstances();
    circumstances.environment["LP_NATIVE_VECTOR_WIDTH"] = "64";
    // What it compiled before would be run, and crash wherever that leads.
    circumstances.environment["MESA_SHADER_CACHE_DISABLE"] = "true";
    const Ending ending =
        run({"render", "sphere.toml", "--frames", "1", "-o", "a.png"}, circumstances);
    EXPECT_EQ(ending.signal, 0) << ending;
    if (ending.code == 0) return;
    EXPECT_EQ(ending.code, 3) << ending;
    EXPECT_THAT(ending.err, HasSubstr("most likely in the OpenGL driver"));
}

TEST_F(Machine, OneBackEndIsAskedAlone) {
    Circumstances circumstances = this->circumstances();
    circumstances.environment["ISOMOTION_OSMESA"] = "/nonexistent/driver";
    const Ending ending = run({"render", "sphere.toml", "--backend", "osmesa"}, circumstances);
    EXPECT_EQ(ending.code, 3) << ending;
    EXPECT_THAT(ending.err, HasSubstr("osmesa: "));
    EXPECT_THAT(ending.err, Not(HasSubstr("  egl")));
}

TEST_F(Machine, ComputeShadersBelow43) {
    Circumstances circumstances = this->circumstances();
    circumstances.environment["MESA_GL_VERSION_OVERRIDE"] = "4.2";
    const Ending examined = run({"doctor"}, circumstances);
    if (examined.out.find("OpenGL 4.2") == std::string::npos) {
        GTEST_SKIP() << "no driver of Mesa, which alone can be told to pass for an older one";
    }
    EXPECT_THAT(examined.out, HasSubstr("--stage compute: needs OpenGL 4.3, this driver has 4.2"));
    const Words words{"render", "sphere.toml", "--frames", "1", "-o", "a.png", "--stage"};
    const auto by = [&](const char* stage) {
        Words all = words;
        all.push_back(stage);
        return run(all, circumstances);
    };
    expect_refusal(by("compute"), "--stage compute: needs OpenGL 4.3, this driver has 4.2");
    EXPECT_EQ(names(), std::set<std::string>{"sphere.toml"});
    EXPECT_EQ(by("auto").code, 0);
}

TEST_F(Machine, DataThatIsNotThere) {
    Circumstances circumstances = this->circumstances();
    circumstances.environment["ISOMOTION_DATA"] = folder().string();
    const Ending ending = run({"list"}, circumstances);
    EXPECT_EQ(ending.code, 2) << ending;
    EXPECT_THAT(ending.err, HasSubstr("this folder has no shaders/ and animations/"));
}

} // namespace
} // namespace isomotion::cli
