#include "sequence/scene_fingerprint.h"

#include <filesystem>
#include <fstream>
#include <set>

#include <unistd.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scene/reading/load.h"

namespace isomotion::sequence {
namespace {

std::string print(const std::vector<scene::Override>& changes) {
    return scene_fingerprint(scene::load(ISOMOTION_SOURCE_DIR "/animations/torus.toml", changes));
}

TEST(SceneFingerprint, EveryChangeShows) {
    const std::vector<scene::Override> changes = {
        "camera.fov=31",
        "camera.up=[0,1,0]",
        "output.size=[40,40]",
        "output.samples=4",
        "output.background=\"transparent\"",
        "material.color=[1,0,0]",
        "material.model=\"lambert\"",
        "isolation.method=\"amp-sign\"",
        "isolation.step=0.0123",
        "isolation.certify=true",
        "isolation.limit=5000",
        "time.fps=12",
        "material.reflection=\"sky\"",
        "surface.transform.scale=1.5",
        "material.color=['abs(nx)', 0, 0]",
        "material.color=['abs(nx)', 0, 1]",
        "material.color=['abs(ny)', 0, 1]",
        "material.colormap={ value = 'x', range = [-1, 1] }",
        "material.colormap={ value = 'x', range = 'auto' }",
        "material.colormap={ value = '2*x', range = 'auto' }",
    };
    std::set<std::string> prints{print({})};
    for (const auto& change : changes) EXPECT_TRUE(prints.insert(print({change})).second) << change;
}

TEST(SceneFingerprint, IsTheSameEachTime) { EXPECT_EQ(print({}), print({})); }

// More frames of the same animation are the same scene.
TEST(SceneFingerprint, TheNumberOfFramesDoesNotCount) {
    EXPECT_EQ(print({"time.frames=7", "output.poster=1"}),
              print({"time.frames=9", "output.poster=2"}));
}

TEST(SceneFingerprint, CountsTheColumnsOfATableThatAreRead) {
    const auto print_of = [](const char* rows) {
        const auto folder = std::filesystem::temp_directory_path();
        const std::string table = fmt::format("isomotion-columns-{}.csv", getpid());
        std::ofstream(folder / table) << "t,a,b,unread\n" << rows;
        const scene::Scene loaded =
            scene::load_text(fmt::format("[surface]\nformula = 'sum(p, (x-a)^2 + (y-c)^2) + z'\n"
                                         "bounds = {{ sphere = 2 }}\n"
                                         "[arrays.p]\nfile = '{}'\nc = 'b/2'\n",
                                         table),
                             folder / "columns.toml");
        std::filesystem::remove(folder / table);
        return scene_fingerprint(loaded);
    };
    const std::string before = print_of("0,1,2,3\n");
    EXPECT_NE(print_of("0,9,2,3\n"), before);
    EXPECT_NE(print_of("0,1,9,3\n"), before); // a sibling's expression reads it
    EXPECT_EQ(print_of("0,1,2,9\n"), before);
}

// A key's new name leaves fingerprints as they were, so that sequences from before go on: this one
// is from when there were only the old names.
TEST(SceneFingerprint, OutlivesRenamedKeys) {
    const auto print_of = [](const std::string& transform, const std::string& extrapolate,
                             const std::string& back_color, const std::string& colormap,
                             const std::string& radius) {
        const auto folder = std::filesystem::temp_directory_path();
        const std::string table = fmt::format("isomotion-fingerprint-{}.csv", getpid());
        std::ofstream(folder / table) << "t,cx\n0,1\n1,2\n";
        const scene::Scene loaded = scene::load_text(
            fmt::format("title = \"Pinned\"\n[time]\nframes = 90\n"
                        "[surface]\nformula = \"x^2 + y^2 + z^2 - 1 + sum(drops, 0.001*cx)\"\n"
                        "bounds = {{ sphere = 1.5 }}\n"
                        "{} = {{ translate = [1, \"t\", 3], scale = 2 }}\n"
                        "[arrays.drops]\nfile = \"{}\"\n{} = \"hold\"\n"
                        "[material]\n{} = [0, \"t/4\", 1]\n"
                        "[material.{}]\nvalue = \"nz\"\nrange = [-1, \"1 + t\"]\n"
                        "[occlusion]\n{} = \"0.5 + t\"\n[output]\nsize = [8, 8]\n"
                        "[isolation]\nstep = 0.01\nnear = 0.125\nfar = 1\nhorizon = 0.25\n",
                        transform, table, extrapolate, back_color, colormap, radius),
            folder / "scene.toml");
        std::filesystem::remove(folder / table);
        return scene_fingerprint(loaded);
    };
    const std::string before = "95a5f478624de86d91e23a9af8f565fe";
    EXPECT_EQ(print_of("placement", "outside", "inside", "paint", "reach"), before);
    EXPECT_EQ(print_of("transform", "extrapolate", "back_color", "colormap", "radius"), before);
}

} // namespace
} // namespace isomotion::sequence
