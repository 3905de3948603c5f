#include "every_backend.h"

#include <cstdlib>
#include <iostream>

// Drivers are looked up once a process, so each of these asks in a child that never did before.

namespace isomotion::gpu {
namespace {

constexpr auto missing = "/nonexistent/driver";

/// Ends the process with the message of Unavailable on stderr and status 3, or with 0.
[[noreturn]] void ask_for(Backend backend) {
    try {
        const auto context = Context::create(backend);
        std::cerr << "got " << context->info().backend << '\n';
    } catch (const Unavailable& error) {
        std::cerr << error.what() << "\nattempts: " << error.attempts().size() << '\n';
        std::_Exit(3);
    }
    std::_Exit(0);
}

void hide_egl() { setenv("__EGL_VENDOR_LIBRARY_FILENAMES", missing, 1); }
void hide_osmesa() { setenv("ISOMOTION_OSMESA", missing, 1); }

class UnavailableDeathTest : public testing::Test {
protected:
    // A fork of this process would inherit drivers that are already loaded.
    void SetUp() override { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

TEST_F(UnavailableDeathTest, NamesEveryAttemptAndWhatToInstall) {
    EXPECT_EXIT(
        {
            hide_egl();
            hide_osmesa();
            ask_for(Backend::automatic);
        },
        testing::ExitedWithCode(3),
        "no OpenGL context can be made here\n"
        "(.*\n)*  egl, surfaceless: .*failed.*\n"
        "(.*\n)*  osmesa: /nonexistent/driver: cannot open.*\n"
        "install .*Debian: libegl1 libegl-mesa0 libgl1-mesa-dri, or libosmesa6");
}

TEST_F(UnavailableDeathTest, TriesOnlyTheBackEndAskedFor) {
    EXPECT_EXIT(
        {
            hide_osmesa();
            ask_for(Backend::osmesa);
        },
        testing::ExitedWithCode(3), "attempts: 1\n");
}

TEST_F(UnavailableDeathTest, AutomaticGoesOnToTheNext) {
    if (!open_if_available(Backend::osmesa)) GTEST_SKIP() << "osmesa is not available here";
    EXPECT_EXIT(
        {
            hide_egl();
            ask_for(Backend::automatic);
        },
        testing::ExitedWithCode(0), "got osmesa\n");
}

} // namespace
} // namespace isomotion::gpu
