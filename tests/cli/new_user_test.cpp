// A new user's first five minutes, without a file of their own: a formula, a new scene, a movie, a
// file of Surfer, help.
#include "cli.h"

#include "app/examples.h"

namespace isomotion::cli {
namespace {

class NewUser : public Cli {
protected:
    std::vector<std::vector<float>> pixels(const std::string& name) const {
        std::vector<std::vector<float>> all;
        for (const auto& channel : image::decode(*this / name).channels)
            all.push_back(channel.samples);
        return all;
    }
};

TEST_F(NewUser, TheProgramAloneSaysWhatItIs) {
    const Ending ending = run(Words{});
    EXPECT_EQ(ending.code, 0) << ending;
    EXPECT_THAT(ending.out, StartsWith("isomotion renders implicit surfaces that move"));
    EXPECT_THAT(ending.out, HasSubstr("isomotion --help"));
}

TEST_F(NewUser, HelpBeginsWithAnExample) {
    for (const app::Example& example : app::examples) {
        const Ending ending = run({"help", std::string(example.command)});
        EXPECT_EQ(ending.code, 0) << ending;
        EXPECT_THAT(ending.out, StartsWith(std::string(example.line) + "\n"));
    }
    EXPECT_EQ(run({"help"}).out, run({"--help"}).out);
    EXPECT_EQ(run({"list", "help"}).out, run({"list", "--help"}).out);
}

// The examples that need neither a display nor minutes.
TEST_F(NewUser, TheExamplesOfHelpWork) {
    for (const app::Example& example : app::examples) {
        if (example.command == "play" || example.command == "submit") continue;
        const std::string line =
            std::string(ISOMOTION_PROGRAM).substr(0, std::string(ISOMOTION_PROGRAM).rfind('/'));
        const Ending ending =
            cli::run({"/bin/sh", "-c", "PATH=" + line + ":$PATH; " + std::string(example.line)},
                     circumstances());
        EXPECT_EQ(ending.code, 0) << example.line << "\n" << ending;
    }
    EXPECT_THAT(bytes("ring.toml"), HasSubstr("formula = "));
    EXPECT_THAT(bytes("b.mp4"), Not(IsEmpty()));
}

TEST_F(NewUser, ANewSceneIsRenderedAndNeverWrittenOver) {
    const Ending made = run({"new", "ring"});
    EXPECT_EQ(made.code, 0) << made;
    EXPECT_THAT(made.out, HasSubstr("isomotion render ring.toml"));
    render({"ring.toml", "--frame", "3", "--size", "32x32", "-o", "ring.png"});
    const std::string before = bytes("ring.toml");
    const Ending again = run({"new", "ring.toml"});
    EXPECT_EQ(again.code, 2) << again;
    EXPECT_EQ(again.err,
              "ring.toml: is there already and is not written over; name another file\n");
    EXPECT_EQ(bytes("ring.toml"), before);
    EXPECT_EQ(run({"new", "a\"b"}).code, 2);
    EXPECT_EQ(run({"new", "a\tb"}).code, 2);
    EXPECT_EQ(run({"new", "-"}).code, 2);
    EXPECT_EQ(run({"new", ".toml"}).code, 2);
    EXPECT_EQ(run({"new", "a\nb/c"}).code, 2);
    EXPECT_THAT(run({"new", "my ring"}).out, HasSubstr("isomotion render 'my ring.toml'"));
    EXPECT_EQ(run({"show", "my ring.toml"}).code, 0);
}

TEST_F(NewUser, APageIsWrittenOverNothingButPages) {
    run({"new", "ring"});
    const std::string before = bytes("ring.toml");
    const Ending refused = run({"page", "ring.toml", "-o", "ring.toml"});
    EXPECT_EQ(refused.code, 2) << refused;
    EXPECT_THAT(refused.err, HasSubstr("-o ring.toml: a page is an HTML file"));
    EXPECT_EQ(bytes("ring.toml"), before);
}

TEST_F(NewUser, AFormulaIsWrittenAsTheSceneFileThatItIs) {
    const std::string formula = "x^2 + y^2 + z^2 = a + 0.3*sin(9*x + t)";
    const Ending written = run({"show", formula, "--set", "a=1.1", "-o", "wave.toml"});
    EXPECT_EQ(written.code, 0) << written;
    const Words asked{"--frames", "1,40", "--size", "32x32"};
    Words by_formula{formula, "--set", "a=1.1", "-o", "a.##.png"};
    Words by_file{"wave.toml", "-o", "b.##.png"};
    by_formula.insert(by_formula.end(), asked.begin(), asked.end());
    by_file.insert(by_file.end(), asked.begin(), asked.end());
    render(by_formula);
    render(by_file);
    for (const char* frame : {"01", "40"}) {
        EXPECT_EQ(pixels(fmt::format("a.{}.png", frame)), pixels(fmt::format("b.{}.png", frame)));
    }
    EXPECT_EQ(run({"show", formula, "--set", "a=1", "-o", "wave.toml"}).code, 2);
    EXPECT_THAT(run({"show", formula, "--set", "a=1", "-o", "wave.png"}).err,
                HasSubstr("a scene file's name ends in .toml"));
}

TEST_F(NewUser, AFormulaMovesForEveryCommand) {
    const std::string formula = "x^2 + y^2 + z^2 = 1 - t";
    EXPECT_THAT(run({"show", formula, "--frames", "31-40"}).out,
                HasSubstr("frame     31 at t = 1 s"));
    const Ending topology = run({"topology", formula, "--frames", "1-60"});
    EXPECT_EQ(topology.code, 0) << topology;
    EXPECT_THAT(topology.out, HasSubstr("complete, all proved"));
    EXPECT_EQ(run({"accuracy", formula, "--frames", "3", "--size", "16x16", "--methods", "hermite",
                   "--quiet"})
                  .code,
              0);
    // More frames than a formula has by itself.
    render({formula, "--frames", "1-3x2", "--size", "8x8", "-o", "a.##.png"});
}

// These have none of the signs that only formulas have.
TEST_F(NewUser, AFormulaIsKnownByItsWords) {
    for (const char* formula :
         {"2x", "x y z", "5z", "x - y", "x/2", "xyz", "X", "Sin[x]", "½x", "x ≤ 0.5"})
        EXPECT_EQ(run({"show", formula}).code, 0) << formula;
    const std::pair<std::string, std::string> mistakes[] = {
        {"sin x", "sin needs parentheses: write 'sin(a)'"},
        {"sqrt x", "sqrt needs parentheses"},
        {"3", "the formula has the same value everywhere"},
        {"1=1", "the formula has the same value everywhere"},
        {"=x", "a value is expected before '='"},
        {"a x", "--set a=1 makes it a parameter"},
        {"|x|^n = 1", "--set n=1 makes it a parameter"},
        {"xyw", "xyw: no such file"},
        {"x.obj", "x.obj: no such file"},
    };
    for (const auto& [formula, message] : mistakes) {
        const Ending ending = run({"show", formula});
        EXPECT_EQ(ending.code, 2) << ending;
        EXPECT_THAT(ending.err, HasSubstr(message));
    }
}

TEST_F(NewUser, FramesThatASceneDoesNotHaveAreTold) {
    const std::string message = "--frames 61: the scene has frames 1 to 60; --set time.frames=61 "
                                "gives it more\n";
    EXPECT_EQ(run({"show", "sphere.toml", "--frame", "61"}).err, message);
    EXPECT_EQ(run({"accuracy", "sphere.toml", "--frames", "1,61"}).err, message);
    EXPECT_EQ(run({"show", "sphere.toml", "--frame", "61", "--set", "time.frames=61"}).code, 0);
    EXPECT_EQ(run({"show", "x", "--frame", "2"}).err,
              "--frames 2: the scene has one frame, 1; --set time.frames=2 gives it more\n");
}

TEST_F(NewUser, AnOutputThatIsAMovieIsOne) {
    render({"sphere.toml", "--frames", "1-4", "--size", "32x32", "-o", "out/x.mp4", "--movie",
            "y.gif", "--movie", "z.webm"});
    for (const char* movie : {"out/x.mp4", "y.gif", "z.webm"})
        EXPECT_THAT(bytes(movie), Not(IsEmpty()));
    EXPECT_THAT(bytes("out/x.0004.png"), Not(IsEmpty()));
}

TEST_F(NewUser, ASizeOfOneNumberIsToldTwo) {
    EXPECT_THAT(run({"render", "sphere.toml", "--size", "480"}).err,
                HasSubstr("--size 480: write WIDTHxHEIGHT, 480x480"));
}

TEST_F(NewUser, AFileOfSurferIsAScene) {
    write("ball.jsurf", "surface_equation=x^2+y^2+z^2-0.25*a\nsurface_parameter_a=1\n");
    render({"ball.jsurf", "--size", "16x16", "-o", "ball.png"});
    EXPECT_EQ(run({"show", "ball.jsurf", "-o", "ball.toml"}).code, 0);
    render({"ball.toml", "--size", "16x16", "-o", "again.png"});
    EXPECT_EQ(pixels("ball.png"), pixels("again.png"));
    const Ending none = run({"show", "none.jsurf"});
    EXPECT_EQ(none.err, "none.jsurf: no such file\n");
}

} // namespace
} // namespace isomotion::cli
