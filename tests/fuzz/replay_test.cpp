// The fuzzers' bodies over their corpus, and over what they once found: each file of found/ made
// the program crash, hang or say what is wrong before it was mended, and is named after why.
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>

#include "fuzz/generated_glsl.h"
#include "fuzz/targets.h"

namespace isomotion::fuzz {
namespace {

namespace fs = std::filesystem;

struct Input {
    fs::path file;
    void (*target)(std::string_view);
};

std::vector<Input> inputs() {
    std::vector<Input> all;
    const fs::path folder = ISOMOTION_SOURCE_DIR "/tests/fuzz";
    for (const char* from : {"corpus", "found"}) {
        for (const auto& [name, target] : {std::pair("claims", &claims),
                                           {"command_line", &command_line},
                                           {"formula", &formula},
                                           {"manifest", &manifest},
                                           {"picture", &picture},
                                           {"scene", &scene},
                                           {"table", &table},
                                           {"timeline", &timeline}}) {
            if (!fs::exists(folder / from / name)) continue; // nothing was found yet
            for (const auto& entry : fs::directory_iterator(folder / from / name)) {
                all.push_back({entry.path(), target});
            }
        }
    }
    std::ranges::sort(all, {}, &Input::file);
    return all;
}

class Replay : public testing::TestWithParam<Input> {};

TEST_P(Replay, Holds) {
    std::ostringstream text;
    text << std::ifstream(GetParam().file, std::ios::binary).rdbuf();
    EXPECT_NO_THROW(GetParam().target(text.str())) << text.str();
}

INSTANTIATE_TEST_SUITE_P(Files, Replay, testing::ValuesIn(inputs()), [](const auto& input) {
    std::string name = input.param.file.parent_path().filename().string() + "_" +
                       input.param.file.filename().string();
    for (char& c : name) {
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    }
    return name;
});

// The check itself: what must not be let through isn't.
TEST(GeneratedGlsl, WhatIsNotOfTheGeneratorIsFound) {
    EXPECT_NO_THROW(check_generated("float field(vec3 p) { return im_sin(p.x) - 1e-05; }\n"));
    for (const char* foreign :
         {"float radius = 1.0;", "discard;", "#define v1", "v1 // x", "v1 /* x", "v1 = \"a\";",
          "v1 = 1e39;", "v1 = nan;", "v1 = inf;", "v1\\\n", "v\xC3\xA9", "gl_FragDepth = v1;"}) {
        EXPECT_THROW(check_generated(foreign), Violation) << foreign;
    }
}

TEST(GeneratedGlsl, CommentsAreToldFromCode) {
    const std::string text = "a // b /* c\nd /* e // f\n*/ g // h";
    EXPECT_EQ(without_comments(text), "a \nd  g ");
    EXPECT_THAT(comments(text), testing::ElementsAre(" b /* c", " e // f\n", " h"));
}

} // namespace
} // namespace isomotion::fuzz
