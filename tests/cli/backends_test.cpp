// The back ends draw the same picture.
#include "cli.h"

#include "unit/image/compare.h"

namespace isomotion::cli {
namespace {

// Of `... step 0.02; llvmpipe (LLVM 15.0.6, 256 bits) (osmesa)`.
std::string renderer_of(const Ending& ending) {
    const std::size_t begin = ending.out.find("; ") + 2;
    return ending.out.substr(begin, ending.out.rfind(" (", ending.out.find('\n')) - begin);
}

// On one renderer the pictures are identical. Where EGL reaches a graphics card and OSMesa the
// processor, arithmetic differs in its last bits: a pixel on a silhouette may then fall to either
// side, any other keeps its colour.
TEST_F(Cli, BackEndsAgree) {
    std::map<std::string, std::string> renderers;
    for (const std::string backend : {"egl", "osmesa"}) {
        const Ending ending = run({"render", "twisting_superquadric", "--size", "96x96", "--frames",
                                   "20", "--channels", "z,n,p,verdict,evaluations", "--backend",
                                   backend, "-o", backend + ".exr"});
        if (ending.code == 3) GTEST_SKIP() << backend << " does not work here: " << ending.err;
        ASSERT_EQ(ending.code, 0) << ending;
        EXPECT_THAT(ending.out, HasSubstr("(" + backend));
        renderers[backend] = renderer_of(ending);
    }
    const bool same_renderer = renderers["egl"] == renderers["osmesa"];
    const double tolerance = same_renderer ? 0 : 0.01;
    const std::size_t strays = same_renderer ? 0 : 96 * 96 / 100;
    const image::Comparison comparison = image::compare(
        image::decode(*this / "egl.exr"), image::decode(*this / "osmesa.exr"), tolerance);
    ASSERT_TRUE(comparison.same_size);
    ASSERT_EQ(comparison.channels.size(), 13u);
    for (const auto& channel : comparison.channels) {
        if (!same_renderer && channel.name == "evaluations") continue; // follow the last bits
        EXPECT_LE(channel.over_tolerance, strays) << channel.name << " " << channel.largest;
    }
}

} // namespace
} // namespace isomotion::cli
