// The commands that draw nothing.
#include "cli.h"

#include <algorithm>

namespace isomotion::cli {
namespace {

class Information : public Cli {
protected:
    std::string told(const Words& arguments) const {
        const Ending ending = run(arguments);
        EXPECT_EQ(ending.code, 0) << ending;
        EXPECT_THAT(ending.err, IsEmpty());
        EXPECT_EQ(names(), std::set<std::string>{"sphere.toml"});
        return ending.out;
    }
};

TEST_F(Information, HelpNamesEveryCommandAndOption) {
    const std::string help = told({"--help"});
    for (const char* command : {"render", "show", "list", "doctor"}) {
        EXPECT_THAT(help, HasSubstr(std::string("\n  ") + command));
        EXPECT_THAT(told({command, "--help"}), HasSubstr("Usage: isomotion "));
    }
    const std::string render_help = told({"render", "--help"});
    for (const char* option : {"--frames", "--size", "--set", "--method", "--step", "--backend",
                               "--channels", "--bits", "--movie", "--resume", "--quiet"}) {
        EXPECT_THAT(render_help, HasSubstr(option));
    }
}

TEST_F(Information, Version) { EXPECT_THAT(told({"--version"}), StartsWith("isomotion ")); }

// What opens hundreds of libraries waits for a picture that is read.
TEST_F(Information, NeedsNoCodecs) {
    const auto loaded = [&](const Words& arguments) {
        Circumstances watched = circumstances();
        watched.environment["LD_DEBUG"] = "files";
        const Ending ending = run(arguments, watched);
        EXPECT_EQ(ending.code, 0);
        return ending.err;
    };
    for (const Words& arguments : {Words{"list"}, Words{"--help"}, Words{"show", "sphere.toml"}}) {
        const std::string files = loaded(arguments);
        EXPECT_THAT(files, HasSubstr("libstdc++"));
        EXPECT_THAT(files, Not(HasSubstr("isomotion_encoders"))) << arguments.front();
        EXPECT_THAT(files, Not(HasSubstr("OpenImageIO"))) << arguments.front();
    }
    for (const char* picture : {"a.png", "a.exr"}) {
        const std::string files = loaded({"render", "sphere.toml", "--frames", "1", "-o", picture});
        EXPECT_THAT(files, HasSubstr("isomotion_encoders"));
        EXPECT_THAT(files, Not(HasSubstr("OpenImageIO"))) << picture;
    }
    EXPECT_THAT(loaded({"render", "blobby75_chrome", "--size", "16x16", "--frames", "1"}),
                HasSubstr("OpenImageIO"));
}

TEST_F(Information, ListsWhatThereIs) {
    EXPECT_THAT(told({"list"}),
                testing::ContainsRegex("twisting_superquadric +Twisting superquadric\n"));
    EXPECT_EQ(told({"list"}), told({"list", "animations"}));
    EXPECT_THAT(told({"list", "surfaces"}),
                testing::ContainsRegex("blinn_blobby +Blinn's blobby\n"));
    const std::string methods = told({"list", "methods"});
    for (const char* method : {"marching", "amp-sign", "amp-taylor"}) {
        EXPECT_THAT(methods, HasSubstr(method));
    }
}

TEST_F(Information, EveryAnimationOfTheListCanBeShown) {
    std::istringstream lines(told({"list"}));
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count) {
        const std::string name = line.substr(0, line.find(' '));
        EXPECT_THAT(told({"show", name}), HasSubstr("\nframe     1 at t = 0 s\n"));
    }
    EXPECT_GT(count, 0);
}

TEST_F(Information, ShowFollowsTheFrame) {
    const std::string first = told({"show", "sphere.toml"});
    EXPECT_THAT(first, StartsWith("Sphere\nformula   x^2 + y^2 + z^2 - r^2\n"));
    EXPECT_THAT(first, HasSubstr("60 frames at 30000/1001 a second"));
    EXPECT_THAT(first, HasSubstr("hermite"));
    EXPECT_THAT(first, HasSubstr("march/march.glsl"));
    EXPECT_NE(told({"show", "sphere.toml", "--frame", "2"}), first);
}

TEST_F(Information, ShowTellsTheStage) {
    EXPECT_THAT(told({"show", "sphere.toml"}), HasSubstr("\nstage     fragment\n"));
    const Words by_compute{"show", "sphere.toml", "--stage", "compute"};
    EXPECT_THAT(told(by_compute), HasSubstr("\nstage     compute\n"));
    EXPECT_THAT(told({"show", "sphere.toml", "--stage", "compute", "--pass", "march"}),
                HasSubstr("\n// ----- compute shader\n#version 430 core\n"));
    const Ending ending = run({"show", "sphere.toml", "--stage", "auto"});
    EXPECT_EQ(ending.code, 2) << ending;
    EXPECT_THAT(ending.err, HasSubstr("show one of fragment, compute"));
}

// A plain scene is drawn by these passes and, where they are too few, by others.
TEST_F(Information, ShowPrintsThePassesThatFramesRunInOrder) {
    const std::string all = told({"show", "sphere.toml", "--shader"});
    std::size_t before = 0;
    for (const char* name :
         {"beams of 8 pixels", "beams of 8 pixels by models", "settled", "fused"}) {
        const std::size_t at = all.find(fmt::format("// ===== pass '{}', once a tile\n", name));
        ASSERT_NE(at, all.npos) << name;
        EXPECT_GE(at, before);
        before = at;
    }
    EXPECT_THAT(all, HasSubstr("// not printed: pass 'march', where one draw is too few"));
    EXPECT_THAT(all, Not(HasSubstr("// ===== pass 'march'")));
    const std::string march = told({"show", "sphere.toml", "--pass", "march"});
    EXPECT_THAT(march, HasSubstr("// shaders/march/march_pixel.glsl"));
    EXPECT_THAT(march, Not(HasSubstr("pass 'fused'")));
    const Ending ending = run({"show", "sphere.toml", "--pass", "marhc"});
    EXPECT_EQ(ending.code, 2) << ending;
    EXPECT_THAT(ending.err, HasSubstr("it has 'beams of 8 pixels', 'beams of 8 pixels by models', "
                                      "'settled', 'fused', 'march'"));
}

// A frame changes uniforms only.
TEST_F(Information, AValueChangesWhatIsShownButNotTheShader) {
    const auto show = [&](const std::string& setting, const Words& more) {
        Words words{"show", "sphere.toml", "--set", setting};
        words.insert(words.end(), more.begin(), more.end());
        return told(words);
    };
    const std::string shader = show("r=1", {"--shader"});
    EXPECT_THAT(shader, HasSubstr("void main()"));
    const std::string shown = show("r=1", {});
    for (const std::string setting : {"r=0.5", "camera.fov=20", "isolation.safety=9"}) {
        EXPECT_NE(show(setting, {}), shown) << setting;
        EXPECT_EQ(show(setting, {"--shader"}), shader) << setting;
    }
    EXPECT_NE(show("surface.formula=x^2 + y^2 + z^4 - r^2", {"--shader"}), shader);
    EXPECT_NE(show("isolation.method=marching", {"--shader"}), shader);
}

TEST_F(Information, DoctorTellsWhatWorks) {
    const Ending ending = run({"doctor"});
    EXPECT_EQ(ending.code, ending.out.find(" works: ") == std::string::npos ? 3 : 0) << ending;
    EXPECT_THAT(ending.out, HasSubstr(ISOMOTION_SOURCE_DIR));
    EXPECT_THAT(ending.out, HasSubstr("\negl "));
    EXPECT_THAT(ending.out, HasSubstr("\nosmesa "));
    if (ending.code == 0) {
        EXPECT_THAT(ending.out, HasSubstr("OpenGL "));
        EXPECT_THAT(ending.out, HasSubstr("--stage "));
    }
}

TEST_F(Information, AFullPlaceForTheTextIsAnError) {
    const Ending ending =
        cli::run({"/bin/sh", "-c",
                  tested_program(ISOMOTION_PROGRAM) + " show sphere.toml --shader >/dev/full"},
                 circumstances());
    EXPECT_EQ(ending.code, 3) << ending;
    EXPECT_THAT(ending.err, HasSubstr("No space left"));
}

} // namespace
} // namespace isomotion::cli
