// Keys that once had another name: scenes with the old one load, and are the same scenes.
#include "scene/renamed_keys.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scene/source_print.h"
#include "testing.h"

namespace isomotion::scene {
namespace {

struct Spelling {
    std::string transform = "transform", colormap = "colormap", back_color = "back_color",
                radius = "radius", extrapolate = "extrapolate";
};

const Spelling now;
// All of them.
const Spelling before{"placement", "paint", "inside", "reach", "outside"};

class RenamedKeys : public Scenes {
protected:
    RenamedKeys() { write("drops.csv", "t,cx\n0,1\n1,2\n"); }

    static std::string text(const Spelling& keys) {
        return fmt::format("[time]\nframes = 90\n[surface]\n"
                           "formula = \"x^2 + y^2 + z^2 - 1 + sum(drops, 0.001*cx)\"\n"
                           "bounds = {{ sphere = 1.5 }}\n"
                           "{} = {{ translate = [1, \"t\", 3], scale = 2 }}\n"
                           "[arrays.drops]\nfile = \"drops.csv\"\n{} = \"hold\"\n"
                           "[material]\n{} = [0, \"t/4\", 1]\n"
                           "[material.{}]\nvalue = \"nz\"\nrange = [-1, \"1 + t\"]\n"
                           "[occlusion]\n{} = \"0.5 + t\"\n",
                           keys.transform, keys.extrapolate, keys.back_color, keys.colormap,
                           keys.radius);
    }

    // The fingerprint of how a scene moves and is seen.
    static std::string print(const Scene& scene) {
        base::Fingerprint print;
        const animation::Animation& animation = scene.surfaces[0].animation;
        for (const auto& track : animation.tracks()) add(print, track);
        for (std::size_t a = 0; a < animation.arrays().size(); ++a) add_array(print, animation, a);
        return print.text();
    }

