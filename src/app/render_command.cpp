#include <chrono>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/commands.h"
#include "app/console.h"
#include "app/frame_progress.h"
#include "app/open_context.h"
#include "app/progress.h"
#include "app/render_arguments.h"
#include "app/stop_on_signal.h"

namespace isomotion::app {
namespace {

// The scene with the methods of --max-wrong; none if no setting is that accurate.
std::optional<Scene> with_methods_chosen(double max_wrong, const RenderArguments& arguments,
                                         const Scene& scene, const std::vector<int>& frames,
                                         Device& device) {
    Choice choice;
    {
        Progress progress("measuring", 1000, arguments.quiet);
        const Watcher watcher{.progress = [&](const std::string& what, double part) {
            progress.show(int(1000 * part), what);
        }};
        choice = choose_methods(device, scene,
                                {.most_wrong_ppm = max_wrong,
                                 .frames = frames,
                                 .keep_method = !arguments.method.empty(),
                                 .stage = arguments.stage,
                                 .remember = true},
                                watcher);
    }
    if (!arguments.quiet) print_result("{}", choice.summary);
    if (!choice.scene) {
        message("--max-wrong {:g}: no setting is that accurate; isomotion accuracy {} tells "
                "what there is\n",
                max_wrong, arguments.scene);
    }
    return choice.scene;
}

int stopped() {
    message("stopped; the frames written are whole, --resume renders the rest\n");
    return exit_interrupted;
}

int render(const RenderArguments& arguments) {
    const auto begin = std::chrono::steady_clock::now();
    const auto say = [&](const std::string& text) {
        if (!arguments.quiet) print_result("{}", text);
    };
    Scene scene = scene_of(arguments);
    const ExportSettings settings = export_settings(arguments, scene);
    Exporter exporter = exporter_of(scene, settings, warn);
    exporter.prepare();
    Device device = open_device(arguments.backend);
    if (const auto& max_wrong = arguments.max_wrong) {
        const auto chosen =
            with_methods_chosen(*max_wrong, arguments, scene, exporter.frames(), device);
        if (!chosen) return exit_check_failed;
        exporter = exporter_of(*chosen, settings);
    }
    say(exporter.plan(device) + "\n");

    const StopOnSignal stop;
    const auto asked = [&] { return stop.asked(); };
    std::optional<Progress> progress;
    progress.emplace("rendering", int(exporter.frames().size()), arguments.quiet);
    FrameProgress of_frame(*progress, scene.costs());
    const ExportWatcher watcher{
        .stop = asked,
        .progress =
            [&](const ExportProgress& now) {
                if (now.done > 0 || now.part > 0) stop.work_has_begun();
                of_frame.show(now);
            },
        .warn = [&](const std::string& text) { progress->tell("warning: " + text); }};
    const Exported done = exporter.write_frames(device, watcher);
    progress.reset(); // its line
    if (done.stopped) return stopped();
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
    say(done.summary(wall.count()));
    say(fmt::format("frames: {}\n", exporter.output()));
    if (!exporter.write_movies(asked)) return stopped();
    for (const std::string& movie : arguments.movies) say(fmt::format("movie: {}\n", movie));
    return exit_done;
}

} // namespace

void add_render(CLI::App& app, Action& chosen) {
    const auto arguments = std::make_shared<RenderArguments>();
    RenderArguments& a = *arguments;
    CLI::App* command = app.add_subcommand("render", "render frames of a scene into image files");
    add_sequence_options(*command, a);
    add_picture_options(*command, a);
    command->add_option("--part-of", a.part_of,
                        "all frames of the sequence that --frames are a part of, for its manifest: "
                        "verify misses those that nobody rendered (default: --frames)");
    command->callback([arguments, &chosen] {
        chosen = [arguments] { return render(with_movie_apart(*arguments)); };
    });
}

} // namespace isomotion::app
