// Scripts of MathMod as scenes.
#include "testing.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "formula/field.h"
#include "scene/reading/material.h"
#include "scene/reading/mathmod.h"
#include "scene/scene_at.h"

namespace isomotion::scene::mathmod_test {
namespace {

using testing::HasSubstr;

// A script with a formula and more keys before it: "\"Const\": [\"a=2\"],".
std::string script(const std::string& formula, const std::string& more = "",
                   const std::string& limit = "2") {
    return fmt::format(R"({{
  "Iso3D": {{
    "Name": ["Model"], {1}
    "Component": ["A"],
    "Fxyz": ["{0}"],
    "Xmin": ["-{2}"], "Xmax": ["{2}"],
    "Ymin": ["-{2}"], "Ymax": ["{2}"],
    "Zmin": ["-{2}"], "Zmax": ["{2}"]
  }}
}})",
                       formula, more, limit);
}

Scene scene_of(const std::string& text) { return load_text(text, "model.js"); }
std::string mistake_of(const std::string& text) { return mistake_of_text(text, "model.js"); }

double value_of(const Scene& scene, const glm::dvec3& place, int frame = 1, std::size_t k = 0) {
    const SceneAt now = at_frame(scene, frame);
    formula::Evaluator<double> evaluator(scene.surfaces[k].field->value);
    double value = 0;
    evaluator.point(formula::convert<double>(now.surfaces[k].bindings),
                    std::array{place.x, place.y, place.z}, {&value, 1});
    return value;
}

constexpr glm::dvec3 p(0.3, -0.4, 0.7);

// What a formula is at p, with a term that makes it a surface in the box.
double at_p(const std::string& formula, const std::string& more = "") {
    return value_of(scene_of(script("(" + formula + ")+1000*(x-1/4)", more)), p) - 50;
}

TEST(MathMod, TorusWithConstantsThatNameOthers) {
    const Scene scene = scene_of(
        script("(sqrt(x*x+y*y)-R)^2+z^2-r^2", R"("Const": ["r=1/4", "R=3*r+pi/pi/4"],)", "3*r+1"));
    EXPECT_EQ(scene.title, "Model");
    EXPECT_NEAR(value_of(scene, p), 0.25 + 0.49 - 0.0625, 1e-12);
    const SceneAt now = at_frame(scene, 1);
    ASSERT_EQ(now.surfaces[0].bounds.shape, Bounds::Shape::box);
    EXPECT_EQ(now.surfaces[0].bounds.max, glm::dvec3(1.75));
    EXPECT_EQ(now.surfaces[0].bounds.min, glm::dvec3(0.25));
}

