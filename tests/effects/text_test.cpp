// A scene pays for what it names: the text of its shaders holds that and nothing else.
#include <algorithm>

#include <gmock/gmock.h>

#include "render/drawing.h"
#include "shader/assemble.h"

namespace isomotion::shader {
namespace {

Passes passes_of(const std::string& more) {
    return assemble(render::scene_of("[surface]\nformula = \"x^2 + y^2 + z^2 - 1\"\n"
                                     "bounds = { sphere = 1.5 }\n" +
                                     more));
}

std::string all_of(const Passes& passes) {
    std::string all;
    for (const Pass& pass : passes.list) all += pass.vertex + pass.text;
    return all;
}

bool has_effects(const Passes& passes) {
    const std::vector<std::string> files = passes.files();
    return std::any_of(files.begin(), files.end(),
                       [](const std::string& file) { return file.starts_with("effects/"); });
}

TEST(EffectText, APlainSceneHasNone) {
    for (const char* scene : {"", "[[lights]]\ndirection = [1, 0, 0]\n",
                              "[[lights]]\ndirection = [1, 0, 0]\nshadow = false\n",
                              "[material]\ncolor = [1, 0, 0]\n"}) {
        const Passes plain = passes_of(scene);
        EXPECT_FALSE(has_effects(plain)) << scene;
        for (const Role role : {Role::surface, Role::shadow, Role::mirror, Role::mirror_surface,
                                Role::glass, Role::glass_next}) {
            EXPECT_FALSE(plain.has(role));
        }
        EXPECT_THAT(all_of(plain), testing::Not(testing::HasSubstr("effects/")));
    }
}

struct Named {
    std::string scene, file, word; // what a scene says, the file it calls for, a word of that
};
void PrintTo(const Named& named, std::ostream* out) { *out << named.file; }

class EffectText : public testing::TestWithParam<Named> {};

const std::vector<Named> every_effect{
    {"[[lights]]\ndirection = [1, 0, 0]\nshadow = true\n", "effects/shadow.glsl", "shadow_ray"},
    {"[[lights]]\nposition = [2, 0, 0]\n", "effects/lights.glsl", "place.w == 0.0"},
    {"[ground]\nheight = -1\n", "effects/end_of_ray.glsl", "ground_plane"},
    {"[fog]\ndensity = 0.1\n", "effects/sky.glsl", "in_fog"},
    {"[occlusion]\n", "effects/occlusion.glsl", "openness"},
    {"[ambient]\ntop = [1, 0, 0]\n", "effects/sky.glsl", "ambient_top"},
    {"[material]\nreflection = \"sky\"\n", "effects/sky.glsl", "mirrored("},
    {"[material]\nmodel = \"ggx\"\n", "effects/material.glsl", "least_roughness"},
    {"[material]\nmodel = \"blinn-phong\"\n", "effects/material.glsl", "shininess"},
    {"[environment]\nmap = \"studio.exr\"\n", "effects/sky.glsl", "environment_texel"},
    {"[output]\nbackground = { top = [1, 0, 0], bottom = [0, 0, 1] }\n", "effects/sky.glsl",
     "sky_bottom"},
    {"[material.colormap]\nvalue = \"nz\"\nrange = [-1, 1]\n", "effects/paint.glsl", "paint_range"},
    {"[material]\ncolor = [\"nz\", 1, 0]\n", "effects/paint.glsl", "color_value"},
    {"[material]\nreflection = \"self\"\n", "effects/mirror_ray.glsl", "load_mirrored"},
    {"[material.contours]\nvalue = \"z\"\nevery = 1\n", "effects/contours.glsl", "on_contours"},
    {"[material]\ntransmission = 0.1\n", "glass/through.glsl", "refraction_at"},
};

// Mirrors blur an environment that there is, and show shadows that there are.
TEST(EffectText, MirrorsHaveWhatTheSceneHas) {
    const std::string mirror = "[material]\nreflection = \"self\"\n";
    const std::string map = "[environment]\nmap = \"studio.exr\"\n";
    const std::string shadow = "[[lights]]\ndirection = [1, 0, 0]\nshadow = true\n";
    const auto text = [](const std::string& scene) { return all_of(passes_of(scene)); };
    using testing::HasSubstr, testing::Not;
    const char* rough = "vec3 rough_environment(";
    const char* footprint = "float turn_of_normal(";
    const char* shadows = "float mirrored_visibility(";
    EXPECT_THAT(text(mirror + map), HasSubstr(rough));
    EXPECT_THAT(text(mirror + map), HasSubstr(footprint));
    EXPECT_THAT(text(mirror + map), Not(HasSubstr(shadows)));
    EXPECT_THAT(text(shadow + mirror), HasSubstr(shadows));
    for (const std::string& without : {map, mirror, shadow + mirror, shadow + map})
        EXPECT_THAT(text(without), Not(HasSubstr(rough))) << without;
    EXPECT_THAT(text(shadow + map), Not(HasSubstr(shadows)));
}

// They change what rays run through, and are in no shader of a scene without them.
TEST(EffectText, SectionsAreWhereTheyAreNamedAndOnlyThere) {
    const Passes plain = passes_of(""), cut = passes_of("[[sections]]\nnormal = [1, 0, 0]\n");
    for (const std::string& file : plain.files())
        EXPECT_FALSE(file.starts_with("section/")) << file;
    EXPECT_THAT(all_of(plain), testing::Not(testing::HasSubstr("#define SECTIONS")));
    EXPECT_THAT(cut.files(), testing::Contains("section/parts.glsl"));
    EXPECT_TRUE(cut.has(Role::fused)) << "as cheap a picture as before";
    const Passes moved = passes_of("[[sections]]\nnormal = [3, 1, 0]\npoint = [1, 1, 1]\n");
    EXPECT_EQ(all_of(cut), all_of(moved));
}

TEST_P(EffectText, IsThereWhereItIsNamedAndOnlyThere) {
    const Passes named = passes_of(GetParam().scene);
    EXPECT_THAT(named.files(), testing::Contains(GetParam().file));
    EXPECT_THAT(all_of(named), testing::HasSubstr(GetParam().word));
    for (const Named& other : every_effect) {
        if (other.word == GetParam().word || other.word == "mirrored(") continue;
        EXPECT_THAT(all_of(named), testing::Not(testing::HasSubstr(other.word)))
            << "of " << other.file;
    }
    // What every ray runs through stays the same.
    EXPECT_EQ(named.at(Role::march).text, passes_of("").at(Role::march).text);
}

TEST_P(EffectText, DependsOnNoValue) {
    std::string moved = GetParam().scene;
    std::replace(moved.begin(), moved.end(), '1', '3');
    EXPECT_EQ(all_of(passes_of(GetParam().scene)), all_of(passes_of(moved)));
}

INSTANTIATE_TEST_SUITE_P(Effects, EffectText, testing::ValuesIn(every_effect));

} // namespace
} // namespace isomotion::shader
