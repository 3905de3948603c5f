// What follows a slider of a page.
#include "page/rules.h"

#include <cstdlib>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "formula/graph/functions.h"
#include "page/embedded_files.h"
#include "scene/reading/load.h"

namespace isomotion::page {
namespace {

scene::Scene with_parameters(const std::string& parameters) {
    setenv("ISOMOTION_DATA", ISOMOTION_SOURCE_DIR, /*overwrite=*/1);
    return scene::load_text("[surface]\nformula = 'x^2 + y^2 + z^2 - a'\n"
                            "bounds = { sphere = 'a + 1' }\n[parameters]\n" +
                                parameters,
                            "rules.toml");
}

TEST(Rules, HaveEachFunctionOfOneArgument) {
    const std::string_view script = embedded_files().at("rules.js");
    for (const formula::Function& function : formula::functions()) {
        if (!function.has_value) continue;
        const std::string entry = "\n    " + std::string(function.name) + ": ";
        EXPECT_NE(script.find(entry), std::string_view::npos) << function.name;
    }
}

TEST(Rules, ComeAfterWhatTheyDependOn) {
    const auto scene = with_parameters("a = '1 + b'\nb = '2*c'\nc = 0.5\n");
    const auto rules = rules_of(scene.surfaces[0]);
    ASSERT_EQ(rules["tracks"].size(), 2u);
    const int b = scene.surfaces[0].animation.find("b").value();
    EXPECT_EQ(rules["tracks"][0][0], b);
    EXPECT_EQ(rules["tracks"][1][1]["tracks"][0], b);
    ASSERT_EQ(rules["bounds"].size(), 1u);
    EXPECT_EQ(rules["bounds"][0][0], 3); // the radius
    EXPECT_TRUE(can_be_held(scene.surfaces[0], b));
}

// A field that all elements share is a track; lists of other arrays have no rule to follow it.
TEST(Rules, ListsFollowNoTrackOfAnotherArray) {
    const auto scene = scene::load_text(
        "[surface]\nformula = 'sum(d, exp(-9*((x-cx)^2 + y^2 + z^2))) +"
        " sum(c, r*exp(-9*((x-dx)^2 + y^2 + z^2))) - 0.3'\nbounds = { sphere = 1.5 }\n"
        "[arrays.d]\ncount = 3\ncx = [0.1, 0.2, 0.3]\n"
        "[arrays.c]\ncount = 7\ndx = 'sin(i) + r'\nr = 0.5\n",
        "rules.toml");
    const scene::Surface& surface = scene.surfaces[0];
    EXPECT_TRUE(can_be_held(surface, surface.animation.find("c.r").value()));
}

// As many ways as there are sums: each is gone once.
TEST(Rules, OfManyWaysTakeNoTime) {
    std::string parameters = "a = 'p60'\np0 = 1\np1 = 1\n";
    for (int k = 2; k <= 60; ++k) {
        parameters += "p" + std::to_string(k) + " = 'p" + std::to_string(k - 1) + " - p" +
                      std::to_string(k - 2) + "'\n";
    }
    const auto scene = with_parameters(parameters);
    EXPECT_EQ(rules_of(scene.surfaces[0])["tracks"].size(), 60u);
    EXPECT_TRUE(can_be_held(scene.surfaces[0], scene.surfaces[0].animation.find("p0").value()));
}

} // namespace
} // namespace isomotion::page