// Functions take what stands in their calls, also for t, and may ignore it.
TEST(MathMod, GyroidWithThickness) {
    const Scene scene = scene_of(script("Thick(x,y,z,t)",
                                        R"f("Const": ["c=1/100"],
    "Funct": ["Iso=cos(x)*sin(y)+cos(y)*sin(z)+cos(z)*sin(x)", "T=1/5", "Norm=x/sqrt(x*x+y*y+t*t)",
              "DFx=(Iso(x+c,y,z,t)-Iso(x,y,z,t))/c",
              "Thick=(Iso(x+T(x,y,z,t),y,z,t))*(Iso(x-T(x,y,z,t),y,z,t))+Norm(DFx(x,y,z,t),z,y,(2))"],)f"));
    const auto iso = [](double x, double y, double z) {
        return std::cos(x) * std::sin(y) + std::cos(y) * std::sin(z) + std::cos(z) * std::sin(x);
    };
    const double slope = (iso(p.x + 0.01, p.y, p.z) - iso(p.x, p.y, p.z)) / 0.01;
    EXPECT_NEAR(value_of(scene, p),
                iso(p.x + 0.2, p.y, p.z) * iso(p.x - 0.2, p.y, p.z) +
                    slope / std::sqrt(slope * slope + p.z * p.z + 4),
                1e-12);
    EXPECT_EQ(scene.timeline.frames, 1);
}

TEST(MathMod, ExpressionsAreThoseOfFparser) {
    const double x = p.x, y = p.y, z = p.z;
    const std::pair<const char*, double> cases[] = {
        {"-x^2", -x * x},
        {"2^3^2/100", 5.12},
        {"2^-1*x", x / 2},
        {"-x*y - -z", -x * y + z},
        {"z-x-y", z - x - y},
        {"z/(x/y)", z / (x / y)},
        {"1e1*x + .5 + 2.", 10 * x + 2.5},
        {"y^(1/3)", -std::cbrt(0.4)}, // numbers below 0 have odd roots
        {"abs(y)^(1/2)", std::sqrt(0.4)},
        {"pow(y,3) + sqrt(z)", y * y * y + std::sqrt(z)},
        {"(7*y)%2", std::fmod(7 * y, 2)},
        {"int(7*y) + int(2*x)", -2},
        {"trunc(7*y) + floor(7*y) + ceil(7*y)", -7},
        {"x<z", 1},
        {"(x<y)+(y<x)+(x!=y)*4", 5},
        {"(2*x=2*x)+3", 4},
        {"x<y<z", 1}, // (x < y) < z
        {"x>0 & y>0 | z>0", 1},
        {"!(x>0) + 2*!0", 2},
        {"if(x>0 & !(y>0), 5, 6)", 5},
        {"if(x, 5, 6)", 6}, // 0.3 rounds to 0
        {"if(z, 5, 6)", 5},
        {"atan2(y,x) + hypot(x,y)", std::atan2(y, x) + 0.5},
        {"asinh(y) + acosh(1+x) + atanh(x)", std::asinh(y) + std::acosh(1.3) + std::atanh(x)},
        {"csc(x)+sec(x)+cot(x)", 1 / std::sin(x) + 1 / std::cos(x) + 1 / std::tan(x)},
        {"log2(z)+log10(z)+log(z)+exp2(z)",
         std::log2(z) + std::log10(z) + std::log(z) + std::exp2(z)},
        {"min(x,y)*max(y,z)", -0.28},
        {"sinh(x)+cosh(y)+tanh(z)+cbrt(y)",
         std::sinh(x) + std::cosh(y) + std::tanh(z) + std::cbrt(y)},
    };
    for (const auto& [formula, expected] : cases)
        EXPECT_NEAR(at_p(formula), expected, 1e-9) << formula;
}

// Names that formulas here have for themselves.
TEST(MathMod, NamesMayBeWordsOfFormulas) {
    const char* more = R"("Const": ["ln=2", "sum=3", "time=4", "and=5", "step=6", "remainder=7"],
    "Funct": ["least=x*ln", "mod=least(y,x,z,t)+remainder"],)";
    EXPECT_NEAR(at_p("mod(x,y,z,t)+sum+time+and+step", more), 2 * p.y + 7 + 18, 1e-9);
}

TEST(MathMod, VariablesAreFunctionsOfEachCoordinate) {
    EXPECT_NEAR(at_p("Ax*Ay+Bz", R"("Const": ["k=2"], "Varu": [" A = k*u^2; B=u+tm"],)"),
                4 * 0.09 * 0.16 + 0.7, 1e-9);
}

TEST(MathMod, TheTimeIsThatOfTheScene) {
    const Scene scene =
        scene_of(script("x^2+y^2+z^2-1-F(x,y,z,t)", R"("Funct": ["F=sin(t)*x"],)", "(2+sin(t))"));
    EXPECT_EQ(scene.timeline.frames, 120);
    EXPECT_NEAR(value_of(scene, p, 31), 0.74 - 1 - std::sin(1) * 0.3, 1e-9);
    EXPECT_NEAR(at_frame(scene, 31).surfaces[0].bounds.max.x, 2 + std::sin(1), 1e-9);
}

TEST(MathMod, SlidersAreParameters) {
    std::string text = script("x^2+y^2+z^2-r*k", R"("Const": ["r=5", "k=2*r"],)");
    text.insert(text.rfind('}'), R"(, "Sliders": {"Name": ["r", "unused"], "Min": ["0", "0"],
        "Max": ["1", "1"], "Step": ["1", "1"], "Position": ["0.25", "1", "0.75", "2"]})");
    // Constants take constants, as in MathMod.
    EXPECT_NEAR(value_of(scene_of(text), p), 0.74 - 0.25 * 10, 1e-12);
    EXPECT_NEAR(value_of(load_text(text, "model.js", {"r=0.5"}), p), 0.74 - 5, 1e-12);
}

constexpr const char* two = R"f({ "Iso3D": {
  "Component": ["Ball", "Plane"],
  "Fxyz": ["x^2+y^2+z^2-t",
           "z-floor(x)"],
  "Cnd": ["", "x>y"],
  "Xmin": ["1", "-2"], "Xmax": ["-1", "2"], "Ymin": ["-1", "-2"], "Ymax": ["1", "2"],
  "Zmin": ["-1", "-2"], "Zmax": [1, 2]
}
})f";

