// Sequences of frames: movies of them, scenes that stand still, and what is said about them.
#include "cli.h"

#include <fmt/format.h>

namespace isomotion::cli {
namespace {

class Sequence : public Cli {
protected:
    // A program on PATH, or nothing.
    static std::string program(const std::string& name) {
        const Ending ending = cli::run({"/bin/sh", "-c", "command -v " + name}, {});
        return ending.out.substr(0, ending.out.find('\n'));
    }
    // "width,height,rate,frames"
    std::string probed(const std::string& movie) const {
        const Ending ending =
            cli::run({program("ffprobe"), "-v", "error", "-count_frames", "-show_entries",
                      "stream=width,height,r_frame_rate,nb_read_frames", "-of", "csv=p=0", movie},
                     {.folder = folder()});
        EXPECT_EQ(ending.code, 0) << ending;
        return ending.out.substr(0, ending.out.find('\n'));
    }
};

// Processes of their own load it again by its words.
TEST_F(Sequence, AFormulaIsRenderedAndSubmitted) {
    const std::string formula = "x^2 + y^2 + z^2 = 1 + 0.3*sin(9*x + t)";
    const Ending rendered = render({formula, "--frames", "1-3", "-o", "a.####.png"});
    EXPECT_EQ(rendered.code, 0) << rendered;
    write("formula.toml", "[surface]\nformula = \"x\"\n"); // is another scene
    const Ending submitted = run({"submit", formula, "--frames", "1-3", "--size", "16x16",
                                  "--workers", "2", "-o", "b.####.png"});
    EXPECT_EQ(submitted.code, 0) << submitted;
    EXPECT_TRUE(std::filesystem::exists(*this / "b.0003.png"));
    EXPECT_NE(bytes("a.0001.png"), bytes("a.0003.png")) << "it moves";
    const Ending shown = run({"show", formula});
    EXPECT_THAT(shown.out, HasSubstr("which holds the surface at all frames"));
}

TEST_F(Sequence, MovieHasEveryFrame) {
    if (program("ffmpeg").empty()) GTEST_SKIP() << "ffmpeg is not installed";
    for (const std::string movie : {"m/a.mp4", "m/a.webm", "m/a.gif"}) {
        const Ending ending = render({"sphere.toml", "--set", "time.fps=25", "--frames", "1-7",
                                      "--resume", "-o", "a.####.png", "--movie", movie});
        EXPECT_THAT(ending.out, HasSubstr("\nmovie: " + movie + "\n"));
        EXPECT_GT(std::filesystem::file_size(*this / movie), 100u);
        if (!program("ffprobe").empty()) {
            EXPECT_EQ(probed(movie), "48,48,25/1,7") << movie;
        }
    }
    expect_only_whole_files();
    EXPECT_EQ(names("m").size(), 3u);
    if (program("ffprobe").empty()) GTEST_SKIP() << "ffprobe is not installed: frames uncounted";
}

TEST_F(Sequence, PosterIsTheFrameThatTheSceneNames) {
    render({"sphere.toml", "--set", "output.poster=7", "--frames", "poster", "-o", "a.##.png"});
    render({"sphere.toml", "--set", "output.poster=3", "--frames", "7", "-o", "b.##.png"});
    EXPECT_EQ(bytes("a.07.png"), bytes("b.07.png"));
    EXPECT_EQ(names(), (std::set<std::string>{"sphere.toml", "a.07.png", "a.##.png.manifest",
                                              "b.07.png", "b.##.png.manifest"}));
    const Ending beyond =
        run({"render", "sphere.toml", "--set", "output.poster=61", "--frames", "poster"});
    EXPECT_EQ(beyond.code, 2) << beyond;
    EXPECT_THAT(beyond.err,
                HasSubstr("output.poster: must be from 1 to 60, a frame of the scene, not 61"));
}

TEST_F(Sequence, WithoutFfmpegNothingIsDrawn) {
    Circumstances circumstances = this->circumstances();
    circumstances.environment["PATH"] = folder().string();
    const Ending ending =
        run({"render", "sphere.toml", "--frames", "1-3", "-o", "a.####.png", "--movie", "a.mp4"},
            circumstances);
    EXPECT_EQ(ending.code, 3) << ending;
    EXPECT_THAT(ending.err, HasSubstr("ffmpeg is not on PATH: install it"));
    EXPECT_EQ(names(), std::set<std::string>{"sphere.toml"});
}

TEST_F(Sequence, ASceneThatStandsStillIsDrawnOnce) {
    const Ending ending =
        render({"sphere.toml", "--set", "r=1", "--frames", "1-9", "-o", "a.#.exr"});
    EXPECT_THAT(ending.out, HasSubstr("\ndrawn 1 in "));
    EXPECT_THAT(ending.out, HasSubstr("\n8 frames equal to the one before\n"));
    const auto first = image::decode(*this / "a.1.exr"), last = image::decode(*this / "a.9.exr");
    EXPECT_EQ(first.find("R")->samples, last.find("R")->samples);
    EXPECT_EQ(image::to_text(*image::find(last.metadata, "isomotion:frame")), "9");
}

TEST_F(Sequence, ASummaryCountsEveryRay) {
    const Ending ending =
        render({"sphere.toml", "--frames", "1-3", "--size", "10x10", "-o", "a.#.png"});
    int miss = 0, hit = 0;
    const std::size_t rays = ending.out.find("\nrays: ");
    ASSERT_NE(rays, std::string::npos);
    ASSERT_EQ(std::sscanf(ending.out.c_str() + rays, "\nrays: %d miss, %d hit", &miss, &hit), 2);
    EXPECT_EQ(miss + hit, 3 * 10 * 10);
    EXPECT_GT(hit, 0);
    EXPECT_THAT(ending.out, HasSubstr("\ndrawn 3 in "));
    EXPECT_THAT(ending.out, HasSubstr("\nframes: a.#.png\n"));
}

TEST_F(Sequence, QuietSaysNothing) {
    const Ending ending = render({"sphere.toml", "--frames", "1-2", "-o", "a.#.png", "--quiet"});
    EXPECT_THAT(ending.out, IsEmpty());
    EXPECT_EQ(names(),
              (std::set<std::string>{"sphere.toml", "a.1.png", "a.2.png", "a.#.png.manifest"}));
}

TEST_F(Sequence, FramesHaveAPlaceOfTheirOwnByDefault) {
    render({"sphere.toml", "--frames", "3"});
    EXPECT_EQ(names("out"), (std::set<std::string>{"sphere.0003.png", "sphere.manifest"}));
    for (const std::string name : {"take#2", "50%done", "a%d"}) {
        write(name + ".toml", sphere_scene());
        render({name + ".toml", "--frames", "3"});
        EXPECT_EQ(run({"verify", "out"}).code, 0) << name;
    }
    EXPECT_TRUE(names("out").contains("take_2.0003.png"));
}

} // namespace
} // namespace isomotion::cli
