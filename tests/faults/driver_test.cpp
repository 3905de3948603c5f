// Drivers that fail: exit code 3, what failed, and nothing half written; or the frame comes out
// right in smaller tiles.
#include "export.h"

#include <dlfcn.h>
#include <link.h>

namespace isomotion::faults {
namespace {

class Driver : public Export {
protected:
    // The real library, as the loader finds it; empty without.
    static std::string real_egl() {
        void* const library = ::dlopen("libEGL.so.1", RTLD_LAZY | RTLD_LOCAL);
        link_map* map = nullptr;
        if (!library || ::dlinfo(library, RTLD_DI_LINKMAP, &map) != 0) return {};
        return map->l_name;
    }

    void SetUp() override {
        if (real_egl().empty()) GTEST_SKIP() << "no libEGL.so.1 here, to fail in its place";
    }

    Circumstances with(const std::string& fault) const {
        Circumstances circumstances = this->circumstances();
        circumstances.environment["LD_LIBRARY_PATH"] = FAILING_EGL_DIR;
        circumstances.environment["REAL_EGL"] = real_egl();
        circumstances.environment["FAULT"] = fault;
        return circumstances;
    }
    Ending render(const std::string& fault, Words more) const {
        more.insert(more.begin(), {"--backend", "egl"});
        return run(command("out", more), with(fault));
    }
    void expect_refusal(const Ending& ending, const std::string& message) const {
        EXPECT_EQ(ending.code, 3) << ending;
        EXPECT_THAT(ending.err, HasSubstr(message));
        expect_only_whole_files();
    }
};

// Without a fault the stand-in changes nothing, so that what fails below fails by the fault.
TEST_F(Driver, TheStandInIsTransparent) {
    const Ending ending = render("none", {});
    EXPECT_EQ(ending.code, 0) << ending;
    expect_frames_of("out");
}

TEST_F(Driver, NoContext) {
    expect_refusal(render("context", {}), "eglCreateContext for OpenGL 3.3 core failed");
    EXPECT_EQ(finished("out"), 0);
}

TEST_F(Driver, NoShaderCompiles) {
    expect_refusal(render("compile", {}), "shader failed");
    EXPECT_EQ(finished("out"), 0);
}

TEST_F(Driver, NoProgramLinks) {
    expect_refusal(render("link", {}), "link step failed");
    EXPECT_EQ(finished("out"), 0);
}

TEST_F(Driver, NoMemoryForTextures) {
    expect_refusal(render("memory", {}), "out of graphics memory");
    EXPECT_EQ(finished("out"), 0);
}

// In the middle of a sequence: the frames before are whole, and the rest follows later.
TEST_F(Driver, PixelsCannotBeReadBack) {
    expect_refusal(render("readback", {}), "reading back pixels: out of graphics memory");
    expect_frames_of("out", false);
    const Ending rest = run(command("out", {"--resume"}));
    EXPECT_EQ(rest.code, 0) << rest;
    expect_frames_of("out");
    expect_verified("out");
}

// Frames larger than a texture may be are drawn in tiles.
TEST_F(Driver, SmallTexturesChangeNothing) {
    const Words words{"--frames", "7", "--size", "300x200"};
    const Ending small = render("small", words);
    EXPECT_EQ(small.code, 0) << small;
    EXPECT_EQ(run(command("large", words)).code, 0);
    EXPECT_EQ(bytes("out/a.0007.png"), bytes("large/a.0007.png"));
}

TEST_F(Driver, AsWideAsAPictureMayBe) {
    const Ending ending = run(command("out", {"--frames", "7", "--size", "16384x3"}));
    EXPECT_EQ(ending.code, 0) << ending;
    const image::Frame frame = image::decode(*this / "out/a.0007.png");
    EXPECT_EQ(frame.width, 16'384);
    expect_verified("out");
}

TEST_F(Driver, SixteenThousandPixelsSquareInTooLittleMemory) {
    Words words{"/bin/sh", "-c", R"(ulimit -v 3000000; exec "$0" "$@")",
                cli::tested_program(ISOMOTION_PROGRAM)};
    for (const std::string& word : command("out", {"--frames", "1", "--size", "16384x16384"})) {
        words.push_back(word);
    }
    const Ending ending = cli::run(words, circumstances());
    expect_refusal(ending, "out of memory: this takes more than the machine or a limit allows");
    EXPECT_EQ(finished("out"), 0);
}

TEST_F(Driver, OlderThanNeeded) {
    Circumstances circumstances = this->circumstances();
    circumstances.environment["MESA_GL_VERSION_OVERRIDE"] = "3.1";
    circumstances.environment["ISOMOTION_OSMESA"] = "/nonexistent/driver";
    const Ending ending = run(command("out", {"--frames", "1"}), circumstances);
    if (ending.code == 0)
        GTEST_SKIP() << "no driver of Mesa, which alone can pass for an older one";
    expect_refusal(ending, "no OpenGL context can be made here");
}

} // namespace
} // namespace isomotion::faults