TEST(MathMod, EachComponentIsASurface) {
    const Scene scene = scene_of(two);
    ASSERT_EQ(scene.surfaces.size(), 2);
    EXPECT_EQ(scene.surfaces[1].label, "Plane");
    EXPECT_NEAR(value_of(scene, p, 31, 0), 0.74 - 1, 1e-12);
    EXPECT_NEAR(value_of(scene, p, 31, 1), 0.7, 1e-12);
    const SceneAt now = at_frame(scene, 1);
    EXPECT_EQ(now.surfaces[0].bounds.min, glm::dvec3(-1));
    EXPECT_EQ(now.surfaces[1].bounds.max, glm::dvec3(2));
    EXPECT_FALSE(scene.surfaces[0].jumps_are_walls);
    EXPECT_TRUE(scene.surfaces[1].jumps_are_walls);
    EXPECT_TRUE(paints_of(scene.surfaces[0].material).empty());
    EXPECT_FALSE(paints_of(scene.surfaces[1].material).empty());
}

TEST(MathMod, OneOfSeveralModelsIsNamed) {
    std::string text = R"({ "MathModels": [ {"Param3D": {"Name": ["Shell"]}}, )";
    text += script("x^2+y^2+z^2-1") + " ] }";
    EXPECT_THAT(mistake_of(text), testing::StartsWith("model.js:1: MathModels: has 2 models; name "
                                                      "one, as model.js#Model. Those of"));
    EXPECT_THAT(mathmod_as_toml(text, "model.js", "Model"), HasSubstr("surface.formula = "));
    const auto mistake = [&](const char* model) {
        try {
            mathmod_as_toml(text, "model.js", model);
        } catch (const SceneError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_THAT(mistake("Mode"), HasSubstr("did you mean 'model.js#Model'?"));
    EXPECT_THAT(mistake("Shell"), HasSubstr("only surfaces by an equation are read"));
    EXPECT_EQ(model_name("a/b.js#Two #2")->model, "Two #2");
    EXPECT_EQ(model_name("a/b.js#Two #2")->file, "a/b.js");
    EXPECT_FALSE(model_name("x#y"));
}

using MathModFiles = Scenes;

TEST_F(MathModFiles, AreNamedWithTheirModels) {
    const std::string file = write("all (1).js", R"({ "MathModels": [ )" + script("x^2+y^2-1") +
                                                     ", " + script("x-y") + " ] }")
                                 .string();
    EXPECT_EQ(load(file + "#Model").title, "Model");
    EXPECT_THAT(mistake_of_name(file), HasSubstr("all (1).js:1: MathModels: has 2 models"));
    EXPECT_THAT(mistake_of_name(file + "#None"), HasSubstr("has no model 'None'; it has Model"));
    EXPECT_THAT(mistake_of_name("none.js#Model"), HasSubstr("none.js: no such file"));
}

TEST(MathMod, ItsKindIsSeenByItsContent) {
    EXPECT_EQ(load_text("\n " + script("x^2+y^2-1"), "model.txt").title, "Model");
}

// Texts of old collections go over several lines.
TEST(MathMod, TextsMayHaveLineEnds) {
    EXPECT_NEAR(at_p("x\n\t*2"), 0.6, 1e-9);
    EXPECT_THAT(mistake_of(script("x\n*q")),
                testing::StartsWith("model.js:5: Fxyz: unknown name 'q'"));
}

TEST(MathMod, MistakesHaveTheLinesOfTheFile) {
    const std::pair<std::string, const char*> cases[] = {
        {script("x+q"), "model.js:5: Fxyz: unknown name 'q'"},
        {script("x+sine(y)"), "model.js:5: Fxyz: unknown function 'sine'; did you mean 'sin'?"},
        {script("NoiseW(x,y,z,1,2,0)"),
         "model.js:5: Fxyz: 'NoiseW' is a function of MathMod itself"},
        {script("2x"), "model.js:5: Fxyz: needs an operator before 'x'"},
        {script("x+"), "model.js:5: Fxyz: ends where a number or a name is needed"},
        {script("(x"), "model.js:5: Fxyz: needs ')' at its end"},
        {script("atan2(x)"), "model.js:5: Fxyz: 'atan2' takes 2 arguments, not 1"},
        {script("F(x,y)", R"("Funct": ["F=x"],)"),
         "model.js:5: Fxyz: 'F' takes 4 arguments, not 2"},
        {script("x", R"("Const": ["a"],)"), "model.js:3: Const: 'a' has no value; write a=..."},
        {script("x", R"("Const": ["a=1/0"],)"), "model.js:3: Const: 'a' has no finite value"},
        {script("x", R"("Const": ["a=b", "b=1"],)"), "model.js:3: Const: unknown name 'b'"},
        {script("x", R"("Const": ["a b=1"],)"), "model.js:3: Const: 'a b' is no name"},
        {script("x", R"("Const": "a=1",)"), "model.js:3: Const: must be a list"},
        {script("x", R"("Const": [[]],)"), "model.js:3: Const: must be a list of texts in quotes"},
        {script("x", "", "y"), "model.js:6: Xmin: unknown name 'y'"},
        {script("1"), "model.js:5: surface.formula: "},
        {R"({"Iso3D": {"Name": ["A"]}})", "model.js:1: Fxyz: is missing"},
        {R"({"Iso3D": {"Fxyz": ["x"]}})", "model.js:1: Xmin: is missing"},
        {R"({"Iso3D": 5})", "model.js:1: Iso3D: must hold keys"},
        {R"({"ParIso": [{"Iso3D": {}}]})", "model.js:1: ParIso: is a surface by parameters"},
        {"{\"a\": 1}", "model.js:1: is JSON, but no script of MathMod"},
        {"{\n\"a\": \n}", "model.js:3: is no JSON from '"},
    };
    for (const auto& [text, start] : cases)
        EXPECT_THAT(mistake_of(text), testing::StartsWith(start)) << text;
}

TEST(MathMod, EachComponentNeedsItsLimits) {
    std::string text = two;
    text.replace(text.find(R"(["1", "-2"])"), 11, R"(["1"])");
    EXPECT_EQ(mistake_of(text), "model.js:6: Xmin: has 1 of the 2 values that the components need");
}

// The last of equal names counts.
TEST(MathMod, SlidersMayRepeatNames) {
    std::string text = script("x^2+y^2+z^2-r");
    text.insert(text.rfind('}'), R"(, "Sliders": {"Name": ["r", "r"], "Position": [1, 2]})");
    EXPECT_NEAR(value_of(scene_of(text), p), 0.74 - 2, 1e-12);
}

TEST(MathMod, LongAndDeepTextsAreMistakes) {
    const auto repeated = [](const std::string& part, int count) {
        std::string text;
        for (int k = 0; k < count; ++k) text += part;
        return text;
    };
    for (const char* part : {"(", "-", "!", "abs(", "x^", "if(x,", "x<"}) {
        EXPECT_THAT(mistake_of(script(repeated(part, 80'000) + "x")),
                    testing::StartsWith("model.js:5: Fxyz: has more than 90 parentheses"))
            << part;
    }
    for (const char* part : {"x|", "x&", "x%", "x*y+"})
        EXPECT_NE(mistake_of(script(repeated(part, 100'000) + "x")), "") << part;
    EXPECT_THAT(mistake_of("{\"a\":" + repeated("[", 100'000)), HasSubstr("more than 32 deep"));
    EXPECT_THAT(mistake_of("{\"a\":[" + repeated("1,", 1'000'001) + "1]}"),
                HasSubstr("more than 1000000 values"));
    // Each function calls the one before it twice.
    std::string functions = R"("Funct": ["F0=x*y")";
    for (int k = 1; k < 60; ++k)
        functions += fmt::format(R"f(, "F{0}=F{1}(y,x,z,t)+F{1}(x*x,z,y,t)")f", k, k - 1);
    EXPECT_THAT(mistake_of(script("F59(x,y,z,t)", functions + "],")), HasSubstr("model.js:5: "));
}

// Whatever is in a text, it stays in it.
TEST(MathMod, TextsAreNoTomlOfTheirOwn) {
    std::string text = script("x^2+y^2+z^2-1");
    text.replace(text.find("Model"), 5, R"(a\"\ncamera.fov=3\u0001)");
    const Scene scene = scene_of(text);
    EXPECT_THAT(scene.title, testing::StartsWith("a\""));
    for (const char* formula : {"x\\\"\\ncamera.fov=3", "x'", "]]", "x\\u0001y"}) {
        EXPECT_THAT(mistake_of(script(formula)), testing::StartsWith("model.js:5: Fxyz: "))
            << formula;
    }
}

} // namespace
} // namespace isomotion::scene::mathmod_test
