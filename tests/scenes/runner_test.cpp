// What is wrong with a scene file, or with its pictures, fails its test and says where.
#include <fstream>

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include "scenes/check.h"
#include "unit/base/places.h"

namespace isomotion::scenes {
namespace {

constexpr const char* ball = R"toml([surface]
formula = "x^2 + y^2 + z^2 - 1"
bounds = { sphere = 1.5 }
[output]
size = [32, 32]
)toml";

struct Wrong {
    const char *expect, *words; // from [expect] on, and of the message
};

const Wrong wrong_files[] = {
    {"", "no line [expect]"},
    {"[expect]\n", "expects nothing of the test"},
    {"[expect]\ntests = [\n", "wrong.toml:7: not valid TOML"},
    {"[expect]\nthta = []\n", "wrong.toml:7: expect.thta: unknown key"},
    {"[[expect.that]]\nis = 'R > 0'\nwihtin = 1\n", "wrong.toml:8: expect.that[0].wihtin: unknown"},
    {"[[expect.that]]\nis = 3\n", "wrong.toml:7: expect.that[0].is: must be a text"},
    {"[[expect.that]]\nwhere = 'R > 0'\n", "has no key 'is'"},
    {"[[expect.that]]\ntests = 'none'\nis = 'R > 0'\n", "there is no test none"},
    {"[[expect.truth]]\nof = 'moon'\n", "there is no picture 'moon'"},
    {"[[expect.that]]\nis = 'Q = 1'\n", "unknown name 'Q'"},
    {"[[expect.that]]\nis = 'R'\n", "write a relation"},
    {"[[expect.that]]\nis = 'R == 1'\n", "the relations are"},
    {"[[expect.that]]\nis = '{nowhere} = 1'\n", "unexpected '{'"},
    {"[expect]\nmethods = { wrong_ppm = { amp-sign = 0 } }\n", "has no key 'default'"},
    {"[expect]\nmethods = { wrong_ppm = { default = 0, amp = 0 } }\n", "amp is no method"},
    {"[expect]\nrefused = 'moon'\n", "is drawn, and nothing is wrong"},
    {"[[expect.that]]\nwhere = 'R > 100'\nis = 'R = 1'\n", "actual: 0 vs 1"},
    {"[[expect.that]]\nwhere = 'hit = 1'\nis = 'x^2 + y^2 + z^2 = 1.1'\nwithin = 0.01\n",
     "x^2 + y^2 + z^2 = 1.1: 1.0"},
    {"[[expect.that]]\nis = 'R > 0'\ncounts = 'hits > 1000'\n", "hits > 1000: "},
    {"[expect]\nlook = { set = 'isolation.method=amp-sign' }\n"
     "pictures = { other = { set = 'surface.formula=x^2+y^2+z^2-1.2' } }\n"
     "[[expect.that]]\nis = 'Z = other_Z'\nbut = 5\n",
     "Z = other_Z: "},
};

TEST(SceneRunner, TellsWhatIsWrong) {
    const base::TemporaryFolder folder;
    const auto context = gpu::Context::create();
    for (const auto& [expect, words] : wrong_files) {
        std::ofstream(folder / "wrong.toml") << ball << expect;
        testing::TestPartResultArray results;
        std::string told;
        {
            const testing::ScopedFakeTestPartResultReporter reporter(
                testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &results);
            try {
                const SceneFile file(folder / "wrong.toml");
                check(file, "wrong", *context);
            } catch (const std::exception& error) {
                told = error.what();
            }
        }
        for (int k = 0; k < results.size(); ++k) told += results.GetTestPartResult(k).message();
        EXPECT_NE(told.find(words), told.npos) << expect << "says\n" << told;
    }
}

TEST(SceneRunner, PutsValuesInTheirPlaces) {
    const Values values{{"a", "2"}, {"b", "{a}"}, {"which", "a"}, {"box", "{ sphere = {a} }"}};
    EXPECT_EQ(with_values("{a} {b} {{which}} {box} {=3*a + 1} { a } {c}", values),
              "2 2 2 { sphere = 2 } 7 { a } {c}");
    EXPECT_EQ(with_values("1{3 times k:  + {a}*x^<k>}", values), "1 + 2*x^1 + 2*x^2 + 2*x^3");
    EXPECT_THROW(with_values("{a}", {{"a", "{a}"}}), std::invalid_argument);
}

} // namespace
} // namespace isomotion::scenes
