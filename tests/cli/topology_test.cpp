// The command `topology`: its files, its checks and its errors.
#include "cli.h"

namespace isomotion::cli {
namespace {

class Topology : public Cli {
protected:
    Topology() {
        write("two.json", R"({"components": {"1": 2}})");
        write("mege.json", R"({"events": ["no split", "mege at frame 3"]})");
        write("cut.timeline.json", R"({"format": "isomotion topology timeline", "version": 1)");
        write("new.timeline.json", R"({"format": "isomotion topology timeline", "version": 9})");
        files_ = names();
    }
    Ending topology(Words arguments) const {
        arguments.insert(arguments.begin(), {"topology", "sphere.toml"});
        return run(arguments);
    }

    std::set<std::string> files_;
};

TEST_F(Topology, AMistakeIsToldBeforeAnythingIsSearched) {
    const std::pair<Words, const char*> wrongs[] = {
        {{"--nope"}, "--nope"},
        {{"--certify", "maybe"}, "--certify maybe: write off, fast or full"},
        {{"--grid", "7", "--certify", "off"}, "--grid 7: write vertices along a side, 8 to 1024"},
        {{"--grid", "64"}, "--grid: proofs use no grid; write it with --certify off or fast"},
        {{"--frames", "abc"}, "'abc' is not a frame range"},
        {{"--frames", "5"}, "--frames 5: topology searches a span with all time in it; write 1-10"},
        {{"--frames", "1-9x2"}, "--frames 1-9x2: topology searches a span"},
        {{"--frames", "1,5"}, "--frames 1,5: topology searches a span"},
        {{"--frames", "9-1"}, "--frames 9-1: topology searches a span"},
        {{"-o", "a.txt"}, "-o a.txt: the name must end in .json: a.json"},
        {{"--csv", "a"}, "--csv a: the name must end in .csv: a.csv"},
        {{"--plot", "new/a.png"}, "--plot new/a.png: the name must end in .svg: new/a.svg"},
        {{"--backend", "dx"}, "unknown back end 'dx'"},
        {{"--solid", "up"}, "--solid up: write negative, where F < 0 is the solid"},
        {{"--solid", "ball=negative"},
         "--solid ball=negative: the scene has one surface; write --solid negative"},
        {{"--dt", "-1"}, "--dt -1: write seconds, 0 or more: 1e-9"},
        {{"--dt", "nan"}, "--dt nan: write seconds"},
        {{"--dt", "inf"}, "--dt inf: write seconds"},
        {{"--dt", "1e999"}, "--dt"},
        {{"--set", "rr=1"}, "parameters.rr: nothing uses this parameter"},
        {{"--check", "none.json"}, "none.json: no such file"},
        {{"--check", "mege.json"},
         "mege.json:1: events[1]: \"mege at frame 3\": there is no event 'mege'; did you mean "
         "'merge'?"},
        {{"--check", "cut.timeline.json"}, "cut.timeline.json: not valid JSON: parse error at"},
        {{"--check", "new.timeline.json"},
         "new.timeline.json:1: version: is 9, which this program"},
        {{"--set", "time.frames=1"}, "the scene has one frame, in which nothing happens"},
    };
    for (const auto& [arguments, message] : wrongs) {
        SCOPED_TRACE(message);
        const Ending ending = topology(arguments);
        EXPECT_EQ(ending.code, 2) << ending;
        EXPECT_THAT(ending.err, HasSubstr(message));
        EXPECT_THAT(ending.out, IsEmpty());
        EXPECT_EQ(names(), files_);
    }
}

TEST_F(Topology, WritesItsFilesAndMakesTheirFolders) {
    const Ending ending =
        topology({"--frames", "2-4", "--certify", "off", "-o", "new/s.timeline.json", "--csv",
                  "new/s.betti.csv", "--plot", "new/s.svg"});
    EXPECT_EQ(ending.code, 0) << ending;
    EXPECT_THAT(ending.out, StartsWith("Sphere: frames 2 to 4, "));
    EXPECT_THAT(bytes("new/s.timeline.json"),
                AllOf(HasSubstr("\"frames_per_second\": \"30000/1001\""),
                      HasSubstr("\"solid\": \"F < 0\"")));
    const std::string table = bytes("new/s.betti.csv");
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 4);
    EXPECT_THAT(bytes("new/s.svg"), HasSubstr("data:image/png;base64,iVBOR"));
    expect_only_whole_files();
}

// Bounds are found for what is searched: no ball leaves those of the scene's own frames.
TEST_F(Topology, FindsBoundsForAllFramesThatAreSearched) {
    const std::string text = R"toml([time]
frames = 10
[parameters]
h = "0.1*t"
[[surfaces]]
name = "a"
formula = "x^2 + y^2 + z^2 - 1"
bounds = { sphere = 2 }
[[surfaces]]
name = "b"
formula = "(x - 2)^2 + y^2 + (z - h)^2 - 0.5"
)toml";
    write("two.toml", text);
    for (const Words& arguments :
         {Words{"(x - a)^2 + y^2 + z^2 = 1", "--set", "a=t", "--frames", "1-200"},
          Words{"(x - a)^2 + y^2 + z^2 = 1", "--set", "a=t", "--set", "time.seconds=1", "--frames",
                "1-90"},
          Words{"two.toml", "--surface", "b", "--frames", "1-200"}}) {
        Words command{"topology"};
        command.insert(command.end(), arguments.begin(), arguments.end());
        const Ending ending = run(command);
        EXPECT_EQ(ending.code, 0) << ending;
        EXPECT_THAT(ending.out, HasSubstr("1 -> 1 components"));
        EXPECT_THAT(ending.out, HasSubstr("no event\n"));
    }
    const Ending drawn = run({"render", "(x - a)^2 + y^2 + z^2 = 1", "--set", "a=t", "--frames",
                              "150", "--size", "8x8", "-o", "ball.png"});
    EXPECT_THAT(drawn.err, HasSubstr("frames beyond 120 may be cut: bounds were found for frames 1 "
                                     "to 120; --set time.frames=150 finds them for all"));
}

