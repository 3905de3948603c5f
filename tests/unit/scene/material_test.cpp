// [material]: models of reflection, their numbers, and what is said of the wrong ones.
#include "testing.h"

namespace isomotion::scene {
namespace {

class Materials : public Scenes {
protected:
    static std::string with(const std::string& lines) { return ball_and("[material]\n" + lines); }
    glm::dvec4 gloss(const std::string& lines, double time = 0) const {
        return at_time(loaded(with(lines)), time).surfaces[0].gloss;
    }
};

using Model = Material::Model;

TEST_F(Materials, TheWrongModelsKeys) {
    for (const char* lambert : {"", "model = \"lambert\"\n"}) {
        const std::string place = *lambert ? "scene.toml:17: " : "scene.toml:16: ";
        EXPECT_EQ(mistake(with(std::string(lambert) + "roughness = 0.5")),
                  place + "material.roughness: roughness is of model ggx; this one is lambert");
        EXPECT_EQ(mistake(with(std::string(lambert) + "specular = 0.5")),
                  place + "material.specular: specular is of models blinn-phong and ggx; this one "
                          "is lambert");
    }
    EXPECT_EQ(mistake(with("model = \"blinn-phong\"\nmetallic = 1")),
              "scene.toml:17: material.metallic: metallic is of model ggx; this one is "
              "blinn-phong");
    EXPECT_EQ(mistake(with("model = \"ggx\"\nshininess = 1")),
              "scene.toml:17: material.shininess: shininess is of model blinn-phong; this one is "
              "ggx");
}

TEST_F(Materials, ModelsThatAreNone) {
    EXPECT_EQ(mistake(with("model = \"gxx\"")),
              "scene.toml:16: material.model: there is no model 'gxx'; did you mean 'ggx'? known: "
              "lambert, blinn-phong, ggx");
    EXPECT_EQ(mistake(with("model = \"velvet\"")),
              "scene.toml:16: material.model: there is no model 'velvet'; known: lambert, "
              "blinn-phong, ggx");
    EXPECT_EQ(mistake(with("model = 3")),
              "scene.toml:16: material.model: must be a text in quotes");
    EXPECT_EQ(mistake(with("model = \"ggx\"\nroughnes = 1")),
              "scene.toml:17: material.roughnes: unknown key; did you mean 'roughness'?");
}

TEST_F(Materials, OutOfRangeAtATime) {
    const auto at_two = [&](const std::string& lines) {
        const Scene scene = loaded(with(lines));
        try {
            at_time(scene, 2);
        } catch (const SceneError& error) {
            const std::string message = error.what();
            return message.substr(message.find("scene.toml"));
        }
        return std::string("nothing is wrong");
    };
    const std::string ggx = "model = \"ggx\"\n", phong = "model = \"blinn-phong\"\n";
    EXPECT_EQ(at_two(ggx + "roughness = \"t\""),
              "scene.toml:17: material.roughness at t = 2: must be from 0 to 1, not 2");
    EXPECT_EQ(at_two(ggx + "metallic = \"-t\""),
              "scene.toml:17: material.metallic at t = 2: must be from 0 to 1, not -2");
    EXPECT_EQ(at_two(ggx + "specular = { keys = [[0, 0], [2, 1.5]] }"),
              "scene.toml:17: material.specular at t = 2: must be from 0 to 1, not 1.5");
    EXPECT_EQ(at_two(phong + "shininess = \"1e4*t\""),
              "scene.toml:17: material.shininess at t = 2: must be from 0 to 10000, not 20000");
    EXPECT_EQ(at_two(phong + "specular = \"t/2\"\nshininess = \"5e3*t\""), "nothing is wrong");
}

TEST_F(Materials, NumbersInTheOrderOfTheShader) {
    EXPECT_EQ(gloss("model = \"ggx\"\nspecular = 0.25\nmetallic = 1\nroughness = 0.5"),
              glm::dvec4(0.5, 1, 0.25, 0));
    EXPECT_EQ(gloss("model = \"blinn-phong\"\nspecular = 0.25\nshininess = 10000"),
              glm::dvec4(10000, 0.25, 0, 0));
    EXPECT_EQ(gloss("model = \"ggx\""), glm::dvec4(0.4, 0, 0.04, 0));
    EXPECT_EQ(gloss("model = \"blinn-phong\""), glm::dvec4(50, 0.2, 0, 0));
    EXPECT_EQ(gloss("model = \"lambert\""), glm::dvec4(0));
    EXPECT_EQ(at_time(loaded(ball()), 0).surfaces[0].gloss, glm::dvec4(0));
    EXPECT_EQ(loaded(ball()).surfaces[0].material.model, Model::lambert);
}

TEST_F(Materials, NumbersMove) {
    const std::string lines = "model = \"ggx\"\nroughness = \"t/2\"\n"
                              "metallic = { keys = [[0, 0], [2, 1]] }";
    EXPECT_EQ(gloss(lines, 0), glm::dvec4(0, 0, 0.04, 0));
    EXPECT_EQ(gloss(lines, 1), glm::dvec4(0.5, 0.5, 0.04, 0));
    EXPECT_EQ(gloss(lines, 2), glm::dvec4(1, 1, 0.04, 0));
}

TEST_F(Materials, TheCommandLineSetsThem) {
    const Scene scene = loaded(ball(), {"material.model=ggx", "material.roughness=0.1"});
    EXPECT_EQ(scene.surfaces[0].material.model, Model::ggx);
    EXPECT_EQ(at_time(scene, 0).surfaces[0].gloss.x, 0.1);
}

TEST_F(Materials, WhatLightGoesThrough) {
    EXPECT_FALSE(loaded(ball()).surfaces[0].material.glass);
    const Scene plain = loaded(with("transmission = 1"));
    EXPECT_EQ(plain.surfaces[0].material.glass->depth, 4);
    EXPECT_EQ(at_time(plain, 0).surfaces[0].glass.ior, 1.5);
    const Scene moving = loaded(with("transmission = \"t/2\"\nior = \"1 + t\"\ndepth = 16\n"
                                     "absorption = [\"t\", 0, 0.5]"));
    const GlassAt glass = at_time(moving, 1).surfaces[0].glass;
    EXPECT_EQ(glass.transmission, 0.5);
    EXPECT_EQ(glass.ior, 2);
    EXPECT_EQ(glass.absorption, glm::dvec3(1, 0, 0.5));
    EXPECT_EQ(moving.surfaces[0].material.glass->depth, 16);
}

TEST_F(Materials, WhatLightCannotGoThrough) {
    for (const char* key : {"ior = 1.5", "absorption = [0, 0, 0]", "depth = 3", "priority = 1"}) {
        const std::string name = std::string(key).substr(0, std::string(key).find(' '));
        EXPECT_EQ(mistake(with(key)), "scene.toml:16: material." + name + ": " + name +
                                          " is of matter that light goes through; give "
                                          "transmission = 1 as well");
    }
    EXPECT_EQ(mistake(with("transmission = 1\nreflection = \"sky\"")),
              "scene.toml:17: material.reflection: what light goes through mirrors what is around "
              "by its ior; leave reflection out, or transmission");
    EXPECT_EQ(mistake(with("transmission = 1\ndepth = 17")),
              "scene.toml:17: material.depth: must be from 0 to 16, not 17");
    const auto at_once = [&](const std::string& lines) {
        const std::string message = mistake(with(lines));
        return message.substr(message.find("material."));
    };
    EXPECT_EQ(at_once("transmission = 1.5"),
              "material.transmission at t = 0: must be from 0 to 1, not 1.5");
    EXPECT_EQ(at_once("transmission = 1\nior = 0"),
              "material.ior at t = 0: must be from 0.01 to 100, not 0");
    EXPECT_EQ(at_once("transmission = 1\nabsorption = [0, -1, 0]"),
              "material.absorption.y at t = 0: must be from 0 to 1000000, not -1");
    EXPECT_EQ(mistake(with("transmission = 1\npriority = 1001")),
              "scene.toml:17: material.priority: must be from -1000 to 1000, not 1001");
    EXPECT_EQ(mistake(with("transmission = 1\npriority = 0.5")),
              "scene.toml:17: material.priority: must be an integer");
}

// A surface of the catalogue has colours only.
TEST_F(Materials, OfTheCatalogue) {
    const std::string body = "formula = \"x^2 + y^2 + z^2 - 1\"\nbounds = { sphere = 2 }\n"
                             "[material]\ncolor = [0, 0, 1]\n";
    surface("blue", body);
    surface("glossy", body + "roughness = 0.5\n");
    const Scene scene =
        loaded("[surface]\nuse = \"blue\"\n[material]\nmodel = \"ggx\"\nroughness = 0\n");
    EXPECT_EQ(scene.surfaces[0].material.model, Model::ggx);
    EXPECT_EQ(at_time(scene, 0).surfaces[0].color, glm::dvec3(0, 0, 1));
    EXPECT_EQ(mistake("[surface]\nuse = \"glossy\"\n"),
              "animations/surfaces/glossy.toml:5: material.roughness: unknown key; known here: "
              "back_color, color");
}

} // namespace
} // namespace isomotion::scene
