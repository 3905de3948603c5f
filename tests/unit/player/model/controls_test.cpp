// Sliders, compared with scenes whose files say the same.
#include "player/model/controls.h"

#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "scene/data_folder.h"
#include "scene/surfaces.h"
#include "unit/scene/testing.h"

namespace isomotion::player {
namespace {

using animation::Values;
using testing::ElementsAre;

const std::string moving = R"toml([time]
fps = 24
frames = 49
[surface]
formula = "sum(blobs, w*exp(-s*((x-cx)^2 + (y-cy)^2 + (z-m)^2))) - k"
bounds = { sphere = 3 }
[parameters]
m = { keys = [[0, -1], [0.7, 2], [2, 0.5]] }
k = "0.1 + m^2/10"
[arrays.blobs]
count = 5
w = "1 + t"
s = 4
cx = "i*w - random(i, 3)"
cy = [1, 2, 3, 4, 5]
)toml";

class Controls : public scene::Scenes {
protected:
    // The same values at every frame, to the last bit.
    static void expect_same(const scene::Scene& a, const scene::Scene& b) {
        ASSERT_EQ(a.timeline.frames, b.timeline.frames);
        for (int frame = 1; frame <= a.timeline.frames; ++frame) {
            ASSERT_EQ(a.surfaces[0].animation.at(a.timeline.time(frame)),
                      b.surfaces[0].animation.at(b.timeline.time(frame)))
                << frame;
        }
    }
    static double value(const scene::Scene& scene, const std::string& track, int frame) {
        const auto& animation = scene.surfaces[0].animation;
        return scene.surfaces[0]
            .animation.at(scene.timeline.time(frame))
            .tracks[std::size_t(animation.find(track).value())];
    }
    scene::Scene table(const std::string& interpolation) const {
        write("drops.csv", "frame,id,px,mass\n1,1,0,8\n1,2,1,1\n25,2,3,1\n25,1,-1,27\n");
        return loaded("[time]\nfps = 24\nframes = 25\n[surface]\nformula = "
                      "\"sum(drops, r*exp(-(x-px)^2 - y^2 - z^2)) - 0.5\"\n"
                      "bounds = { sphere = 9 }\n[arrays.drops]\nfile = \"drops.csv\"\n"
                      "interpolation = \"" +
                      interpolation + "\"\nr = \"0.1*mass\"\n");
    }
};

TEST_F(Controls, AReleasedParameterIsAsIfTheFileHadSaidSo) {
    const scene::Scene scene = loaded(moving);
    for (const auto& [name, number] : std::vector<std::pair<std::string, double>>{
             {"m", 0.37}, {"m", -1e-7}, {"m", 12345678.9}, {"k", 0.25}}) {
        const auto set = loaded(moving, {fmt::format("{}={}", name, number)});
        expect_same(apply(scene, {{{name, number}}, {}}), set);
    }
    // What names it follows: k is an expression in m.
    EXPECT_EQ(value(apply(scene, {{{"m", 3}}, {}}), "k", 7), 0.1 + 9 / 10.0);
    expect_same(apply(scene, {{{"m", 3}, {"k", 0.5}}, {}}), loaded(moving, {"m=3", "k=0.5"}));
}

TEST_F(Controls, SoIsAFieldThatAllElementsShare) {
    const scene::Scene scene = loaded(moving);
    expect_same(apply(scene, {{{"blobs.s", 2.5}}, {}}), loaded(moving, {"arrays.blobs.s=2.5"}));
    // The elements' places are made of w.
    const scene::Scene fixed = apply(scene, {{{"blobs.w", 2.5}}, {}});
    expect_same(fixed, loaded(moving, {"arrays.blobs.w=2.5"}));
    EXPECT_NE(fixed.surfaces[0].animation.at(fixed.timeline.time(9)).arrays[0].fields[0],
              scene.surfaces[0].animation.at(scene.timeline.time(9)).arrays[0].fields[0]);
}

TEST_F(Controls, WhatIsGivenBackMovesAgain) {
    const scene::Scene scene = loaded(moving);
    Overrides overrides{{{"m", 3}, {"blobs.s", 1}}, {{"blobs.cx", 2}}};
    overrides.values.erase("m");
    EXPECT_EQ(value(apply(scene, overrides), "m", 20), value(scene, "m", 20));
    overrides.values.clear();
    EXPECT_FALSE(overrides.empty());
    overrides.factors.clear();
    EXPECT_TRUE(overrides.empty());
    expect_same(apply(scene, overrides), scene);
}

TEST_F(Controls, NamesThatAreGoneMeanNothing) {
    const scene::Scene scene = loaded(moving);
    expect_same(apply(scene, {{{"gone", 3}, {"blobs.cx", 3}}, {{"blobs.gone", 2}, {"m", 2}}}),
                scene);
}

TEST_F(Controls, NumbersThatAreNoneAreRefused) {
    const scene::Scene scene = loaded(moving);
    for (const double bad : {double(NAN), double(INFINITY), -double(INFINITY)}) {
        EXPECT_THROW(apply(scene, {{{"m", bad}}, {}}), animation::ExpressionError);
        EXPECT_THROW(apply(scene, {{}, {{"blobs.cx", bad}}}), animation::ExpressionError);
    }
}

// Fields in the order of the file's keys, which is that of the alphabet.
TEST_F(Controls, FactorsMultiplyEveryElement) {
    const scene::Scene scene = loaded(moving);
    const auto& array = scene.surfaces[0].animation.arrays().at(0);
    for (const std::string name : {"cx", "cy"}) {
        for (const double factor : {0.0, 0.3, 1.0, 2.0, -1.5, 1e-9}) {
            const scene::Scene scaled = apply(scene, {{}, {{"blobs." + name, factor}}});
            for (const int frame : {1, 20, 49}) {
                const Values before = scene.surfaces[0].animation.at(scene.timeline.time(frame)),
                             after = scaled.surfaces[0].animation.at(scaled.timeline.time(frame));
                EXPECT_EQ(before.tracks, after.tracks);
                for (std::size_t f = 0; f < array.fields.size(); ++f) {
                    auto expected = before.arrays[0].fields[f];
                    if (array.fields[f].name == name) {
                        for (double& x : expected) x *= factor;
                    }
                    // cx is 0 whatever w is, which nothing else needs by element.
                    if (array.fields[f].name == "w" && name == "cx" && factor == 0)
                        expected.clear();
                    EXPECT_EQ(after.arrays[0].fields[f], expected) << array.fields[f].name;
                }
            }
        }
    }
}

TEST_F(Controls, FactorsOfFilesColumnsReachWhatIsMadeOfThem) {
    for (const std::string interpolation : {"linear", "hold"}) {
        const scene::Scene scene = table(interpolation);
        const auto column = [&](const scene::Scene& of, const std::string& name, int frame) {
            const auto& fields = of.surfaces[0].animation.arrays().at(0).fields;
            for (std::size_t f = 0; f < fields.size(); ++f) {
                if (fields[f].name == name)
                    return of.surfaces[0].animation.at(of.timeline.time(frame)).arrays[0].fields[f];
            }
            return std::vector<double>{};
        };
        const scene::Scene heavy = apply(scene, {{}, {{"drops.mass", 2}}});
        const scene::Scene wide = apply(scene, {{}, {{"drops.px", 0.5}}});
        for (const int frame : {1, 13, 25}) {
            for (std::size_t i = 0; i < 2; ++i) {
                EXPECT_EQ(column(heavy, "mass", frame)[i], 2 * column(scene, "mass", frame)[i]);
                EXPECT_EQ(column(heavy, "r", frame)[i], 2 * column(scene, "r", frame)[i]);
                EXPECT_EQ(column(heavy, "px", frame)[i], column(scene, "px", frame)[i]);
                EXPECT_EQ(column(wide, "px", frame)[i], 0.5 * column(scene, "px", frame)[i]);
            }
        }
        EXPECT_EQ(column(scene, "mass", 13)[0], interpolation == "linear" ? 17.5 : 8);
    }
}

// What is released changes values only: the formula that shaders were made of is the same one.
TEST_F(Controls, TheFormulaStays) {
    const scene::Scene scene = loaded(moving);
    const scene::Scene fixed = apply(scene, {{{"m", 1}}, {{"blobs.cx", 2}}});
    EXPECT_EQ(fixed.surfaces[0].field, scene.surfaces[0].field);
    const auto m = std::size_t(scene.surfaces[0].animation.find("m").value());
    EXPECT_EQ(at_time(fixed, 0.5).surfaces[0].bindings.parameters.at(m), 1);
}

TEST_F(Controls, SpansHoldWhatTheTimelineTakes) {
    surface("bowl", R"toml(title = "bowl"
source = "test"
formula = "x^2 + y^2 - a - b*z - c - d - e - f - g - h"
bounds = { sphere = 2 }
[parameters]
a = { default = 1, min = 0.5, max = 20 }
b = { default = 1, min = -3 }
c = { default = 4, min = 0, max = 5 }
d = 0
e = 7
f = -2
g = 3
h = 1
)toml");
    const auto found = slider_ranges(loaded(R"toml([time]
fps = 10
frames = 101
[surface]
use = "bowl"
[parameters]
a = 0.25
c = { keys = [[0, 1], [0.05, 9], [0.1, 1]] }
g = "4*sin(2*pi*t/10)"
h = "2 + t"
)toml"));
    std::map<std::string, SliderRange> by_name;
    for (const SliderRange& span : found) by_name[span.name] = span;
    ASSERT_EQ(by_name.size(), 8u);
    const auto expect = [&](const std::string& name, double least, double most, bool moves) {
        SCOPED_TRACE(name);
        EXPECT_NEAR(by_name[name].least, least, 0.01);
        EXPECT_NEAR(by_name[name].most, most, 0.01);
        EXPECT_EQ(by_name[name].moves, moves);
    };
    expect("a", 0.25, 20, false); // below the catalogue's range
    expect("b", -3, 2, false);
    expect("c", 0, 9, true); // a key between two frames, above the catalogue's range
    expect("d", -1, 1, false);
    expect("e", 0, 14, false);
    expect("f", -4, 0, false);
    expect("g", -6, 6, true);
    expect("h", 0, 14.5, true);
}

TEST_F(Controls, SlidersTellWhatIsHeld) {
    const scene::Scene scene = loaded(moving);
    const Overrides overrides{{{"m", 9}}, {}};
    const scene::Scene held = apply(scene, overrides);
    const auto found = sliders(slider_ranges(scene),
                               held.surfaces[0].animation.at(held.timeline.time(20)), overrides);
    std::vector<std::string> names;
    for (const Slider& slider : found) {
        names.push_back(slider.name);
        EXPECT_EQ(slider.overridden, slider.name == "m");
        EXPECT_EQ(slider.value, value(held, slider.name, 20));
        EXPECT_EQ(slider.moves, slider.name != "blobs.s");
    }
    EXPECT_THAT(names, testing::UnorderedElementsAre("m", "k", "blobs.w", "blobs.s"));
}

TEST_F(Controls, ArraysTellTheirCountAndHaveFactors) {
    const scene::Scene scene = loaded(moving);
    const Overrides overrides{{}, {{"blobs.cy", 2.5}}};
    const auto found =
        array_controls(scene.surfaces[0].animation,
                       scene.surfaces[0].animation.at(scene.timeline.time(1)), overrides);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].name, "blobs");
    EXPECT_EQ(found[0].count, 5);
    ASSERT_EQ(found[0].factors.size(), 2u) << "w and s have a value of their own";
    for (const Slider& slider : found[0].factors) {
        const bool is_held = slider.name == "blobs.cy";
        EXPECT_TRUE(is_held || slider.name == "blobs.cx") << slider.name;
        EXPECT_EQ(slider.overridden, is_held);
        EXPECT_EQ(slider.value, is_held ? 2.5 : 1);
    }
    EXPECT_EQ(array_controls(loaded(scene::ball()).surfaces[0].animation, {}, {}).size(), 0u);
}

