// Wrong pixels of the default method, or of another, on random formulas of each class, against
// certified truth.
//
//   random_formulas [--each N] [--size N] [--seed N] [--method NAME] [--only CLASS,...] [--list N]
//
// --list prints the scenes of the worst formulas of each class, as TOML, when they have a wrong
// pixel.
#include <algorithm>
#include <chrono>
#include <map>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "accuracy/compare.h"
#include "gpu/context.h"
#include "random/families.h"
#include "render/renderer.h"
#include "scene/reading/load.h"

namespace isomotion::bench {
namespace {

struct Arguments {
    int each = 250, size = 96, list = 0;
    std::uint64_t seed = 1;
    std::string method; // empty for the scene's own
    std::vector<std::string> only;
};

struct Trial {
    std::string scene;
    accuracy::Errors errors;
    double evaluations = 0, ms = 0;
};

using Clock = std::chrono::steady_clock;

Trial attempt(gpu::Context& context, const std::string& text, const Arguments& arguments) {
    scene::Scene scene = scene::load_text(text, "random.toml", {}, scene::Reach::own_folder);
    if (!arguments.method.empty())
        scene.isolation.method = scene::parse_method(arguments.method).value();
    const scene::SceneAt now = scene::at(scene, scene.timeline.values(1));
    using synthesis::Channel;
    render::Renderer renderer(
        context, scene,
        {scene.output.width,
         scene.output.height,
         {Channel::normal, Channel::position, Channel::verdict, Channel::evaluations},
         {}});
    renderer.draw(now); // compiles
    const auto start = Clock::now();
    const render::Picture picture = renderer.draw(now);
    const double ms = 1e3 * std::chrono::duration<double>(Clock::now() - start).count();
    const truth::Truth truth =
        truth::certify(scene, now, scene.output.width, scene.output.height, {});
    return {text, accuracy::compare(scene, now, picture.frame, truth), double(picture.evaluations),
            ms};
}

void report(const Family& family, std::vector<Trial> trials, const Arguments& arguments) {
    const auto wrong = [](const Trial& t) {
        return t.errors.wrong() + t.errors.nan + t.errors.step_limit;
    };
    std::stable_sort(trials.begin(), trials.end(),
                     [&](const Trial& a, const Trial& b) { return wrong(a) > wrong(b); });
    accuracy::Errors all;
    double ms = 0, evaluations = 0;
    int right = 0, few = 0;
    for (const Trial& trial : trials) {
        all.add(trial.errors);
        ms += trial.ms;
        evaluations += trial.evaluations;
        right += wrong(trial) == 0;
        few += 1e6 * double(wrong(trial)) <= 100.0 * double(trial.errors.pixels);
    }
    const Trial& worst = trials.front();
    fmt::print("| {:<10} | {:>4} | {:>4} | {:>5.1f} | {:>4} | {:>7.0f} | {:>6} | {:>6} | {:>6} | "
               "{:>5} | {:>5} | {:>6} | {:>5.1f} | {:>6.2f} |\n",
               family.name, trials.size(), right, 100.0 * right / double(trials.size()), few,
               1e6 * double(wrong(worst)) / double(worst.errors.pixels), all.missed, all.false_hits,
               all.wrong_roots, all.nan, all.step_limit, all.undecided,
               evaluations / double(std::max<std::int64_t>(1, all.rays)),
               ms / double(trials.size()));
    for (int k = 0; k < arguments.list && k < int(trials.size()); ++k) {
        const Trial& t = trials[std::size_t(k)];
        if (wrong(t) == 0) break;
        fmt::print("# missed {}, false {}, behind {}, NaN {}, limit {}\n{}\n", t.errors.missed,
                   t.errors.false_hits, t.errors.wrong_roots, t.errors.nan, t.errors.step_limit,
                   t.scene);
    }
    std::fflush(stdout);
}

void run(const Arguments& arguments) {
    const auto context = gpu::Context::create();
    fmt::print("seed {}, {} formulas a class, {} x {}\n\n", arguments.seed, arguments.each,
               arguments.size, arguments.size);
    fmt::print("| class | n | right | % | <= 100 ppm | worst ppm | missed | false | behind | NaN | "
               "limit | undecided | evaluations a ray | ms |\n"
               "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
    for (const Family& family : families()) {
        if (!arguments.only.empty() && std::find(arguments.only.begin(), arguments.only.end(),
                                                 family.name) == arguments.only.end())
            continue;
        std::vector<Trial> trials;
        for (int k = 0; k < arguments.each; ++k) {
            const std::string text =
                random_scene(family, arguments.seed + std::uint64_t(k), arguments.size);
            trials.push_back(attempt(*context, text, arguments));
        }
        report(family, std::move(trials), arguments);
    }
}

} // namespace
} // namespace isomotion::bench

int main(int argc, char** argv) {
    isomotion::bench::Arguments arguments;
    CLI::App app("wrong pixels on random formulas");
    app.add_option("--each", arguments.each, "formulas of each class")
        ->check(CLI::Range(1, 100000));
    app.add_option("--size", arguments.size, "pixels across")->check(CLI::Range(8, 2048));
    app.add_option("--seed", arguments.seed, "of the first formula of each class");
    app.add_option("--method", arguments.method, "instead of the scene's own");
    app.add_option("--only", arguments.only, "these classes")->delimiter(',');
    app.add_option("--list", arguments.list, "print so many scenes with wrong pixels a class");
    CLI11_PARSE(app, argc, argv);
    isomotion::bench::run(arguments);
}
