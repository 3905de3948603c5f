// No output replaces what a command reads, by whichever name.
#include <filesystem>

#include "cli.h"

namespace isomotion::cli {
namespace {

namespace fs = std::filesystem;

class InputsStay : public Cli {
protected:
    InputsStay() {
        write("elements.csv", "cx,r\n0,0.5\n1,0.5\n");
        write("a.0003.csv", "cx,r\n0,0.5\n");
        write("drops.toml", scene("elements.csv"));
    }
    static std::string scene(const std::string& table) {
        return "[time]\nframes = 4\n[surface]\n"
               "formula = 'sum(p, r^2/((x-cx)^2 + y^2 + z^2 + 0.1)) - 1'\n"
               "bounds = { sphere = 3 }\n[arrays.p]\nfile = '" +
               table + "'\n";
    }
    void expect_refused(const Words& words, const std::string& option, const std::string& input,
                        const std::string& data = ISOMOTION_SOURCE_DIR) {
        const std::string before = bytes(input);
        Circumstances circumstances = this->circumstances();
        circumstances.environment["ISOMOTION_DATA"] = data;
        const Ending ending = run(words, circumstances);
        EXPECT_EQ(ending.code, 2) << ending;
        EXPECT_THAT(ending.err, testing::StartsWith(option + " "));
        EXPECT_THAT(ending.err, HasSubstr("would replace"));
        EXPECT_THAT(ending.err, HasSubstr(input + ", which is read for it"));
        EXPECT_EQ(bytes(input), before);
    }
};

TEST_F(InputsStay, WhateverTheCommand) {
    expect_refused({"topology", "drops.toml", "--csv", "elements.csv"}, "--csv", "elements.csv");
    expect_refused({"topology", "drops.toml", "--csv", "./elements.csv"}, "--csv", "elements.csv");
    expect_refused({"play", "drops.toml", "--log", "drops.toml"}, "--log", "drops.toml");
    fs::create_directory_symlink(".", *this / "here");
    expect_refused({"play", "drops.toml", "--log", "here/elements.csv"}, "--log", "elements.csv");
    fs::create_hard_link(*this / "elements.csv", *this / "other.html");
    expect_refused({"page", "drops.toml", "-o", "other.html"}, "-o", "elements.csv");
    fs::create_directory(*this / "report");
    fs::create_hard_link(*this / "elements.csv", *this / "report/accuracy.csv");
    expect_refused({"accuracy", "drops.toml", "-o", "report"}, "-o", "elements.csv");
    write("claims.json", "{}");
    fs::create_symlink("claims.json", *this / "t.json");
    expect_refused({"topology", "drops.toml", "--check", "claims.json", "-o", "t.json"}, "-o",
                   "claims.json");
}

TEST_F(InputsStay, WhateverTheFrame) {
    fs::create_hard_link(*this / "a.0003.csv", *this / "f.0003.png");
    write("named.toml", scene("a.0003.csv"));
    for (const char* verb : {"render", "submit"})
        expect_refused({verb, "named.toml", "-o", "f.####.png"}, "-o", "a.0003.csv");
    EXPECT_FALSE(fs::exists(*this / "f.0001.png"));
}

// Without a scene the window shows the gallery, and may read any of it.
TEST_F(InputsStay, WhateverOfTheGallery) {
    fs::create_directories(*this / "data/shaders");
    fs::create_directories(*this / "data/animations");
    write("data/animations/c.toml",
          "[surface]\nformula = 'x^2 + y^2 + z^2 - 1'\nbounds.sphere = 2\n");
    write("data/animations/wrong.toml", "[surface]\n");
    for (const std::string name : {"data/animations/c.toml", "data/animations/wrong.toml"})
        expect_refused({"play", "--log", name}, "--log", name, (*this / "data").string());
}

} // namespace
} // namespace isomotion::cli