// Each has sliders of its own, also where both have a parameter of that name.
TEST_F(Controls, OfSeveralSurfacesAreEachOnesOwn) {
    const scene::Scene scene =
        loaded("[[surfaces]]\nname = \"ball\"\nformula = \"x^2 + y^2 + z^2 - r^2\"\n"
               "parameters = { r = 1 }\n[[surfaces]]\nname = \"ring\"\n"
               "formula = \"x^2 + y^2 - r^2\"\nbounds = { sphere = 2 }\nparameters = { r = 2 }\n");
    Overrides all;
    put_surface(all, {scene, 1}, {{{"r", 3}}, {}});
    EXPECT_TRUE(of_surface(all, {scene, 0}).empty());
    EXPECT_EQ(of_surface(all, {scene, 1}).values.at("r"), 3);
    const scene::Scene moved = apply(scene, all);
    EXPECT_EQ(value(moved, "r", 1), 1);
    EXPECT_EQ(value(scene::alone({moved, 1}), "r", 1), 3);
    put_surface(all, {scene, 1}, {});
    EXPECT_TRUE(all.empty());
}

TEST_F(Controls, FitEveryAnimationOfTheGallery) {
    ::setenv("ISOMOTION_DATA", ISOMOTION_SOURCE_DIR, 1);
    int checked = 0;
    for (const std::string& name : scene::animation_names()) {
        SCOPED_TRACE(name);
        const scene::Scene scene = scene::load(name);
        for (std::size_t k = 0; k < scene.surfaces.size(); ++k) {
            const auto found = slider_ranges({scene, k});
            const animation::Animation& animation = scene.surfaces[k].animation;
            for (const int frame : {1, (1 + scene.timeline.frames) / 2, scene.timeline.frames}) {
                const Values values = animation.at(scene.timeline.time(frame));
                for (const Slider& slider : sliders(found, values, {})) {
                    EXPECT_LT(slider.least, slider.most) << slider.name;
                    EXPECT_LE(slider.least, slider.value + 0.1 * (slider.most - slider.least));
                    EXPECT_GE(slider.most, slider.value - 0.1 * (slider.most - slider.least));
                    ++checked;
                }
            }
            // Held where it is, nothing that is seen changes.
            const double time = scene.timeline.time(scene.output.poster);
            const Values values = animation.at(time);
            Overrides all;
            for (const Slider& slider : sliders(found, values, {}))
                all.values[slider.name] = slider.value;
            EXPECT_EQ(apply(animation, all).at(time), values);
        }
    }
    EXPECT_GT(checked, 100);
}

} // namespace
} // namespace isomotion::player
