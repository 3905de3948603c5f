#include <algorithm>
#include <optional>
#include <stdexcept>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/commands.h"
#include "app/console.h"
#include "app/open_context.h"
#include "app/progress.h"
#include "app/render_arguments.h"

namespace isomotion::app {
namespace {

struct AccuracyArguments {
    std::string scene, surface, frames, size = "256x256", methods, steps, backend = "auto",
                                        stage = "fragment", output;
    std::vector<std::string> settings;
    std::optional<double> max_wrong, budget_ms;
    int repeat = 3;
    bool quiet = false, effects = false, certify = false;
    Reach reach = Reach::own_folder;
};

std::vector<std::string> parse_methods(const std::string& text) {
    const std::vector<std::string> known = methods();
    std::vector<std::string> names = listed(text);
    for (const std::string& name : names) {
        if (std::ranges::find(known, name) != known.end()) continue;
        throw std::invalid_argument(fmt::format(
            "--methods {}: there is no method '{}'; see isomotion list methods", text, name));
    }
    return names;
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

Scene load(const AccuracyArguments& arguments) {
    RenderArguments as_render;
    as_render.scene = arguments.scene;
    as_render.size = arguments.size;
    // What is measured is the surface; a look is priced with the other effects.
    if (!arguments.effects) as_render.settings.emplace_back("look=none");
    as_render.settings.insert(as_render.settings.end(), arguments.settings.begin(),
                              arguments.settings.end());
    as_render.certify = arguments.certify;
    const Scene scene = Scene::load(arguments.scene, scene_settings(as_render), arguments.reach);
    if (arguments.surface.empty()) return scene;
    expect_surface(scene, arguments.surface, "--surface");
    return scene.alone(arguments.surface);
}

std::vector<int> frames_of(const AccuracyArguments& arguments, const Scene& scene) {
    return arguments.frames.empty() ? std::vector{scene.poster()} : frame_numbers(arguments.frames);
}

// --effects: what each effect of the scene costs.
int price_effects(const AccuracyArguments& arguments) {
    const Scene scene = load(arguments);
    const int frame = frames_of(arguments, scene).front();
    expect_frames_of({&frame, 1}, scene.frames());
    if (effects_of(scene).empty()) {
        print_result("{} calls for no effect\n", scene.title());
        return exit_done;
    }
    Device device = open_device(arguments.backend);
    const auto prices = effect_prices(device, scene, frame, arguments.repeat, arguments.stage);
    print_result("{}: {}x{}, frame {}, medians of {} pairs; {}, {}\n", scene.title(), scene.width(),
                 scene.height(), frame, arguments.repeat, device.renderer(), device.version());
    print_result("{:<18}{:>10}{:>12}{:>12}\n", "effect", "with ms", "without ms", "price ms");
    for (const EffectPrice& price : prices) {
        print_result("{:<18}{:>10.2f}{:>12.2f}{:>12.2f}\n", price.effect, price.with, price.without,
                     price.price);
    }
    return exit_done;
}

Accuracy measured(const AccuracyArguments& arguments) {
    const Scene scene = load(arguments);
    const AccuracySettings settings{.frames = frames_of(arguments, scene),
                                    .methods = parse_methods(arguments.methods),
                                    .steps = parse_steps(arguments.steps),
                                    .repeat = arguments.repeat,
                                    .stage = arguments.stage,
                                    .remember = true,
                                    .output = arguments.output};
    expect_frames_of(settings.frames, scene.frames());
    with_options_named([&] { accuracy_plan(scene, settings); });
    Device device = open_device(arguments.backend);
    Progress progress("measuring", 1000, arguments.quiet);
    return accuracy_of(device, scene, settings,
                       {.progress = [&](const std::string& what, double part) {
                           progress.show(int(1000 * part), what);
                       }});
}

// The cheapest setting with few enough wrong pixels; the most accurate that is fast enough.
int judge(const AccuracyArguments& arguments, const Accuracy& accuracy) {
    int code = exit_done;
    const auto tell = [&](const char* what, const Measurement* found, const std::string& none) {
        if (found) {
            print_result("{}: {} ({:.2f} ms, {:.1f} ppm wrong)\n", what, found->name, found->ms,
                         found->wrong_ppm());
        } else {
            message("no setting {}\n", none);
            code = exit_check_failed;
        }
    };
    if (const auto most = arguments.max_wrong) {
        tell("cheapest", accuracy.cheapest(*most),
             fmt::format("has at most {:g} ppm of wrong pixels", *most));
    }
    if (const auto most = arguments.budget_ms) {
        tell("most accurate", accuracy.most_accurate(*most),
             fmt::format("takes at most {:g} ms a frame", *most));
    }
    return code;
}

int measure(const AccuracyArguments& arguments) {
    check_amount("--max-wrong", arguments.max_wrong, wrong_pixels);
    check_amount("--budget-ms", arguments.budget_ms, "milliseconds a frame, 0 or more: 16");
    if (arguments.effects) return price_effects(arguments);
    const Accuracy accuracy = measured(arguments);
    if (!arguments.quiet) print_result("{}", accuracy.summary());
    if (!arguments.output.empty()) {
        accuracy.write();
        if (!arguments.quiet) print_result("report: {}/index.html\n", arguments.output);
    }
    return judge(arguments, accuracy);
}

} // namespace

void add_accuracy(CLI::App& app, Action& chosen) {
    const auto arguments = std::make_shared<AccuracyArguments>();
    AccuracyArguments& a = *arguments;
    CLI::App* command = app.add_subcommand(
        "accuracy", "measure what each method and setting costs, and which pixels it gets wrong");
    command
        ->add_option(
            "scene", a.scene,
            "a scene file (.toml, .jsurf, .pov, .js), the name of an animation, or a formula")
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
        [arguments, &chosen] { chosen = [arguments] { return measure(*arguments); }; });
}

} // namespace isomotion::app
