// A wrong command line: exit code 2, a message that says what would be right, and nothing made.
#include "cli.h"

namespace isomotion::cli {
namespace {

struct WrongUsage {
    const char* name;
    Words arguments; // after `render sphere.toml`
    std::string message;
};

const WrongUsage wrong_usages[] = {
    {"unknown flag", {"--nope"}, "--nope"},
    {"frames of letters", {"--frames", "abc"}, "'abc' is not a frame range: write a frame (5)"},
    {"frame zero", {"--frames", "0"}, "frames and steps count from 1"},
    {"frames without end", {"--frames", "3-"}, "'3-' is not a frame range"},
    {"frames with empty part", {"--frames", "1,,2"}, "is not a frame range"},
    {"frames with step zero", {"--frames", "1-5x0"}, "frames and steps count from 1"},
    {"size of one number", {"--size", "64"}, "--size 64: write WIDTHxHEIGHT, 64x64"},
    {"size of letters", {"--size", "axb"}, "--size axb: write WIDTHxHEIGHT"},
    {"size of three", {"--size", "4x4x4"}, "--size 4x4x4: write WIDTHxHEIGHT"},
    {"size zero", {"--size", "0x64"}, "--size 0x64: write WIDTHxHEIGHT"},
    {"size too large", {"--size", "99999x64"}, "--size 99999x64: a picture has at most 16384"},
    {"unknown method", {"--method", "guess"}, "--method: there is no method 'guess'; known: march"},
    {"step of letters", {"--step", "small"}, "--step small: write a length above 0"},
    {"negative step", {"--step", "-1"}, "--step -1: write a length above 0"},
    {"unknown backend", {"--backend", "dx", "-o", "new/a.####.png"}, "unknown back end 'dx'"},
    {"unknown stage", {"--stage", "vertex"}, "--stage: there is no stage 'vertex'; known: fragm"},
    {"unknown channel", {"-o", "a.####.exr", "--channels", "z,depth"}, "no channel 'depth'; known"},
    {"channels to PNG", {"-o", "a.####.png", "--channels", "z"}, "write an EXR: a.####.exr"},
    {"unknown extension", {"-o", "a.####.jpg"}, "unknown extension .jpg"},
    {"no extension", {"-o", "a.####"}, "a picture's name ends in .png or .exr"},
    {"output is folder", {"-o", "new/"}, "names a folder"},
    {"no place for numbers", {"-o", "a.png"}, "put #### where their number goes, as in a.####.png"},
    {"two places for numbers", {"-o", "a.##.##.png"}, "two places for the frame's number"},
    {"accuracy below 0",
     {"--max-wrong", "-1"},
     "--max-wrong -1: write wrong pixels in a million, 0 or more: 10"},
    {"accuracy of no number", {"--max-wrong", "nan"}, "--max-wrong nan: write wrong pixels"},
    {"accuracy without end", {"--max-wrong", "inf"}, "--max-wrong inf: write wrong pixels"},
    {"twelve bits", {"--bits", "12"}, "--bits"},
    {"output of nothing", {"-o", ""}, "is given without a value"},
    {"frames of nothing", {"--frames", ""}, "is given without a value"},
    {"movie of nothing", {"--movie="}, "--movie"},
    {"digits without end", {"-o", std::string(100'000, '#') + ".png"}, "at most 32 digits"},
    {"name of no text", {"-o", "a\xff.##.png"}, "must be UTF-8 that can be printed"},
    {"unknown movie", {"--movie", "new/a.avi"}, "--movie new/a.avi: a movie's name ends in .mp4"},
    {"set without value", {"--set", "r"}, "--set r: write name=value"},
    {"set to nothing", {"--set", "r="}, "--set r=: write name=value"},
    {"set of unknown name", {"--set", "rr=1"}, "parameters.rr: nothing uses this parameter"},
    {"set of unknown key",
     {"--set", "camera.fob=9"},
     "camera.fob: unknown key; did you mean 'fov'?"},
    {"set inside a text", {"--set", "title.x=1"}, "'title' is not a table"},
    {"set to bad expression", {"--set", "r=1+"}, "--set: parameters.r:"},
    {"set to NaN", {"--set", "r=nan"}, "parameters.r: must be finite"},
    {"set out of range", {"--set", "camera.fov=200"}, "must be above 0 and below 180"},
};

// One test for all: starting a test takes as long as starting the program.
TEST_F(Cli, AWrongOptionIsToldAndMakesNothing) {
    for (const WrongUsage& wrong : wrong_usages) {
        SCOPED_TRACE(wrong.name);
        Words arguments{"render", "sphere.toml"};
        arguments.insert(arguments.end(), wrong.arguments.begin(), wrong.arguments.end());
        const Ending ending = run(arguments);
        EXPECT_EQ(ending.code, 2) << ending;
        EXPECT_THAT(ending.err, HasSubstr(wrong.message));
        EXPECT_THAT(ending.out, IsEmpty());
        EXPECT_EQ(names(), std::set<std::string>{"sphere.toml"});
    }
}

TEST_F(Cli, AWrongCommandPointsToHelp) {
    for (const Words& arguments : {Words{"draw"}, {"render"}, {"list", "colours"}, {"show"}}) {
        const Ending ending = run(arguments);
        EXPECT_EQ(ending.code, 2) << ending;
        EXPECT_THAT(ending.err, HasSubstr("--help"));
        EXPECT_THAT(ending.out, IsEmpty());
    }
}

TEST_F(Cli, ASettingTakesOneValueSoThatTheSceneMayFollow) {
    render({"--set", "r=0.5", "--set", "camera.fov=30", "sphere.toml", "--frames", "1", "-o",
            "a.exr"});
    const image::Frame frame = image::decode(*this / "a.exr");
    EXPECT_EQ(image::to_text(*image::find(frame.metadata, "isomotion:parameter.r")), "0.5");
    EXPECT_EQ(image::to_text(*image::find(frame.metadata, "isomotion:camera.fov")), "30");
}

} // namespace
} // namespace isomotion::cli
