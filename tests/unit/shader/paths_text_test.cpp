// The shaders of glass among several surfaces.
#include <algorithm>

#include <gtest/gtest.h>

#include "scene/surfaces.h"
#include "unit/shader/scenes.h"

namespace isomotion::shader {
namespace {

std::vector<Passes> passes_of(const std::string& text) {
    const scene::Scene scene = scene_of(text);
    std::vector<Passes> all;
    for (std::size_t k = 0; k < scene.surfaces.size(); ++k)
        all.push_back(assemble(scene::OneSurface(scene, k)));
    return all;
}

std::ptrdiff_t files_of_paths(const Passes& passes) {
    return std::ranges::count_if(
        passes.files(), [](const std::string& file) { return file.starts_with("paths/"); });
}

TEST(PathsText, IsOnlyThereAmongSeveralSurfacesWithGlass) {
    use_shaders_of_source_tree();
    const std::string ball =
        "[[surfaces]]\nformula = 'x^2 + y^2 + z^2 - 1'\nbounds = { sphere = 2 }\n";
    const std::string mirror = "material = { reflection = 'self' }\n";
    const std::string clear = "material = { transmission = 1 }\n";
    for (const std::string& text : {ball + ball, ball + mirror + ball}) {
        for (const Passes& passes : passes_of(text)) EXPECT_EQ(files_of_paths(passes), 0) << text;
    }
    for (const std::string& glass : every_glass)
        EXPECT_EQ(files_of_paths(assemble(scene_of(surface_text("x") + glass))), 0);
    for (const Passes& passes : passes_of(ball + mirror + ball + clear)) {
        EXPECT_GT(files_of_paths(passes), 5);
        EXPECT_FALSE(passes.has(Role::mirror)); // mirrored rays are of paths
        EXPECT_FALSE(passes.has(Role::fused));
    }
    // Only glass tells what is beyond.
    const std::vector<Passes> all = passes_of(ball + mirror + ball + clear);
    EXPECT_FALSE(all[0].has(Role::glass_beyond));
    EXPECT_TRUE(all[1].has(Role::glass_beyond));
}

} // namespace
} // namespace isomotion::shader