TEST_F(Topology, WithoutADriverThePlotHasNoPictures) {
    Circumstances circumstances = this->circumstances();
    const Ending ending = run({"topology", "sphere.toml", "--frames", "1-2", "--certify", "off",
                               "--plot", "s.svg", "--backend", "egl"},
                              [&] {
                                  circumstances.environment["__EGL_VENDOR_LIBRARY_DIRS"] = "/none";
                                  circumstances.environment["__EGL_VENDOR_LIBRARY_FILENAMES"] =
                                      "/none.json";
                                  return circumstances;
                              }());
    EXPECT_EQ(ending.code, 0) << ending;
    EXPECT_THAT(bytes("s.svg"), StartsWith("<svg"));
    if (ending.err.empty()) GTEST_SKIP() << "there is an EGL that needs no vendor";
    EXPECT_THAT(ending.err, HasSubstr("no OpenGL here: s.svg has no pictures"));
    EXPECT_THAT(bytes("s.svg"), Not(HasSubstr("<image")));
}

// Without a check an incomplete timeline has an exit code of its own, and says what to change.
TEST_F(Topology, WhatStaysOpenHasAnExitCodeAndAdvice) {
    write("two.toml", R"toml(
[time]
frames = 21
fps = 20
[surface]
formula = "min(max(abs(x - d), abs(y), abs(z)) - 0.5, max(abs(x + d), abs(y), abs(z)) - 0.5)"
bounds = { box = [[-2, -2, -2], [2, 2, 2]] }
[parameters]
d = "0.8 - 0.6*t"
)toml");
    const Ending full = run({"topology", "two.toml"});
    EXPECT_EQ(full.code, 4) << full;
    EXPECT_THAT(full.out, HasSubstr("INCOMPLETE"));
    EXPECT_THAT(full.out, HasSubstr("\ntry: where faces meet that are parallel"));
    EXPECT_EQ(run({"topology", "two.toml", "--quiet"}).code, 4);
    // Nothing was to be proved.
    EXPECT_EQ(run({"topology", "two.toml", "--certify", "off"}).code, 0);
    // Beside the moment all is.
    const Ending before = run({"topology", "two.toml", "--frames", "1-8"});
    EXPECT_EQ(before.code, 0) << before;
    EXPECT_THAT(before.out, HasSubstr("complete, all proved"));
}

TEST_F(Topology, QuietSaysNothing) {
    const Ending ending = topology({"--frames", "1-3", "--certify", "off", "--quiet"});
    EXPECT_EQ(ending.code, 0) << ending;
    EXPECT_EQ(ending.out + ending.err, "");
}

