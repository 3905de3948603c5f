// Wrong pixels of the default method, or of another, on random formulas of each class, against
// certified truth.
//
//   random_formulas [--each N] [--size N] [--seed N] [--method NAME] [--beside NAME]
//                   [--only CLASS,...] [--list N]
//
// --beside draws each formula by another method in turn and prints the ratio of the times: of all
// together, and the worst of one formula.
// --list prints the scenes of the worst formulas of each class, as TOML, when they have a wrong
// pixel.
#include <algorithm>
#include <chrono>
#include <map>

#include <fmt/format.h>

#include "accuracy/compare.h"
#include "gpu/context.h"
#include "random/families.h"
#include "render/renderer.h"
#include "scene/reading/load.h"
#include "words.h"

namespace isomotion::bench {
namespace {

struct Arguments {
    int each = 250, size = 96, list = 0;
    std::uint64_t seed = 1;
    std::string method; // empty for the scene's own
    std::string beside; // empty for none
    std::vector<std::string> only;
};

struct Trial {
    std::string scene;
    accuracy::Errors errors;
    double evaluations = 0, ms = 0;
    double compiling_ms = 0; // with the first picture
    double beside_ms = 0;
};

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
    return 1e3 * std::chrono::duration<double>(Clock::now() - start).count();
}

std::unique_ptr<render::Renderer> renderer_of(gpu::Context& context, scene::Scene scene,
                                              const std::string& method) {
    if (!method.empty()) scene.surfaces[0].isolation.method = scene::parse_method(method).value();
    using shader::Channel;
    const std::vector channels{Channel::normal, Channel::position, Channel::verdict,
                               Channel::evaluations};
    return std::make_unique<render::Renderer>(context, scene,
                                              render::RenderOptions{.width = scene.output.width,
                                                                    .height = scene.output.height,
                                                                    .channels = channels});
}

Trial attempt(gpu::Context& context, const std::string& text, const Arguments& arguments) {
    const scene::Scene scene = scene::load_text(text, "random.toml", {}, scene::Reach::own_folder);
    const scene::SceneAt now = scene::at_frame(scene, 1);
    Trial trial;
    trial.scene = text;
    const auto begin = Clock::now();
    const auto renderer = renderer_of(context, scene, arguments.method);
    renderer->draw(now);
    trial.compiling_ms = ms_since(begin);
    std::unique_ptr<render::Renderer> beside;
    if (!arguments.beside.empty()) {
        beside = renderer_of(context, scene, arguments.beside);
        beside->draw(now);
    }
    render::Picture picture;
    trial.ms = trial.beside_ms = 1e30;
    // The least of three, in turn: other programs run meanwhile.
    for (int k = 0; k < (beside ? 3 : 1); ++k) {
        auto start = Clock::now();
        picture = renderer->draw(now);
        trial.ms = std::min(trial.ms, ms_since(start));
        if (!beside) continue;
        start = Clock::now();
        beside->draw(now);
        trial.beside_ms = std::min(trial.beside_ms, ms_since(start));
    }
    const roots::Truth truth =
        roots::certify(scene, now, scene.output.width, scene.output.height, {});
    trial.errors = accuracy::compare(now, picture.frame, truth);
    trial.evaluations = double(picture.evaluations());
    return trial;
}

void report(const Family& family, std::vector<Trial> trials, const Arguments& arguments) {
    const auto wrong = [](const Trial& t) {
        return t.errors.wrong() + t.errors.nan + t.errors.step_limit;
    };
    std::stable_sort(trials.begin(), trials.end(),
                     [&](const Trial& a, const Trial& b) { return wrong(a) > wrong(b); });
    accuracy::Errors all;
    double ms = 0, evaluations = 0, compiling = 0, beside = 0, worst_ratio = 0;
    int right = 0, few = 0;
    for (const Trial& trial : trials) {
        all.add(trial.errors);
        ms += trial.ms;
        evaluations += trial.evaluations;
        compiling += trial.compiling_ms;
        beside += trial.beside_ms;
        worst_ratio = std::max(worst_ratio, trial.ms / trial.beside_ms);
        right += wrong(trial) == 0;
        few += 1e6 * double(wrong(trial)) <= 100.0 * double(trial.errors.pixels);
    }
    const Trial& worst = trials.front();
    fmt::print("| {:<10} | {:>4} | {:>4} | {:>5.1f} | {:>4} | {:>7.0f} | {:>6} | {:>6} | {:>6} | "
               "{:>5} | {:>5} | {:>6} | {:>5.1f} | {:>6.2f} | {:>6.0f} |",
               family.name, trials.size(), right, 100.0 * right / double(trials.size()), few,
               1e6 * double(wrong(worst)) / double(worst.errors.pixels), all.missed, all.false_hits,
               all.wrong_roots, all.nan, all.step_limit, all.undecided,
               evaluations / double(std::max<std::int64_t>(1, all.rays)),
               ms / double(trials.size()), compiling / double(trials.size()));
    if (!arguments.beside.empty()) fmt::print(" {:.2f} | {:.2f} |", ms / beside, worst_ratio);
    fmt::print("\n");
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
               "limit | undecided | evaluations a ray | ms | compiling, ms |{}\n"
               "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|{}\n",
               arguments.beside.empty() ? "" : fmt::format(" times {} | worst |", arguments.beside),
               arguments.beside.empty() ? "" : "--:|--:|");
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
    isomotion::bench::Words words("wrong pixels on random formulas");
    words.number("--each", arguments.each, "formulas of each class", {1, 100000});
    words.number("--size", arguments.size, "pixels across", {8, 2048});
    words.seed("--seed", arguments.seed, "of the first formula of each class");
    words.text("--method", arguments.method, "instead of the scene's own");
    words.text("--beside", arguments.beside, "another method, to compare the times");
    words.texts("--only", arguments.only, "these classes");
    words.number("--list", arguments.list, "print so many scenes with wrong pixels a class");
    if (const auto code = words.read(argc, argv)) return *code;
    isomotion::bench::run(arguments);
}
