#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <thread>

#include "api/error_code.h"

namespace isomotion {
namespace {

constexpr const char* growing = R"(title = "A ball that grows"
[time]
fps = 25
frames = 51
[surface]
formula = "x^2 + y^2 + z^2 - r^2"
bounds = { sphere = 4 }
[parameters]
r = "0.5 + t"
[output]
size = [64, 48]
poster = 7
)";

TEST(Scene, SaysWhatItsFileSays) {
    const Scene scene = Scene::parse(growing);
    EXPECT_EQ(scene.title(), "A ball that grows");
    EXPECT_EQ(scene.frames(), 51);
    EXPECT_EQ(scene.frames_per_second(), 25);
    EXPECT_EQ(scene.time(26), 1);
    EXPECT_EQ(scene.poster(), 7);
    EXPECT_EQ(scene.width(), 64);
    EXPECT_EQ(scene.height(), 48);
    EXPECT_EQ(scene.surfaces(), std::vector<std::string>{""});
    EXPECT_TRUE(scene.files().empty());
    EXPECT_EQ(scene.parameters(26), (std::map<std::string, double>{{"r", 1.5}}));
}

TEST(Scene, ChangesByCopies) {
    const Scene scene = Scene::parse(growing);
    EXPECT_EQ(scene.with("r", 2).with("time.frames", 9).parameters(9).at("r"), 2);
    EXPECT_EQ(scene.with("r", "1 - t").parameters(26).at("r"), 0);
    EXPECT_EQ(scene.with("output.size", "[32, 16]").width(), 32);
    EXPECT_EQ(scene.parameters(26).at("r"), 1.5);
    EXPECT_EQ(told([&] { scene.with("r", "1\nq = 2"); }).code, Error::Code::input);
    EXPECT_EQ(told([&] { scene.with("", "1"); }).code, Error::Code::input);
}

TEST(Scene, TellsWhatMakesItsFramesTakeLong) {
    const Scene scene = Scene::parse(growing);
    EXPECT_EQ(scene.costs(), "64x48 pixels (--size)");
    EXPECT_EQ(scene.with("output.samples", 16)
                  .with("material.transmission", 0.9)
                  .with("material.depth", 6)
                  .costs(),
              "16 samples a pixel (--set output.samples=1), glass 6 rays deep "
              "(material.glass.depth), 64x48 pixels (--size)");
}

TEST(Scene, KnowsNumbersOfFramesAndNamesOfMethods) {
    EXPECT_EQ(frame_numbers("1-7x3,2"), (std::vector{1, 4, 7, 2}));
    EXPECT_EQ(frame_numbers("3-1"), (std::vector{3, 2, 1}));
    EXPECT_EQ(told([] { frame_numbers("1-"); }).code, Error::Code::input);
    const std::vector<std::string> names = methods();
    EXPECT_EQ(std::ranges::count(names, "amp-sign"), 1);
    for (const std::string& name : names) Scene::parse(growing).with("isolation.method", name);
}

TEST(Scene, IsAFileAnAnimationOrAFormula) {
    const auto names = animations();
    ASSERT_TRUE(std::ranges::is_sorted(names));
    ASSERT_NE(std::ranges::find(names, "blobby75"), names.end());
    const Scene blobby = Scene::load("blobby75");
    ASSERT_FALSE(blobby.files().empty());
    EXPECT_EQ(blobby.files().front().filename(), "blobby75.toml");
    EXPECT_EQ(blobby.name(), "blobby75");
    const Scene formula = Scene::load("x^2 + y^2 + z^2 = a*b", {"a=1", "b=2"});
    EXPECT_EQ(formula.parameters(1).size(), 2u);
    EXPECT_EQ(formula.name(), "formula");
    EXPECT_TRUE(formula.files().empty());

    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / "isomotion_api_scene_test.toml";
    std::ofstream(file) << growing;
    EXPECT_EQ(Scene::load(file.string()).files(), std::vector{file});
    EXPECT_EQ(Scene::load(file.string()).file(), file);
    EXPECT_FALSE(formula.file());
    std::filesystem::remove(file);
    EXPECT_EQ(told([&] { Scene::load(file.string()); }).code, Error::Code::input);
}

TEST(Scene, NamesItsSurfaces) {
    const Scene two = Scene::parse("[[surfaces]]\nname = 'a'\nformula = 'x^2 + y^2 + z^2 - k'\n"
                                   "bounds = { sphere = 2 }\nparameters = { k = 1 }\n"
                                   "[[surfaces]]\nname = 'b'\nformula = 'x - 2*z'\n"
                                   "bounds = { sphere = 2 }\n");
    EXPECT_EQ(two.surfaces(), (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(two.parameters(1, "a").at("k"), 1);
    EXPECT_TRUE(two.parameters(1, "b").empty());
    EXPECT_EQ(told([&] { two.parameters(1, "c"); }).code, Error::Code::input);
    EXPECT_EQ(told([&] { two.parameters(1); }).code, Error::Code::input);

    const Scene alone = two.alone("b");
    EXPECT_EQ(alone.surfaces().size(), 1u);
    EXPECT_TRUE(alone.parameters(1).empty());
    // It stays alone with other settings.
    EXPECT_EQ(alone.with("output.size", "[32, 16]").surfaces().size(), 1u);
    EXPECT_EQ(two.surfaces().size(), 2u);
    EXPECT_EQ(told([&] { two.alone("c"); }).code, Error::Code::input);
}

TEST(Scene, TellsAllMistakesWithTheirLines) {
    const Told mistakes = told([] {
        Scene::parse("[surface]\nformula = 'x'\nbounds = { sphere = 1 }\n[camera]\nfov = 'wide'\n"
                     "[output]\nsizes = [1, 1]\n");
    });
    EXPECT_EQ(mistakes.code, Error::Code::input);
    EXPECT_NE(mistakes.words.find(":5: camera.fov"), std::string::npos) << mistakes.words;
    EXPECT_NE(mistakes.words.find(":7: output.sizes"), std::string::npos) << mistakes.words;
}

// The ray through the middle of a picture meets the ball at its nearest point.
TEST(FirstRoots, EncloseClosedForms) {
    const Scene scene = Scene::parse(growing).with("camera.position", "[0, 6, 0]");
    const auto roots = first_roots(scene, 26, 33, 33);
    ASSERT_EQ(roots.size(), 33u * 33u);
    const FirstRoot& middle = roots[33 * 16 + 16];
    EXPECT_EQ(middle.answer, FirstRoot::Answer::hit);
    EXPECT_LE(middle.root.low, -1.5); // t counts from the plane through the bounds' middle
    EXPECT_GE(middle.root.high, -1.5);
    EXPECT_LT(middle.root.high - middle.root.low, 1e-3);
    EXPECT_EQ(roots.front().answer, FirstRoot::Answer::miss);
}

TEST(FirstRoots, CanBeStoppedAndWatched) {
    const Scene scene = Scene::parse(growing);
    double last = 0;
    const Watcher watcher{.progress = [&](const std::string&, double part) {
        EXPECT_GE(part, last);
        last = part;
    }};
    first_roots(scene, 1, 8, 8, watcher);
    EXPECT_EQ(last, 1);
    EXPECT_EQ(told([&] { first_roots(scene, 1, 8, 8, {.stop = [] { return true; }}); }).code,
              Error::Code::stopped);
    EXPECT_EQ(told([&] { first_roots(scene, 1, 0, 8); }).code, Error::Code::input);
    EXPECT_EQ(told([&] { first_roots(scene, 0, 8, 8); }).code, Error::Code::input);
    EXPECT_EQ(told([&] { first_roots(scene, 1, 8, 1'000'000); }).code, Error::Code::limit);
    EXPECT_EQ(told([&] { scene.parameters(-1); }).code, Error::Code::input);
}

TEST(Scene, SaysWhetherSectionsCutIt) {
    EXPECT_FALSE(Scene::parse(growing).is_cut());
    EXPECT_TRUE(Scene::parse(std::string(growing) + "[[sections]]\nnormal = [1, 0, 0]\n").is_cut());
}

TEST(Scene, IsSharedByThreads) {
    const Scene scene = Scene::parse(growing);
    std::vector<double> radii(8);
    {
        std::vector<std::jthread> threads;
        for (std::size_t k = 0; k < radii.size(); ++k)
            threads.emplace_back(
                [&, k] { radii[k] = scene.with("r", double(k)).parameters(1).at("r"); });
    }
    for (std::size_t k = 0; k < radii.size(); ++k) EXPECT_EQ(radii[k], double(k));
}

} // namespace
} // namespace isomotion
