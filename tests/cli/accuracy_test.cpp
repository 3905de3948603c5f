// The command `accuracy`, and `render --max-wrong`.
#include "cli.h"

namespace isomotion::cli {
namespace {

class Accuracy : public Cli {
protected:
    // Truth is remembered below the test's own folder.
    Ending run_here(const Words& arguments) const {
        Circumstances circumstances = this->circumstances();
        circumstances.environment["XDG_CACHE_HOME"] = (*this / "cache").string();
        return run(arguments, circumstances);
    }
};

TEST_F(Accuracy, PrintsALineForEachSetting) {
    const Ending ending = run_here({"accuracy", "sphere.toml", "--size", "32x32", "--methods",
                                    "marching,amp-sign", "--steps", "0.2,0.1", "--repeat", "1"});
    EXPECT_EQ(ending.code, 0) << ending;
    for (const char* setting : {"marching step=0.2", "marching step=0.1", "amp-sign step=0.2",
                                "amp-sign step=0.1", "wrong ppm"}) {
        EXPECT_THAT(ending.out, HasSubstr(setting));
    }
    EXPECT_THAT(ending.out, Not(HasSubstr("amp-taylor")));
    EXPECT_TRUE(std::filesystem::exists(*this / "cache/isomotion/truth"));
}

TEST_F(Accuracy, WritesAReport) {
    const Ending ending = run_here({"accuracy", "sphere.toml", "--size", "32x32", "--steps", "0.1",
                                    "--repeat", "1", "--quiet", "-o", "r"});
    if (ending.code == 3) {
        EXPECT_THAT(ending.err, HasSubstr("gnuplot-nox"));
        GTEST_SKIP() << "gnuplot is not installed";
    }
    EXPECT_EQ(ending.code, 0) << ending;
    EXPECT_EQ(ending.out, "");
    for (const char* file : {"r/index.html", "r/accuracy.csv", "r/accuracy.svg"}) {
        EXPECT_TRUE(std::filesystem::exists(*this / file)) << file;
    }
}

TEST_F(Accuracy, ChecksEndWithTheirCode) {
    const Words sweep{"accuracy", "sphere.toml", "--size",   "32x32", "--methods", "marching",
                      "--steps",  "0.5,0.01",    "--repeat", "1",     "--quiet"};
    const auto with = [&](std::initializer_list<const char*> more) {
        Words all = sweep;
        all.insert(all.end(), more.begin(), more.end());
        return run_here(all);
    };
    const Ending right = with({"--max-wrong", "2000"});
    EXPECT_EQ(right.code, 0) << right;
    EXPECT_THAT(right.out, StartsWith("cheapest: marching step=0.01 ("));
    EXPECT_EQ(with({"--budget-ms", "1e9"}).code, 0);
    const Ending slow = with({"--budget-ms", "1e-9"});
    EXPECT_EQ(slow.code, 1) << slow;
    EXPECT_THAT(slow.err, HasSubstr("no setting takes at most 1e-09 ms a frame"));
}

TEST_F(Accuracy, TellsALimitThatIsNoAmount) {
    const std::pair<Words, const char*> wrongs[] = {
        {{"--max-wrong", "nan"}, "--max-wrong nan: write wrong pixels in a million, 0 or more: 10"},
        {{"--max-wrong", "-1"}, "--max-wrong -1: write"},
        {{"--budget-ms", "nan"}, "--budget-ms nan: write milliseconds a frame, 0 or more: 16"},
        {{"--budget-ms", "-5"}, "--budget-ms -5: write"},
        {{"--budget-ms", "inf"}, "--budget-ms inf: write"},
    };
    for (const auto& [arguments, message] : wrongs) {
        SCOPED_TRACE(message);
        Words all{"accuracy", "sphere.toml"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        const Ending ending = run_here(all);
        EXPECT_EQ(ending.code, 2) << ending;
        EXPECT_THAT(ending.err, HasSubstr(message));
        EXPECT_THAT(ending.out, IsEmpty());
    }
}

TEST_F(Accuracy, RenderTakesTheCheapestThatIsRightEnough) {
    // The scene's own setting takes a thousand samples a ray, so that no load makes it the
    // cheapest.
    const Ending ending = run_here({"render", "sphere.toml", "--frames", "1-2", "--max-wrong",
                                    "5000", "--set", "isolation.method=\"marching\"", "--set",
                                    "isolation.step=0.001", "-o", "a.##.png"});
    EXPECT_EQ(ending.code, 0) << ending;
    EXPECT_THAT(ending.out, HasSubstr(" ppm wrong, "));
    EXPECT_THAT(ending.out, HasSubstr("instead of marching step=0.001")); // what the choice gains
    EXPECT_EQ(names().count("a.02.png"), 1u);
    // A plate so thin that every step of the sweep passes over it.
    write("plate.toml", "[surface]\nformula = \"x^2 - 1e-8\"\nbounds = { sphere = 1 }\n"
                        "[camera]\nposition = [5, 0.3, 0.2]\n[output]\nsize = [48, 48]\n");
    const Ending none = run_here(
        {"render", "plate.toml", "--max-wrong", "0", "--method", "marching", "-o", "n.png"});
    EXPECT_EQ(none.code, 1) << none;
    EXPECT_THAT(none.err, HasSubstr("--max-wrong 0: no setting is that accurate"));
}

// A surface that every step passes over, and one that any finds: each has its own setting.
TEST_F(Accuracy, RenderChoosesForEachSurface) {
    const auto two = [&](const char* formula) {
        write("two.toml", std::string("[[surfaces]]\nname = \"plate\"\nformula = \"") + formula +
                              "\"\nbounds = { sphere = 1 }\ntransform = { translate = [0, 2, 0] }\n"
                              "[[surfaces]]\nname = \"ball\"\nformula = \"x^2 + y^2 + z^2 - 1\"\n"
                              "bounds = { sphere = 1.5 }\n[camera]\nposition = [8, 0.3, 0.2]\n"
                              "[output]\nsize = [48, 48]\n");
        return run_here(
            {"render", "two.toml", "--max-wrong", "2000", "--method", "marching", "-o", "t.png"});
    };
    const Ending right = two("x - 0.1*y");
    EXPECT_EQ(right.code, 0) << right;
    EXPECT_THAT(right.out, HasSubstr("surface plate\n"));
    EXPECT_THAT(right.out, HasSubstr("surface ball\n"));
    EXPECT_THAT(right.out, HasSubstr("together: "));
    EXPECT_EQ(names().count("t.png"), 1u);
    const Ending none = two("x^2 - 1e-8");
    EXPECT_EQ(none.code, 1) << none;
    EXPECT_THAT(none.err, HasSubstr("no setting is that accurate"));
}

TEST_F(Accuracy, MistakesNameTheOption) {
    for (const auto& [arguments, message] : std::vector<std::pair<Words, std::string>>{
             {{"--methods", "newton"}, "--methods newton: there is no method 'newton'"},
             {{"--steps", "0.1,x"}, "--steps 0.1,x: 'x' is no step"},
             {{"--steps", "0"}, "--steps 0: '0' is no step"},
             {{"--frames", "0"}, "frame"},
             {{"--size", "0x1"}, "--size"}}) {
        Words all{"accuracy", "sphere.toml"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        const Ending ending = run_here(all);
        EXPECT_EQ(ending.code, 2) << ending;
        EXPECT_THAT(ending.err, HasSubstr(message));
    }
}

} // namespace
} // namespace isomotion::cli
