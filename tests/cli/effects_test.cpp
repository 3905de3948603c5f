// What the program says of effects, and what it does with bad files that they name.
#include "cli.h"

namespace isomotion::cli {
namespace {

class Effects : public Cli {
protected:
    Words with_scene(const char* command, const std::string& more) const {
        std::ofstream(*this / "scene.toml")
            << "[surface]\nformula = \"x^2 + y^2 + z^2 - 1\"\nbounds = { sphere = 1.5 }\n"
            << more;
        return {command, "scene.toml"};
    }
};

TEST_F(Effects, AreListed) {
    const Ending ending = run({"list", "effects"});
    EXPECT_EQ(ending.code, 0) << ending;
    for (const char* effect : {"shadows", "environment", "fog", "self-reflection"}) {
        EXPECT_THAT(ending.out, HasSubstr(effect));
    }
}

TEST_F(Effects, AreShownWithTheirFiles) {
    const Ending none = run(with_scene("show", ""));
    EXPECT_THAT(none.out, HasSubstr("effects   none"));
    EXPECT_THAT(none.out, Not(HasSubstr("effects/")));
    const Ending some = run(with_scene("show", "[fog]\ndensity = 0.1\n[[lights]]\n"
                                               "direction = [1, 0, 0]\nshadow = true\n"));
    EXPECT_EQ(some.code, 0) << some;
    EXPECT_THAT(some.out, HasSubstr("effects   shadows fog\n"));
    EXPECT_THAT(some.out, HasSubstr("effects/shadow.glsl"));
}

TEST_F(Effects, ARangeThatIsShownIsTold) {
    const std::string map = "[material.colormap]\nvalue = \"z*(1 + t)\"\nrange = \"auto\"\n"
                            "[time]\nfps = 2\nframes = 3\n[output]\nsize = [40, 30]\n";
    const Ending told = run(with_scene("show", map));
    EXPECT_EQ(told.code, 0) << told;
    EXPECT_THAT(told.out,
                testing::ContainsRegex("\ncolormap  -1\\.5[0-9]* to 2, what the surface"));
    Words empty = with_scene("show", map);
    empty.insert(empty.end(), {"--set", "surface.formula=x^2 + 1"});
    EXPECT_THAT(run(empty).out, HasSubstr("\ncolormap  0 to 1, as no ray"));
    // Whichever frames are asked for.
    render({"scene.toml", "-o", "all.#.png"});
    render({"scene.toml", "-o", "one.#.png", "--frames", "2"});
    EXPECT_EQ(bytes("all.2.png"), bytes("one.2.png"));
    EXPECT_THAT(render({"scene.toml", "-o", "all.#.png", "--resume"}).out,
                HasSubstr("\n3 frames kept from an earlier run\n"));
}

TEST_F(Effects, OfALookAreToldAndLeftOutOnDemand) {
    const Ending looks = run({"list", "looks"});
    for (const char* look : {"studio", "clay", "night", "chrome"})
        EXPECT_THAT("\n" + looks.out, HasSubstr(std::string("\n") + look + ' '));
    std::ofstream(*this / "plain.toml")
        << "[surface]\nformula = \"x^2 + y^2 + z^2 - 1\"\nbounds = { sphere = 1.5 }\n"
           "[output]\nsize = [24, 24]\n";
    std::ofstream(*this / "looked.toml")
        << "look = \"studio\"\n"
           "[surface]\nformula = \"x^2 + y^2 + z^2 - 1\"\nbounds = { sphere = 1.5 }\n"
           "[output]\nsize = [24, 24]\n";
    EXPECT_THAT(run({"show", "looked.toml"}).out,
                testing::ContainsRegex("\nlook      studio: sets .*lights.*output\\.samples"));
    EXPECT_THAT(run({"show", "plain.toml"}).out, Not(HasSubstr("\nlook ")));
    render({"plain.toml", "-o", "plain.png"});
    render({"looked.toml", "-o", "looked.png"});
    render({"looked.toml", "--set", "look=none", "-o", "none.png"});
    const auto red = [&](const char* name) {
        return image::decode(*this / name).find("R")->samples;
    };
    EXPECT_EQ(red("none.png"), red("plain.png"));
    EXPECT_NE(red("looked.png"), red("plain.png"));
    const Ending priced = run({"accuracy", "looked.toml", "--set", "look=clay", "--effects",
                               "--size", "24x24", "--repeat", "1"});
    for (const char* effect : {"shadows", "occlusion", "ambient", "samples", "light-size"})
        EXPECT_THAT(priced.out, HasSubstr(std::string("\n") + effect + ' '));
}

TEST_F(Effects, HaveTheirPrices) {
    Words words = with_scene("accuracy", "[fog]\ndensity = 0.1\n[occlusion]\n");
    words.insert(words.end(), {"--effects", "--size", "32x32", "--repeat", "1"});
    const Ending some = run(words);
    EXPECT_EQ(some.code, 0) << some;
    EXPECT_THAT(some.out, HasSubstr("\nfog "));
    EXPECT_THAT(some.out, HasSubstr("\nocclusion "));
    EXPECT_THAT(some.out, Not(HasSubstr("shadows")));
    words = with_scene("accuracy", "");
    words.push_back("--effects");
    EXPECT_THAT(run(words).out, HasSubstr("calls for no effect"));
}

TEST_F(Effects, OfSeveralSurfacesAndSectionsHaveTheirPrices) {
    std::ofstream(*this / "several.toml")
        << "[[surfaces]]\nformula = \"x^2 + y^2 + z^2 - 1\"\nbounds = { sphere = 1.5 }\n"
           "material = { contours = { value = \"z\", every = 0.2 } }\n"
           "[[surfaces]]\nformula = \"x^2 + y^2 + z^2 - 1\"\nbounds = { sphere = 1.5 }\n"
           "material = { transmission = 1, depth = 2 }\ntransform = { translate = [1, 0, 0] }\n"
           "[[sections]]\nnormal = [0, 0, 1]\noffset = 0.5\n[output]\nsize = [24, 24]\n";
    const Ending priced =
        run({"accuracy", "several.toml", "--effects", "--size", "24x24", "--repeat", "1"});
    EXPECT_EQ(priced.code, 0) << priced;
    for (const char* effect : {"glass", "sections", "contours"})
        EXPECT_THAT(priced.out, HasSubstr(std::string("\n") + effect + ' '));
}

TEST_F(Effects, MapsThatAreNoneAreErrors) {
    Words words = with_scene("render", "[environment]\nmap = \"nowhere.exr\"\n");
    words.insert(words.end(), {"-o", "frame.png"});
    const Ending missing = run(words);
    EXPECT_EQ(missing.code, 2) << missing;
    EXPECT_THAT(missing.err, HasSubstr("nowhere.exr"));
    std::ofstream(*this / "map.exr") << "no picture";
    words = with_scene("render", "[environment]\nmap = \"map.exr\"\n");
    words.insert(words.end(), {"-o", "frame.png"});
    const Ending broken = run(words);
    EXPECT_NE(broken.code, 0) << broken;
    EXPECT_THAT(broken.err, HasSubstr(": environment.map: "));
    EXPECT_FALSE(std::filesystem::exists(*this / "frame.png"));
    const Ending shown = run(with_scene("show", "[environment]\nmap = \"map.exr\"\n"));
    EXPECT_NE(shown.code, 0) << shown;
    EXPECT_THAT(shown.err, HasSubstr(": environment.map: "));
}

TEST_F(Effects, MistakesNameTheirKey) {
    for (const auto& [scene, words] : std::vector<std::pair<std::string, std::string>>{
             {"[[lights]]\nshadow = true\n", "needs one of direction"},
             {"[[lights]]\ndirection = [1, 0, 0]\nposition = [1, 0, 0]\n",
              "needs one of direction"},
             {"[[lights]]\ndirection = [1, 0, 0]\nfalloff = 2\n", "lights[0].falloff"},
             {"[ground]\ncolor = [1, 1, 1]\n", "height: is missing; give"},
             {"[fog]\nstart = 1\n", "density: is missing; give"},
             {"[fog]\ndensity = -1\n", "must be 0 or above"},
             {"[occlusion]\nstrength = 2\n", "occlusion.strength"},
             {"[occlusion]\nreach = 0\n", "above 0"},
             {"[material]\nreflection = \"mirror\"\n", "known: sky, self"}}) {
        const Ending ending = run(with_scene("show", scene));
        EXPECT_EQ(ending.code, 2) << scene;
        EXPECT_THAT(ending.err, HasSubstr(words)) << scene;
    }
}

} // namespace
} // namespace isomotion::cli