TEST_F(Topology, ACheckOfItselfPasses) {
    const Ending first = topology({"--frames", "1-3", "-o", "s.timeline.json"});
    EXPECT_EQ(first.code, 0) << first;
    EXPECT_THAT(first.out, HasSubstr("\ncomplete, all proved\n"));
    const Ending again = topology({"--frames", "1-3", "--check", "s.timeline.json"});
    EXPECT_EQ(again.code, 0) << again;
    EXPECT_THAT(again.out, HasSubstr("s.timeline.json: passes, "));
}

// There is one sphere: the claim of two never passes.
TEST_F(Topology, AWrongClaimNeverPasses) {
    const Ending ending = topology({"--frames", "1-3", "--check", "two.json"});
    EXPECT_EQ(ending.code, 1) << ending;
    EXPECT_THAT(ending.err, HasSubstr("components.1 = 2: "));
    // Sampling proves nothing, so nothing fails either.
    EXPECT_EQ(topology({"--frames", "1-3", "--certify", "off", "--check", "two.json"}).code, 2);
}

// What cannot be written keeps back neither the judgement nor the other files.
TEST_F(Topology, OneFileThatCannotBeWrittenIsAllThatIsMissing) {
    write("taken", "a file, no folder");
    const Ending ending =
        topology({"--frames", "1-2", "--certify", "off", "-o", "taken/s.timeline.json", "--csv",
                  "s.csv", "--plot", "s.svg", "--check", "two.json"});
    EXPECT_EQ(ending.code, 3) << ending;
    EXPECT_THAT(ending.err, HasSubstr("components.1 = 2: "));
    EXPECT_THAT(ending.err, HasSubstr("taken"));
    EXPECT_THAT(bytes("s.csv"), StartsWith("frame,"));
    EXPECT_THAT(bytes("s.svg"), StartsWith("<svg"));
}

// Bounds that there are at whole frames only: all is known but for pictures in between.
TEST_F(Topology, APictureThatCannotBeDrawnIsAllThatIsMissing) {
    write("blink.toml", "[time]\nfps = 10\nframes = 3\n[surface]\n"
                        "formula = 'x^2 + y^2 + z^2 - 0.25'\n"
                        "bounds = { sphere = 'cos(20*pi*t)' }\n");
    const Ending ending = run(
        {"topology", "blink.toml", "--certify", "off", "--plot", "b.svg", "--check", "two.json"});
    EXPECT_EQ(ending.code, 2) << ending;
    EXPECT_THAT(ending.err, HasSubstr("components.1 = 2: "));
    EXPECT_THAT(ending.err, HasSubstr("warning: "));
    EXPECT_THAT(bytes("b.svg"), StartsWith("<svg"));
}

// A mistake that only the last frame has.
TEST_F(Topology, TheLastFrameIsLookedAtToo) {
    write("gone.toml", "[time]\nfps = 10\nframes = 3\n[surface]\n"
                       "formula = 'x^2 + y^2 + z^2 - 0.25'\n"
                       "bounds = { sphere = '1 - 6*t' }\n");
    const Ending ending = run({"topology", "gone.toml", "-o", "gone.json"});
    EXPECT_EQ(ending.code, 2) << ending;
    EXPECT_THAT(ending.err, HasSubstr("surface.bounds.sphere"));
    EXPECT_THAT(ending.err, HasSubstr("at t = 0.2"));
    EXPECT_THAT(ending.out, IsEmpty());
}

// A pea that flies through a ball and by a cube.
const std::string passing = R"(title = "Passing"
[time]
fps = 10
frames = 31
[[surfaces]]
name = "ball"
formula = "x^2 + y^2 + z^2 - 0.25"
bounds = { sphere = 0.7 }
transform = { translate = [10, 0, 0] }
[[surfaces]]
name = "pea"
formula = "x^2 + y^2 + z^2 - 0.09"
bounds = { sphere = 0.4 }
transform = { translate = ["11.5 - t", 0, 0] }
[[surfaces]]
name = "cube"
formula = "max(max(abs(x), abs(y)), abs(z)) - 0.5"
bounds = { sphere = 1 }
transform = { translate = [10, 2, 0] }
)";

