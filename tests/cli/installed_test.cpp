// The installed program finds its shaders and animations from wherever it is called.
#include "cli.h"

namespace isomotion::cli {
namespace {

class Installed : public Cli {
protected:
    void SetUp() override {
        const Ending ending = cli::run(
            {CMAKE_PROGRAM, "--install", ISOMOTION_BUILD_DIR, "--prefix", *this / "prefix"}, {});
        ASSERT_EQ(ending.code, 0) << ending;
    }
    Ending run_there(const std::string& program, Words arguments) const {
        arguments.insert(arguments.begin(), program);
        return cli::run(arguments,
                        {.folder = folder(), .environment = {{"ISOMOTION_DATA", std::nullopt}}});
    }
};

TEST_F(Installed, RendersWithItsOwnFiles) {
    const std::string program = *this / "prefix/bin/isomotion";
    const Ending examined = run_there(program, {"doctor"});
    EXPECT_THAT(examined.out, HasSubstr((*this / "prefix/share/isomotion").string()));
    const Ending ending = run_there(program, {"render", "twisting_superquadric", "--size", "48x48",
                                              "--frames", "7", "-o", "there.png"});
    ASSERT_EQ(ending.code, 0) << ending;
    render({"twisting_superquadric", "--size", "48x48", "--frames", "7", "-o", "here.png"});
    EXPECT_EQ(bytes("there.png"), bytes("here.png"));
}

TEST_F(Installed, ALinkLeadsToItsFiles) {
    std::filesystem::create_symlink(*this / "prefix/bin/isomotion", *this / "link");
    EXPECT_EQ(run_there(*this / "link", {"list"}).out, run({"list"}).out);
}

TEST_F(Installed, MissingFilesAreNamed) {
    if (std::filesystem::exists(ISOMOTION_INSTALLED_DATA)) {
        GTEST_SKIP() << "isomotion is installed here, and its files take the place of missing ones";
    }
    std::filesystem::remove_all(*this / "prefix/share/isomotion/shaders");
    const Ending ending = run_there(*this / "prefix/bin/isomotion", {"list"});
    EXPECT_EQ(ending.code, 2) << ending;
    EXPECT_THAT(ending.err, HasSubstr("set ISOMOTION_DATA"));
}

// Pictures are all that needs them.
TEST_F(Installed, MissingModulesAreNamed) {
    const auto remove = [&](const std::string& module) {
        for (const auto& entry :
             std::filesystem::recursive_directory_iterator(*this / "prefix/lib")) {
            if (entry.path().filename() == module) return std::filesystem::remove(entry.path());
        }
        return false;
    };
    const std::string program = *this / "prefix/bin/isomotion";
    const auto expect_named = [&](const std::string& module, const Words& arguments) {
        ASSERT_TRUE(remove(module)) << module;
        EXPECT_EQ(run_there(program, {"list"}).code, 0);
        const Ending ending = run_there(program, arguments);
        EXPECT_EQ(ending.code, 3) << ending;
        EXPECT_THAT(ending.err, HasSubstr("pictures cannot be read or written: " + module));
        EXPECT_THAT(ending.err, HasSubstr("lib/isomotion"));
    };
    const Words plain{"render",   "twisting_superquadric", "--size", "16x16", "--frames", "7", "-o",
                      "there.png"};
    const Words mirrors{"render", "blobby75_chrome", "--size", "16x16", "--frames", "7",
                        "-o",     "there.png"};
    expect_named("isomotion_codecs.so", mirrors);
    EXPECT_EQ(run_there(program, plain).code, 0);
    expect_named("isomotion_encoders.so", plain);
}

} // namespace
} // namespace isomotion::cli
