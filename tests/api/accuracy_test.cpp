#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "api/error_code.h"

namespace isomotion {
namespace {

namespace fs = std::filesystem;

Scene wave() {
    return Scene::parse("[surface]\nformula = 'z - 0.3*sin(9*x)*cos(7*y)'\n"
                        "bounds = { sphere = 1.5 }\n[time]\nframes = 3\n"
                        "[output]\nsize = [32, 24]\nposter = 2\n");
}

Device& measured_by() {
    static Device device;
    return device;
}

TEST(AccuracyOf, MeasuresWhatIsPlanned) {
    AccuracySettings settings;
    settings.methods = {"marching", "affine"};
    settings.steps = {0.5, 0.005};
    settings.repeat = 1;
    settings.frames = {1, 3};
    const std::vector<std::string> plan = accuracy_plan(wave(), settings);
    EXPECT_EQ(std::set(plan.begin(), plan.end()),
              (std::set<std::string>{"affine", "marching step=0.5", "marching step=0.005"}));
    double last = 0;
    const Watcher watcher{.progress = [&](const std::string&, double part) { last = part; }};
    const Accuracy accuracy = accuracy_of(measured_by(), wave(), settings, watcher);
    EXPECT_EQ(last, 1);
    const std::vector<Measurement>& all = accuracy.measurements();
    ASSERT_EQ(all.size(), plan.size());
    for (std::size_t k = 0; k < plan.size(); ++k) {
        EXPECT_EQ(all[k].name, plan[k]);
        EXPECT_EQ(all[k].pixels, 2 * 32 * 24);
        EXPECT_GT(all[k].ms, 0);
        EXPECT_GT(all[k].evaluations_a_ray, 1);
        EXPECT_EQ(all[k].proved, 0);
    }
    const auto named = [&](const std::string& name) {
        return *std::ranges::find(all, name, &Measurement::name);
    };
    EXPECT_EQ(named("affine").wrong_ppm(), 0);
    // Steps of half a unit step over waves.
    EXPECT_GT(named("marching step=0.5").wrong_ppm(), 1000);
    EXPECT_GT(named("marching step=0.5").missed, 0);
    ASSERT_NE(accuracy.cheapest(0), nullptr);
    EXPECT_EQ(accuracy.cheapest(0)->wrong_ppm(), 0);
    EXPECT_TRUE(accuracy.cheapest(0)->is_on_front);
    EXPECT_EQ(accuracy.most_accurate(0), nullptr);
    ASSERT_NE(accuracy.most_accurate(1e9), nullptr);
    EXPECT_NE(accuracy.summary().find("marching step=0.5"), std::string::npos);
}

TEST(AccuracyOf, CountsProofs) {
    AccuracySettings settings;
    settings.methods = {"affine"};
    settings.repeat = 1;
    const Scene scene = wave().with("isolation.certify", "true");
    const Accuracy accuracy = accuracy_of(measured_by(), scene, settings);
    EXPECT_GT(accuracy.measurements().front().proved, 0.5);
    EXPECT_EQ(accuracy.measurements().front().contradicted, 0);
}

TEST(AccuracyOf, WritesAReport) {
    const fs::path folder = fs::temp_directory_path() / "isomotion_api_accuracy_test";
    fs::remove_all(folder);
    AccuracySettings settings;
    settings.methods = {"affine"};
    settings.repeat = 1;
    EXPECT_EQ(told([&] { accuracy_of(measured_by(), wave(), settings).write(); }).code,
              Error::Code::setting);
    settings.output = folder / "report";
    accuracy_of(measured_by(), wave(), settings).write();
    for (const char* name : {"accuracy.csv", "accuracy.json", "wrong-01.png", "index.html"})
        EXPECT_TRUE(fs::exists(settings.output / name)) << name;

    // The report does not replace what the scene is read from.
    settings.output = folder;
    std::ofstream(folder / "accuracy.csv") << "x0,y0\n0,0\n";
    std::ofstream(folder / "scene.toml")
        << "[surface]\nformula = '1 - sum(blobs, exp(-(x-x0)^2 - y^2 - z^2))'\n"
           "bounds = { sphere = 2 }\n[arrays.blobs]\nfile = 'accuracy.csv'\n"
           "columns = { x0 = 'x0' }\n";
    const Told mistake =
        told([&] { accuracy_plan(Scene::load((folder / "scene.toml").string()), settings); });
    EXPECT_EQ(mistake.code, Error::Code::setting) << mistake.words;
    EXPECT_TRUE(mistake.words.starts_with("output ")) << mistake.words;
    fs::remove_all(folder);
}

TEST(AccuracyOf, TellsMistakesAndStops) {
    const Told unknown = told([] { accuracy_plan(wave(), {.methods = {"fast"}}); });
    EXPECT_EQ(unknown.code, Error::Code::setting);
    EXPECT_NE(unknown.words.find("affine"), std::string::npos) << unknown.words;
    EXPECT_EQ(told([] { accuracy_plan(wave(), {.repeat = 0}); }).code, Error::Code::setting);
    EXPECT_EQ(told([] { accuracy_plan(wave(), {.frames = {0}}); }).code, Error::Code::input);
    EXPECT_EQ(told([] {
                  accuracy_of(measured_by(), wave(), {.repeat = 1}, {.stop = [] { return true; }});
              }).code,
              Error::Code::stopped);
}

TEST(ChooseMethods, GivesASceneThatIsAccurate) {
    const Scene scene = wave().with("isolation.method", "marching").with("isolation.step", 0.5);
    const Choice choice = choose_methods(measured_by(), scene, {.most_wrong_ppm = 0});
    ASSERT_TRUE(choice.scene) << choice.summary;
    EXPECT_NE(choice.summary.find("instead of marching step=0.5"), std::string::npos)
        << choice.summary;
    AccuracySettings settings;
    settings.repeat = 1;
    settings.methods = {"marching"};
    // It stays so with other settings of the scene.
    const Scene chosen = choice.scene->with("output.size", "[40, 30]");
    const std::string drawn = Renderer(measured_by(), chosen).draw(2).fingerprint();
    EXPECT_NE(drawn,
              Renderer(measured_by(), scene.with("output.size", "[40, 30]")).draw(2).fingerprint());
    EXPECT_EQ(
        drawn,
        Renderer(measured_by(), *choice.scene, {.width = 40, .height = 30}).draw(2).fingerprint());
}

TEST(ChooseMethods, GivesNoneWhereNoneIs) {
    const Scene scene = wave().with("isolation.method", "marching").with("isolation.step", 2);
    const Choice choice =
        choose_methods(measured_by(), scene, {.most_wrong_ppm = 0, .keep_method = true});
    EXPECT_FALSE(choice.scene) << choice.summary;
}

TEST(EffectPrices, AreOfTheEffectsThatASceneCallsFor) {
    EXPECT_TRUE(effects_of(wave()).empty());
    EXPECT_TRUE(effect_prices(measured_by(), wave(), 1, 1).empty());
    const Scene shadowed = wave().with("look", "\"studio\"");
    const auto names = effects_of(shadowed);
    ASSERT_EQ(std::ranges::count(names, "shadows"), 1);
    const auto prices = effect_prices(measured_by(), shadowed, 1, 1);
    ASSERT_EQ(prices.size(), names.size());
    EXPECT_EQ(prices.front().effect, names.front());
    EXPECT_GT(prices.front().with, 0);
    EXPECT_GT(prices.front().without, 0);
    EXPECT_EQ(told([&] { effect_prices(measured_by(), shadowed, 1, 0); }).code, Error::Code::input);
}

} // namespace
} // namespace isomotion
