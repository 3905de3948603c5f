// Sliders that make waves shorter make steps shorter, too.
#include "player/model/held_steps.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "player/model/session.h"
#include "scene/reading/load.h"

namespace isomotion::player {
namespace {

scene::Scene loaded(const std::string& text, const std::vector<scene::Override>& overrides = {}) {
    const auto file = std::filesystem::temp_directory_path() /
                      ("isomotion-waves-" + std::to_string(getpid()) + ".toml");
    std::ofstream(file) << text;
    scene::Scene scene = scene::load(file.string(), overrides);
    std::filesystem::remove(file);
    return scene;
}

const std::string waves =
    "formula = \"sin(k*x)*sin(k*y)*sin(k*z) - 0.6\"\nbounds = { sphere = 1 }\n";
const std::string ranges = "k = { default = 2, min = 1, max = 40 }\n";

TEST(HeldSteps, FollowASlider) {
    const std::string text = "[surface]\n" + waves + "[parameters]\n" + ranges;
    Session session(loaded(text));
    const formula::CubicSteps own = session.at(1).surfaces[0].cubic_steps;
    EXPECT_EQ(own.longest, 1);

    Look look = session.look();
    look.overrides.values["k"] = 40;
    session.set(look);
    const formula::CubicSteps held = session.at(1).surfaces[0].cubic_steps;
    EXPECT_LT(held.first, 0.5 * own.first);
    EXPECT_EQ(held, loaded(text, {"k=40"}).surfaces[0].measured.cubic_steps);
    look.camera = session.at(1).camera; // a camera changes none
    session.set(look);
    EXPECT_EQ(session.at(1).surfaces[0].cubic_steps, held);
    session.reload(loaded(text), 0); // nor does reading the file again
    EXPECT_EQ(session.at(1).surfaces[0].cubic_steps, held);

    look.overrides.values.clear();
    session.set(look);
    EXPECT_EQ(session.at(1).surfaces[0].cubic_steps, own);
}

TEST(HeldSteps, BelongToTheSurfaceOfTheSlider) {
    const std::string text = "[[surfaces]]\nname = \"a\"\n" + waves + "[surfaces.parameters]\n" +
                             ranges +
                             "[[surfaces]]\nname = \"b\"\nformula = \"cos(x) - y\"\n"
                             "bounds = { sphere = 1 }\n";
    Session session(loaded(text));
    const scene::SceneAt own = session.at(1);
    Look look = session.look();
    look.overrides.values["a/k"] = 40;
    session.set(look);
    const scene::SceneAt held = session.at(1);
    EXPECT_LT(held.surfaces[0].cubic_steps.first, 0.5 * own.surfaces[0].cubic_steps.first);
    EXPECT_EQ(held.surfaces[1].cubic_steps, own.surfaces[1].cubic_steps);
}

// A page takes these while a slider holds a parameter.
TEST(HeldSteps, AtSliderEndsAreTheShortest) {
    const std::string text = "[surface]\n" + waves + "[parameters]\n" + ranges;
    const formula::CubicSteps ends = steps_at_slider_ends(loaded(text));
    for (const char* value : {"k=1", "k=2", "k=40"}) {
        const formula::CubicSteps steps = loaded(text, {value}).surfaces[0].measured.cubic_steps;
        EXPECT_LE(ends.first, steps.first);
        EXPECT_LE(ends.longest, steps.longest);
    }
    EXPECT_EQ(ends.first, loaded(text, {"k=40"}).surfaces[0].measured.cubic_steps.first);
}

} // namespace
} // namespace isomotion::player
