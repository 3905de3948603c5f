// A mistake in a scene: exit code 2, a message with file, line and key, and nothing made.
#include "cli.h"

namespace isomotion::cli {
namespace {

struct Mistake {
    const char* name;
    std::string scene;
    std::string message;
};

std::string sphere_with(const std::string& line, const std::string& instead) {
    std::string text = sphere_scene();
    return text.replace(text.find(line), line.size(), instead);
}

const Mistake mistakes[] = {
    {"formula ends too soon", formula_scene("x^2 - r^2 +"),
     "scene.toml:6: surface.formula: the formula ends where a value is expected\n"
     "    x^2 - r^2 +\n"
     "               ^\n"},
    {"unknown name in formula", formula_scene("x^2 + yy - r"),
     "scene.toml:6: surface.formula: unknown name 'yy'; did you mean 'y'?\n"
     "    x^2 + yy - r\n"
     "          ^\n"},
    {"unknown function", formula_scene("x - coz(r)"),
     "scene.toml:6: surface.formula: there is no function 'coz'"},
    {"division by zero", formula_scene("x^2/0 - r"),
     "scene.toml:6: surface.formula: division by zero\n"
     "    x^2/0 - r\n"
     "       ^\n"},
    {"division by what folds to zero", formula_scene("x^2/(3 - 2 - 1) - r"),
     "scene.toml:6: surface.formula: division by zero"},
    {"unused parameter", formula_scene("x^2 + y^2 - 1"),
     "scene.toml:9: parameters.r: neither the formula nor an expression uses"},
    {"unknown section", sphere_scene() + "[materiel]\ncolor = [1, 1, 1]\n",
     "scene.toml:15: materiel: unknown key; did you mean 'material'?"},
    {"unknown key", sphere_with("fov = 40", "fob = 40"),
     "scene.toml:12: camera.fob: unknown key; did you mean 'fov'?"},
    {"wrong type", sphere_with("frames = 60", "frames = \"many\""),
     "scene.toml:4: time.frames: must be an integer"},
    {"bad expression", sphere_with("sin(t)", "sin(tt)"),
     "scene.toml:9: parameters.r: unknown name 'tt'"},
    {"times descend", sphere_with("\"1 + 0.2*sin(t)\"", "{ keys = [[1, 1], [0, 2]] }"),
     "scene.toml:9: parameters.r.keys[1]: times must ascend"},
    {"unknown surface",
     sphere_with("formula = \"x^2 + y^2 + z^2 - r^2\"", "use = \"superquadrik\""),
     "scene.toml:6: surface.use: there is no surface 'superquadrik'; did you mean 'superquadric'?"},
    {"bad value at start", sphere_with("sphere = 1.5", "sphere = \"t\""),
     "scene.toml:7: surface.bounds.sphere at t = 0: the radius must be above 0"},
    {"not TOML", sphere_with("[camera]", "[camera"), "scene.toml:10: not valid TOML: "},
    {"key twice", sphere_scene() + "size = [9, 9]\n", "scene.toml:15: not valid TOML: "},
    {"empty", " ", "scene.toml:1: surface: is missing; give formula = "},
};

TEST_F(Cli, AMistakeInASceneIsToldWithItsPlaceAndMakesNothing) {
    for (const Mistake& mistake : mistakes) {
        SCOPED_TRACE(mistake.name);
        write("scene.toml", mistake.scene);
        const Ending ending = run({"render", "scene.toml", "-o", "new/a.####.png"});
        EXPECT_EQ(ending.code, 2) << ending;
        EXPECT_THAT(ending.err, StartsWith(mistake.message));
        EXPECT_THAT(ending.out, IsEmpty());
        EXPECT_EQ(names(), (std::set<std::string>{"scene.toml", "sphere.toml"}));
    }
}

TEST_F(Cli, ASceneThatIsNotThereIsToldApart) {
    const std::pair<std::string, std::string> cases[] = {
        {"none.toml", "none.toml: no such file\n"},
        {"twisting_superquadrik", "did you mean 'twisting_superquadric'?"},
        {"quite_unlike_any", "no animation of this name; isomotion list names the "},
        {"sphere", "sphere: no such file; did you mean 'sphere.toml'?\n"},
        {"sphere.tml", "sphere.tml: no such file; did you mean 'sphere.toml'?\n"},
        {".", ".: is a folder; name a scene file (.toml)"},
    };
    for (const auto& [scene, message] : cases) {
        const Ending ending = run({"render", scene});
        EXPECT_EQ(ending.code, 2) << ending;
        EXPECT_THAT(ending.err, HasSubstr(message));
        EXPECT_THAT(ending.out, IsEmpty());
    }
    EXPECT_EQ(names(), std::set<std::string>{"sphere.toml"});
}

TEST_F(Cli, AValueThatLeavesItsRangeLaterLeavesWholeFiles) {
    const Ending ending = run({"render", "sphere.toml", "--set", "camera.fov=40 + 200*t", "-o",
                               "new/a.####.png", "--frames", "20-25"});
    EXPECT_EQ(ending.code, 2) << ending;
    EXPECT_THAT(ending.err, HasSubstr("--set: camera.fov at t = 0.7"));
    expect_only_whole_files();
}

} // namespace
} // namespace isomotion::cli
