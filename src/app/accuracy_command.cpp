#include <chrono>
#include <sstream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "accuracy/effect_price.h"
#include "accuracy/report.h"
#include "accuracy/truth_cache.h"
#include "animation/frame_range.h"
#include "app/commands.h"
#include "app/console.h"
#include "app/open_context.h"
#include "app/progress.h"
#include "app/render_arguments.h"
#include "scene/surfaces.h"
#include "sequence/inputs.h"

namespace isomotion::app {
namespace {

struct AccuracyArguments {
    std::string scene, surface, frames, size = "256x256", methods, steps, backend = "auto",
                                        stage = "fragment", output;
    std::vector<std::string> settings;
    std::optional<double> max_wrong, budget_ms;
    int repeat = 3;
    bool quiet = false, effects = false, certify = false;
    scene::Reach reach = scene::Reach::own_folder;
};

std::vector<std::string> listed(const std::string& text) {
    std::vector<std::string> items;
    std::istringstream stream(text);
    for (std::string item; std::getline(stream, item, ',');) items.push_back(item);
    return items;
}

std::vector<scene::Method> parse_methods(const std::string& text) {
    std::vector<scene::Method> methods;
    for (const std::string& item : listed(text)) {
        const auto method = scene::parse_method(item);
        if (!method) {
            throw std::invalid_argument(fmt::format(
                "--methods {}: there is no method '{}'; see isomotion list methods", text, item));
        }
        methods.push_back(*method);
    }
    return methods;
}

std::vector<double> parse_steps(const std::string& text) {
    std::vector<double> steps;
    for (const std::string& item : listed(text)) {
        std::size_t used = 0;
        double step = 0;
        try {
            step = std::stod(item, &used);
        } catch (const std::exception&) {
            used = 0;
        }
        if (used == 0 || used != item.size() || !(step > 0) || !(step < 1e30)) {
            throw std::invalid_argument(fmt::format(
                "--steps {}: '{}' is no step; write numbers above 0: 0.04,0.02", text, item));
        }
        steps.push_back(step);
    }
    return steps;
}

scene::Scene load(const AccuracyArguments& arguments) {
    RenderArguments as_render;
    as_render.scene = arguments.scene;
    as_render.size = arguments.size;
    // What is measured is the surface; a look is priced with the other effects.
    if (!arguments.effects) as_render.settings.emplace_back("look=none");
    as_render.settings.insert(as_render.settings.end(), arguments.settings.begin(),
                              arguments.settings.end());
    as_render.certify = arguments.certify;
    scene::Scene scene = scene::load(arguments.scene, overrides(as_render), arguments.reach);
    if (arguments.surface.empty()) return scene;
    return scene::alone({scene, scene::surface_named(scene, arguments.surface)});
}

// --effects: what each effect of the scene costs.
int price_effects(const AccuracyArguments& arguments) {
    const scene::Scene scene = load(arguments);
    const int frame = arguments.frames.empty()
                          ? scene.output.poster
                          : animation::parse_frame_range(arguments.frames).front();
    expect_frames_of({&frame, 1}, scene);
    if (shader::effects(scene).empty()) {
        print_result("{} calls for no effect\n", scene.title);
        return exit_done;
    }
    const auto context = open_context(arguments.backend);
    const auto prices =
        accuracy::effect_prices(*context, scene, frame, scene.output.width, scene.output.height,
                                arguments.repeat, render::parse_stage(arguments.stage));
    print_result("{}: {}x{}, frame {}, medians of {} pairs; {}, {}\n", scene.title,
                 scene.output.width, scene.output.height, frame, arguments.repeat,
                 context->info().renderer, context->info().version);
    print_result("{:<18}{:>10}{:>12}{:>12}\n", "effect", "with ms", "without ms", "price ms");
    for (const accuracy::EffectPrice& price : prices) {
        print_result("{:<18}{:>10.2f}{:>12.2f}{:>12.2f}\n", shader::name(price.effect), price.with,
                     price.without, price.price);
    }
    return exit_done;
}

accuracy::Report measured(const AccuracyArguments& arguments) {
    const scene::Scene scene = load(arguments);
    accuracy::MeasureOptions measuring;
    measuring.frames = arguments.frames.empty() ? std::vector{scene.output.poster}
                                                : animation::parse_frame_range(arguments.frames);
    expect_frames_of(measuring.frames, scene);
    for (const int frame : measuring.frames) scene::at_frame(scene, frame);
    measuring.width = scene.output.width;
    measuring.height = scene.output.height;
    measuring.repeat = arguments.repeat;
    measuring.stage = render::parse_stage(arguments.stage);
    measuring.cache = accuracy::truth_cache_folder();
    const auto settings =
        accuracy::sweep(scene, parse_methods(arguments.methods), parse_steps(arguments.steps));
    if (!arguments.output.empty()) {
        const sequence::Inputs inputs(scene);
        for (const std::string& name : accuracy::files_written(settings.size()))
            inputs.expect_apart("-o", std::filesystem::path(arguments.output) / name);
    }
    const auto context = open_context(arguments.backend);
    const shader::Stage stage = render::choose_stage(measuring.stage, context->info());
    Progress progress("measuring", 1000, arguments.quiet);
    measuring.progress = [&](const std::string& what, double part) {
        progress.show(int(1000 * part), what);
    };
    accuracy::Report report{scene.title,
                            fmt::format("{}, {}, {} shaders", context->info().renderer,
                                        context->info().version, render::name(stage)),
                            scene.surfaces.front().isolation,
                            measuring.frames,
                            measuring.width,
                            measuring.height,
                            {}};
    report.measurements = accuracy::measure(*context, scene, settings, measuring);
    return report;
}

// The cheapest setting with few enough wrong pixels; the most accurate that is fast enough.
int judge(const AccuracyArguments& arguments, const accuracy::Report& report) {
    const auto tell = [&](const char* what, std::size_t k) {
        const accuracy::Measurement& m = report.measurements[k];
        print_result("{}: {} ({:.2f} ms, {:.1f} ppm wrong)\n", what,
                     accuracy::name(m.setting, report.isolation), m.ms, m.errors.wrong_ppm());
    };
    int code = exit_done;
    if (arguments.max_wrong) {
        if (const auto k = accuracy::cheapest(report.measurements, *arguments.max_wrong)) {
            tell("cheapest", *k);
        } else {
            message("no setting has at most {:g} ppm of wrong pixels\n", *arguments.max_wrong);
            code = exit_check_failed;
        }
    }
    if (arguments.budget_ms) {
        if (const auto k = accuracy::most_accurate(report.measurements, *arguments.budget_ms)) {
            tell("most accurate", *k);
        } else {
            message("no setting takes at most {:g} ms a frame\n", *arguments.budget_ms);
            code = exit_check_failed;
        }
    }
    return code;
}

int accuracy_of(const AccuracyArguments& arguments) {
    check_amount("--max-wrong", arguments.max_wrong, wrong_pixels);
    check_amount("--budget-ms", arguments.budget_ms, "milliseconds a frame, 0 or more: 16");
    if (arguments.effects) return price_effects(arguments);
    const accuracy::Report report = measured(arguments);
    if (!arguments.quiet) {
        print_result("{}: {}x{}, {} frame{} from {}; {}\n{}", report.title, report.width,
                     report.height, report.frames.size(), report.frames.size() == 1 ? "" : "s",
                     report.frames.front(), report.machine, accuracy::table(report));
    }
    if (!arguments.output.empty()) {
        accuracy::write(report, arguments.output);
        if (!arguments.quiet) print_result("report: {}/index.html\n", arguments.output);
    }
    return judge(arguments, report);
}

} // namespace

void add_accuracy(CLI::App& app, Action& chosen) {
    const auto arguments = std::make_shared<AccuracyArguments>();
    AccuracyArguments& a = *arguments;
    CLI::App* command = app.add_subcommand(
        "accuracy", "measure what each method and setting costs, and which pixels it gets wrong");
    command
        ->add_option("scene", a.scene,
                     "a scene file (.toml, .jsurf, .pov), the name of an animation, or a formula")
        ->required();
    command->add_option("--surface", a.surface,
                        "measure this one of the scene's [[surfaces]] alone, by its name");
    command->add_option("--frames,--frame", a.frames,
                        "frames to measure: 1-10, 1-10x2, 1,3,5-9 (default: the scene's poster)");
    command->add_option("--size", a.size, "size of the picture, WIDTHxHEIGHT (default: 256x256)");
    command->add_option("--methods", a.methods, "methods to measure: a,b (default: all)");
    command->add_option("--steps", a.steps,
                        "steps to measure: 0.04,0.02 (default: some about the scene's)");
    command->add_option("--max-wrong", a.max_wrong,
                        "print the cheapest setting that gets at most so many pixels in a million "
                        "wrong; exit code 1 if there is none");
    command->add_option("--budget-ms", a.budget_ms,
                        "print the most accurate setting that takes at most so long a frame; exit "
                        "code 1 if there is none");
    command->add_option("-o,--output", a.output, "write a report into this folder");
    command->add_option("--repeat", a.repeat, "take the median time of so many drawings")
        ->check(CLI::Range(1, 1000));
    command->add_flag("--effects", a.effects,
                      "measure instead what each effect of the scene costs, on one frame");
    command->add_flag(
        "--certify", a.certify,
        "prove pixels as render does; print how many, and which proofs truth refutes");
    command->add_option("--set", a.settings, "name=value, as for render")->allow_extra_args(false);
    add_allow_outside(*command, a.reach);
    command->add_option("--backend", a.backend, "OpenGL back end: auto, egl, osmesa or glfw");
    command->add_option("--stage", a.stage, "fragment, compute or auto, as for render");
    command->add_flag("--quiet", a.quiet, "print neither table nor progress");
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return accuracy_of(*arguments); }; });
}

} // namespace isomotion::app
