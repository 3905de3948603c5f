#include <algorithm>
#include <chrono>
#include <memory>
#include <numeric>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "animation/frame_range.h"
#include "app/choose_setting.h"
#include "app/commands.h"
#include "app/console.h"
#include "app/frame_progress.h"
#include "app/open_context.h"
#include "app/progress.h"
#include "app/render_arguments.h"
#include "app/stop_on_signal.h"
#include "image/frame.h"
#include "probe/found_bounds.h"
#include "probe/sight.h"
#include "scene/method.h"
#include "scene/surfaces.h"
#include "sequence/exporter.h"
#include "sequence/movies/movie.h"

namespace isomotion::app {
namespace {

using Seconds = std::chrono::duration<double>;

std::string frames_text(std::size_t count) {
    return fmt::format("{} frame{}", count, count == 1 ? "" : "s");
}

std::string beginning(const sequence::Exporter& exporter, const gpu::ContextInfo& driver) {
    const scene::Scene& scene = exporter.scene();
    const auto stage = render::choose_stage(exporter.options().stage, driver);
    return fmt::format("{}: {}, {}x{}, {}, step {:g}; {} ({}), {} shaders\n", scene.title,
                       frames_text(exporter.options().frames.size()), scene.output.width,
                       scene.output.height, scene::name(scene.surfaces.front().isolation.method),
                       scene.surfaces.front().isolation.step, driver.renderer, driver.backend,
                       render::name(stage));
}

// `wall`: how long all of it took.
std::string summary(const sequence::ExportTotals& totals, Seconds wall) {
    std::string text;
    if (totals.drawn > 0) {
        const auto& verdicts = totals.verdicts;
        const auto rays = std::accumulate(verdicts.begin(), verdicts.end(), std::int64_t(0));
        const std::int64_t evaluations = render::evaluations(totals.rays);
        text += fmt::format(
            "drawn {} in {:.2f} s ({:.1f} ms each, {:.1f} evaluations a ray); all "
            "of it took {:.2f} s, {:.2f} times the drawing\n",
            totals.drawn, totals.drawing.count(), 1e3 * totals.drawing.count() / totals.drawn,
            double(evaluations) / double(rays), wall.count(), wall / totals.drawing);
        text += "rays:";
        for (std::size_t v = 0; v < verdicts.size(); ++v) {
            text +=
                fmt::format("{} {} {}", v == 0 ? "" : ",", verdicts[v], render::verdict_names[v]);
        }
        text += "\n";
        if (totals.rays[std::size_t(render::RayKind::eye)].evaluations < evaluations)
            text += "evaluations: " + render::words(totals.rays, rays) + "\n";
        if (totals.without_colour > 0) {
            text += fmt::format("{} pixels whose colour is infinite or no number\n",
                                totals.without_colour);
        }
        const bool certified =
            std::ranges::any_of(totals.proofs, [](auto count) { return count > 0; });
        if (certified) text += render::summary(totals.proofs) + "\n";
    }
    if (totals.reused > 0) {
        text += frames_text(std::size_t(totals.reused)) + " equal to the one before\n";
    }
    const audit::Findings& audit = totals.audit;
    if (audit.rays + audit.undecided > 0) text += audit::words(audit, totals.drawn) + "\n";
    std::string reasons;
    for (const auto& [status, which] : totals.found) {
        if (status == sequence::FrameStatus::whole) {
            text += frames_text(which.size()) + " kept from an earlier run\n";
        } else {
            reasons += fmt::format("{}{} {} ({})", reasons.empty() ? "" : "; ", which.size(),
                                   sequence::name(status), animation::frame_range(which));
        }
    }
    if (!reasons.empty()) text += fmt::format("not kept: {}\n", reasons);
    return text;
}

// Warns of frames for which no bounds were looked for; empty if there are none.
std::string bounds_beyond(const sequence::Exporter& exporter) {
    const scene::Scene& scene = exporter.scene();
    const int last = std::ranges::max(exporter.options().frames);
    if (!probe::are_bounds_found(scene) || last <= scene.timeline.frames) return "";
    return fmt::format("frames beyond {0} may be cut: bounds were found for frames 1 to {0}; --set "
                       "time.frames={1} finds them for all",
                       scene.timeline.frames, last);
}

// What is known of each surface at the first frame asked for, with what tells it from others.
std::vector<std::pair<std::string, probe::Sight>> sights_of(const sequence::Exporter& exporter) {
    const scene::Scene& scene = exporter.scene();
    const int frame = exporter.options().frames.front();
    const scene::SceneAt now = scene::at_frame(scene, frame);
    std::vector<std::pair<std::string, probe::Sight>> sights;
    for (std::size_t k = 0; k < scene.surfaces.size(); ++k) {
        const scene::OneSurface one(scene, k);
        sights.emplace_back(one.is_alone() ? "" : fmt::format("surface '{}': ", one.surface.label),
                            probe::sight(one, {now, k}));
    }
    return sights;
}

bool has_hits(const sequence::ExportTotals& totals) {
    return totals.verdicts[std::size_t(render::Verdict::hit)] +
               totals.verdicts[std::size_t(render::Verdict::zero_gradient)] >
           0;
}

// Rays that end undecided may have missed something, unless F is proved to have no zero.
std::string why_no_hit(const sequence::ExportTotals& totals, const std::string& whose,
                       const probe::Sight& sight) {
    const std::int64_t undecided = totals.verdicts[std::size_t(render::Verdict::nan)] +
                                   totals.verdicts[std::size_t(render::Verdict::step_limit)];
    if (undecided > 0 && !sight.values)
        return fmt::format("no ray is known to hit anything: {} ended undecided", undecided);
    return fmt::format("no ray hits anything: {}{}", whose, probe::why_nothing_is_seen(sight));
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
    sequence::Exporter exporter = exporter_of(arguments);
    const sequence::ExportOptions& options = exporter.options();
    if (const std::string beyond = bounds_beyond(exporter); !beyond.empty()) warn(beyond);
    exporter.make_folders();
    if (!options.movies.empty()) sequence::expect_ffmpeg();
    const auto context = open_context(arguments.backend);
    if (arguments.max_wrong) {
        const auto settings = choose_settings(*context, exporter.scene(), options.frames,
                                              {.max_wrong = *arguments.max_wrong,
                                               .keeps_method = !arguments.method.empty(),
                                               .stage = options.stage,
                                               .quiet = arguments.quiet});
        if (!settings) {
            message("--max-wrong {:g}: no setting is that accurate; isomotion accuracy {} tells "
                    "what there is\n",
                    *arguments.max_wrong, arguments.scene);
            return exit_check_failed;
        }
        exporter.choose(*settings);
    }
    say(beginning(exporter, context->info()));
    const auto sights = sights_of(exporter);
    for (const auto& [whose, sight] : sights) {
        for (const std::string& slip : probe::slips(sight)) warn(whose + slip);
    }

    const StopOnSignal stop;
    std::optional<Progress> progress;
    progress.emplace("rendering", int(options.frames.size()), arguments.quiet);
    FrameProgress of_frame(*progress, exporter.scene());
    const sequence::ExportWatcher watcher{.stop = [&] { return stop.asked(); },
                                          .warn = warn,
                                          .progress =
                                              [&](const sequence::ExportProgress& now) {
                                                  if (now.done > 0 || now.part > 0)
                                                      stop.work_has_begun();
                                                  of_frame.show(now);
                                              }};
    const sequence::ExportTotals totals = exporter.export_frames(*context, watcher);
    progress.reset(); // its line
    if (totals.stopped) return stopped();
    // Frames that an earlier run wrote may show something.
    const bool is_all = totals.drawn + totals.reused == std::int64_t(options.frames.size());
    if (is_all && !has_hits(totals))
        warn(why_no_hit(totals, sights.front().first, sights.front().second));
    say(summary(totals, std::chrono::steady_clock::now() - begin));
    say(fmt::format("frames: {}\n", options.output));
    if (options.movies.empty()) return exit_done;
    try {
        if (!exporter.write_movies(watcher)) return stopped();
    } catch (
        const image::ImageError& error) { // a frame's file, which the scene is not to blame for
        throw Error(Error::Code::file, error.what());
    }
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