TEST_F(Topology, TellsWhenEachTwoSurfacesTouch) {
    write("passing.toml", passing);
    const Ending all = run({"topology", "passing.toml"});
    EXPECT_EQ(all.code, 0) << all;
    EXPECT_EQ(all.out, "ball and pea touch at frame 8, 0.7 s, near (10.5, 0, 0), proved\n"
                       "ball and pea part at frame 24, 2.3 s, near (9.5, 0, 0), proved\n"
                       "ball and pea: complete, all proved\n"
                       "ball and cube never touch, proved\n"
                       "pea and cube never touch, proved\n");
    const Ending later = run({"topology", "passing.toml", "--frames", "10-20"});
    EXPECT_EQ(later.code, 0) << later;
    EXPECT_THAT(later.out, StartsWith("ball and pea are in contact at the start, proved\n"
                                      "ball and pea: complete, all proved\n"));
    // A solid of F > 0 is named, whoever chose it.
    const Ending outside = run({"topology", "passing.toml", "--contact", "ball", "cube", "--solid",
                                "cube=positive", "--frames", "10-12"});
    EXPECT_THAT(outside.out,
                StartsWith("cube: the solid is F > 0; --solid cube=negative takes F < 0"
                           "\nPassing (ball, cube): "));
    // A choice that names a surface holds, wherever one for each stands.
    const Ending named = run({"topology", "passing.toml", "--contact", "ball", "cube", "--solid",
                              "cube=positive", "--solid", "negative", "--frames", "10-12"});
    EXPECT_EQ(named.out, outside.out);
    // Parting at the very end is not told apart from staying.
    const Ending open = run({"topology", "passing.toml", "--frames", "10-24"});
    EXPECT_EQ(open.code, 4) << open;
    EXPECT_THAT(open.out, HasSubstr("ball and pea: INCOMPLETE\n    "));
}

TEST_F(Topology, ChecksTheContactOfTwoSurfaces) {
    write("passing.toml", passing);
    write("told.toml", "events = [\"one birth at frame 8\", \"one death at frame 24\", "
                       "\"nothing else\"]\n");
    const Words ask{"topology", "passing.toml", "--contact", "pea", "ball"};
    const auto with = [&](Words more) {
        Words all = ask;
        all.insert(all.end(), more.begin(), more.end());
        return run(all);
    };
    const Ending told = with({"--check", "told.toml", "-o", "a.timeline.json", "--plot", "a.svg"});
    EXPECT_EQ(told.code, 0) << told;
    EXPECT_THAT(told.out, StartsWith("Passing (pea, ball): frames 1 to 31"));
    EXPECT_THAT(told.out, HasSubstr("told.toml: passes"));
    EXPECT_THAT(bytes("a.svg"), StartsWith("<svg"));
    EXPECT_EQ(with({"--check", "a.timeline.json"}).code, 0);
    // The contact of others, and at another place, is another.
    const Ending moved = with(
        {"--check", "a.timeline.json", "--set", "surfaces.ball.transform.translate=[9, 0, 0]"});
    EXPECT_EQ(moved.code, 1) << moved;
    EXPECT_THAT(moved.err, HasSubstr("the scene is not the one that"));
}

TEST_F(Topology, SeveralSurfacesAreAskedOneByOneOrTwoByTwo) {
    write("passing.toml", passing);
    const std::pair<Words, const char*> wrongs[] = {
        {{"--contact", "ball"}, "--contact"},
        {{"--contact", "ball", "ball"}, "--contact ball ball: name two surfaces of the scene"},
        {{"--contact", "ball", "bal"},
         "--contact bal: the scene has no such surface; it has ball, pea, cube"},
        {{"--contact", "ball", "pea", "--surface", "pea"}, "--surface"},
        {{"--contact", "ball", "pea", "--certify", "fast"},
         "--certify fast: contact of surfaces is proved or not found"},
        {{"--certify", "off"}, "name one surface by --surface NAME"},
        {{"--solid", "bal=negative"},
         "--solid bal: the scene has no such surface; it has ball, pea, cube"},
        {{"--surface", "pea", "--solid", "ball=negative"},
         "--solid ball: that surface is not searched"},
        {{"-o", "a.json"}, "-o: the scene has several surfaces; name one by --surface NAME"},
        {{"--check", "two.json"}, "--check: the scene has several surfaces"},
    };
    for (const auto& [arguments, message] : wrongs) {
        SCOPED_TRACE(message);
        Words all{"topology", "passing.toml"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        const Ending ending = run(all);
        EXPECT_EQ(ending.code, 2) << ending;
        EXPECT_THAT(ending.err, HasSubstr(message));
        EXPECT_THAT(ending.out, IsEmpty());
    }
    EXPECT_THAT(topology({"--contact", "a", "b"}).err,
                HasSubstr("has one surface; leave --contact out"));
}

} // namespace
} // namespace isomotion::cli