    void expect_equal(const Scene& one, const Scene& other) const {
        EXPECT_EQ(print(one), print(other));
        for (const double time : {0.0, 1.5}) {
            const SceneAt a = at_time(one, time), b = at_time(other, time);
            EXPECT_EQ(a.surfaces[0].placement.translate, b.surfaces[0].placement.translate);
            EXPECT_EQ(a.surfaces[0].placement.scale, b.surfaces[0].placement.scale);
            EXPECT_EQ(a.surfaces[0].paint_range, b.surfaces[0].paint_range);
            EXPECT_EQ(a.surfaces[0].inside_color, b.surfaces[0].inside_color);
            EXPECT_EQ(a.occlusion.reach, b.occlusion.reach);
            EXPECT_EQ(a.surfaces[0].bindings.arrays.size(), b.surfaces[0].bindings.arrays.size());
        }
        EXPECT_TRUE(one.surfaces[0].material.paint && other.surfaces[0].material.paint);
        EXPECT_TRUE(one.surfaces[0].material.inside && other.surfaces[0].material.inside);
    }
};

TEST_F(RenamedKeys, EveryFormerNameLoadsTheSameScene) {
    const Scene scene = loaded(text(now));
    EXPECT_EQ(at_time(scene, 1.5).surfaces[0].placement.translate, glm::dvec3(1, 1.5, 3));
    EXPECT_EQ(at_time(scene, 1.5).surfaces[0].paint_range, glm::dvec2(-1, 2.5));
    EXPECT_EQ(at_time(scene, 2).surfaces[0].inside_color, glm::dvec3(0, 0.5, 1));
    EXPECT_EQ(at_time(scene, 2).occlusion.reach, 2.5);
    for (auto key : {&Spelling::transform, &Spelling::colormap, &Spelling::back_color,
                     &Spelling::radius, &Spelling::extrapolate}) {
        Spelling one = now;
        one.*key = before.*key;
        SCOPED_TRACE(one.*key);
        expect_equal(scene, loaded(text(one)));
    }
    expect_equal(scene, loaded(text(before)));
}

// A surface of the catalogue may have one name and its scene the other.
TEST_F(RenamedKeys, OfTheCatalogue) {
    surface("ball", "formula = \"x^2 + y^2 + z^2 - 1\"\nbounds = { sphere = 2 }\n"
                    "[material]\ninside = [0, 0, 1]\n");
    const std::string use = "[surface]\nuse = \"ball\"\n";
    EXPECT_EQ(at_time(loaded(use), 0).surfaces[0].inside_color, glm::dvec3(0, 0, 1));
    EXPECT_EQ(
        at_time(loaded(use + "[material]\nback_color = [1, 0, 0]\n"), 0).surfaces[0].inside_color,
        glm::dvec3(1, 0, 0));
}

TEST_F(RenamedKeys, BothNamesAtOnceAreAMistake) {
    const auto expect = [&](const std::string& lines, const std::string& message) {
        EXPECT_EQ(mistake(ball_and(lines)), "scene.toml:" + message);
    };
    expect("[material]\ninside = [1, 0, 0]\nback_color = [0, 0, 1]",
           "16: material.inside: is the former name of material.back_color, which is given too; "
           "keep one");
    expect("[occlusion]\nradius = 1\nreach = 1",
           "17: occlusion.reach: is the former name of occlusion.radius, which is given too; keep "
           "one");
    EXPECT_EQ(mistake(ball_with(7, "bounds = { sphere = 1.5 }\nplacement = { scale = 2 }\n"
                                   "transform = { scale = 2 }")),
              "scene.toml:8: surface.placement: is the former name of surface.transform, which is "
              "given too; keep one");
    expect("[material.paint]\nvalue = 'nz'\nrange = [0, 1]\n[material.colormap]\nvalue = 'nz'\n"
           "range = [0, 1]",
           "15: material.paint: is the former name of material.colormap, which is given too; keep "
           "one");
    std::string both = text(now);
    both.replace(both.find("extrapolate"), 0, "outside = \"hold\"\n");
    EXPECT_EQ(mistake(both), "scene.toml:9: arrays.drops.outside: is the former name of "
                             "arrays.drops.extrapolate, which is given too; keep one");
}

// It speaks of the key that was written.
TEST_F(RenamedKeys, MistakesNameTheKeyAsItIsWritten) {
    const auto expect = [&](const std::string& lines, const std::string& message) {
        EXPECT_EQ(mistake(ball_and(lines)), "scene.toml:" + message);
    };
    expect("[material.paint]\nvalue = 'raduis'\nrange = [0, 1]",
           "16: material.paint.value: unknown name 'raduis'; did you mean 'radius'?\n"
           "    raduis\n"
           "    ^");
    expect("[material.paint]\nvalue = 'nz'\nrange = [2, 2]",
           "17: material.paint.range at t = 0: the two ends must differ, and both are 2");
    expect("[material]\ninside = 3",
           "16: material.inside: must be [x, y, z] or { keys = [[t, [x, y, z]], ...] }");
    expect("[occlusion]\nreach = -1", "16: occlusion.reach at t = 0: must be above 0, not -1");
    expect("[occlusion]\nradius = -1", "16: occlusion.radius at t = 0: must be above 0, not -1");
    EXPECT_EQ(mistake(ball_with(7, "bounds = { sphere = 1.5 }\nplacement = { scale = \"s\" }")),
              "scene.toml:8: surface.placement.scale: unknown name 's'; known: t, radius, pi\n"
              "    s\n"
              "    ^");
    EXPECT_EQ(mistake(ball_with(7, "bounds = { sphere = 1.5 }\nplacement = { rotat = 2 }")),
              "scene.toml:8: surface.placement.rotat: unknown key; did you mean 'rotate'?");
    Spelling wrong = now;
    wrong.extrapolate = "outside = \"loop\" # ";
    EXPECT_EQ(mistake(text(wrong)), "scene.toml:9: arrays.drops.outside: must be hold: the first "
                                    "and the last elements stay, not 'loop'");
}

TEST_F(RenamedKeys, ThePresentNameIsOffered) {
    EXPECT_EQ(mistake(ball_and("[material]\nback_colour = [1, 0, 0]")),
              "scene.toml:16: material.back_colour: unknown key; did you mean 'back_color'?");
    EXPECT_EQ(mistake(ball_with(7, "bounds = { sphere = 1.5 }\ntransfrom = { scale = 2 }")),
              "scene.toml:8: surface.transfrom: unknown key; did you mean 'transform'?");
}

// --set takes both, and changes what the file has under either.
TEST_F(RenamedKeys, TheCommandLineTakesBoth) {
    for (const Spelling& file : {now, before}) {
        for (const Spelling& line : {now, before}) {
            const Scene scene = loaded(text(file), {"surface." + line.transform + ".scale=5",
                                                    "material." + line.colormap + ".range=[0, 7]",
                                                    "material." + line.back_color + "=[1, 1, 0]",
                                                    "occlusion." + line.radius + "=9",
                                                    "arrays.drops." + line.extrapolate + "=hold"});
            const SceneAt there = at_time(scene, 0);
            EXPECT_EQ(there.surfaces[0].placement.scale, 5);
            EXPECT_EQ(there.surfaces[0].placement.translate, glm::dvec3(1, 0, 3));
            EXPECT_EQ(there.surfaces[0].paint_range, glm::dvec2(0, 7));
            EXPECT_EQ(there.surfaces[0].inside_color, glm::dvec3(1, 1, 0));
            EXPECT_EQ(there.occlusion.reach, 9);
        }
    }
    EXPECT_EQ(at_time(loaded(ball(), {"surface.placement.scale=2"}), 0).surfaces[0].placement.scale,
              2);
    EXPECT_EQ(mistake(text(before), {"occlusion.radius=[1]"}).substr(0, 24),
              "--set: occlusion.radius:");
}

TEST(FirstName, OfATrack) {
    EXPECT_EQ(first_name("surface.transform.scale"), "surface.placement.scale");
    EXPECT_EQ(first_name("surface.placement.scale"), "surface.placement.scale");
    EXPECT_EQ(first_name("occlusion.radius"), "occlusion.reach");
    EXPECT_EQ(first_name("material.colormap.range.low"), "material.paint.range.low");
    EXPECT_EQ(first_name("material.back_color.x"), "material.inside.x");
    EXPECT_EQ(first_name("material.color.x"), "material.color.x");
    EXPECT_EQ(first_name("radius"), "radius");
}

} // namespace
} // namespace isomotion::scene
