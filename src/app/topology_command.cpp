#include <array>
#include <exception>
#include <filesystem>
#include <new>
#include <optional>
#include <stdexcept>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "animation/frame_range.h"
#include "api/drawing/parts.h"
#include "api/scene/reach.h"
#include "app/commands.h"
#include "app/console.h"
#include "app/open_context.h"
#include "app/progress.h"
#include "app/stop_on_signal.h"
#include "app/topology_subject.h"
#include "base/base64.h"
#include "base/file.h"
#include "gpu/context.h"
#include "gpu/error.h"
#include "image/encode.h"
#include "probe/found_bounds.h"
#include "render/renderer.h"
#include "scene/reading/load.h"
#include "scene/surfaces.h"
#include "sequence/inputs.h"
#include "topology/timeline/betti_csv.h"
#include "topology/timeline/expectation.h"
#include "topology/timeline/plot.h"
#include "topology/timeline/representative_frames.h"
#include "topology/timeline/summary.h"
#include "topology/timeline/timeline_file.h"
#include "topology/timeline/words.h"

namespace isomotion::app {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t most_thumbnails = 8;
constexpr int thumbnail_size = 192; // shown at half of it: sharp on screens of fine pixels

struct TopologyArguments {
    std::string scene, surface, frames, certify = "full", output, csv, plot, check, dt = "1e-9",
                                        backend = "auto";
    std::vector<std::string> settings;
    std::vector<std::string> contact; // none, or two surfaces
    std::vector<std::string> solids;
    std::optional<int> grid;
    bool quiet = false;
    Reach reach = Reach::own_folder;
};

// The scene that a picture of the subject shows: for two surfaces it is the whole scene.
scene::Scene load_seen(const TopologyArguments& arguments,
                       const std::vector<scene::Override>& settings) {
    scene::Scene scene = scene::load(arguments.scene, settings, api::reach_of(arguments.reach));
    if (arguments.surface.empty()) return scene;
    return scene::alone({scene, scene::surface_named(scene, arguments.surface)});
}

void check_extension(const char* option, const std::string& file, const char* extension) {
    if (file.empty() || fs::path(file).extension() == extension) return;
    throw std::invalid_argument(fmt::format("{} {}: the name must end in {}: {}", option, file,
                                            extension,
                                            fs::path(file).replace_extension(extension).string()));
}

topology::Certify parse_certify(const std::string& text) {
    if (text == "off") return topology::Certify::off;
    if (text == "fast") return topology::Certify::fast;
    if (text == "full") return topology::Certify::full;
    throw std::invalid_argument(fmt::format("--certify {}: write off, fast or full", text));
}

void check_grid(const TopologyArguments& arguments) {
    const topology::Certify certify = parse_certify(arguments.certify);
    if (!arguments.grid) return;
    if (*arguments.grid < 8 || *arguments.grid > 1024) {
        throw std::invalid_argument(
            fmt::format("--grid {}: write vertices along a side, 8 to 1024", *arguments.grid));
    }
    if (certify == topology::Certify::full) {
        throw std::invalid_argument(
            "--grid: proofs use no grid; write it with --certify off or fast");
    }
}

// The settings. If bounds have to be found, the scene gets as many frames as are searched, since
// bounds are found for the scene's frames.
std::vector<scene::Override> settings_of(const TopologyArguments& arguments,
                                         const scene::Scene& scene) {
    std::vector<scene::Override> settings = arguments.settings;
    if (arguments.frames.empty() || !probe::are_bounds_found(scene)) return settings;
    const int last = std::ranges::max(animation::parse_frame_range(arguments.frames));
    if (last <= scene.timeline.frames) return settings;
    std::erase_if(settings, [](const scene::Override& setting) {
        return setting.starts_with("time.seconds=") || setting.starts_with("time.frames=");
    });
    settings.push_back(fmt::format("time.frames={}", last));
    return settings;
}

// The first and the last frame of what is searched; all time in between is searched, too.
std::pair<int, int> span_of(const std::string& text, const scene::Scene& scene) {
    if (text.empty()) {
        if (scene.timeline.frames > 1) return {1, scene.timeline.frames};
        throw std::invalid_argument(
            "the scene has one frame, in which nothing happens; a timeline needs two: set frames "
            "in its [time], or --frames 1-100");
    }
    const auto frames = animation::parse_frame_range(text);
    const bool is_span =
        frames.size() > 1 && frames.back() - frames.front() + 1 == std::ptrdiff_t(frames.size());
    if (!is_span || !std::ranges::is_sorted(frames)) {
        throw std::invalid_argument(fmt::format(
            "--frames {}: topology searches a span with all time in it; write 1-10", text));
    }
    return {frames.front(), frames.back()};
}

void write_text(const std::string& file, const std::string& text) {
    if (const fs::path folder = fs::path(file).parent_path(); !folder.empty()) {
        std::error_code error;
        fs::create_directories(folder, error);
        if (error && !fs::is_directory(folder)) {
            throw base::FileError(folder, "the folder cannot be created", error.value());
        }
    }
    base::write_whole(file, std::as_bytes(std::span(text)));
}

struct Pictures {
    std::vector<topology::Thumbnail> drawn;
    std::size_t undrawn = 0; // since the command was interrupted
};

// Pictures of the frames that tell most. If one cannot be drawn, only those before it.
Pictures pictures_of(const TopologyArguments& arguments, const topology::TimelineRecord& record,
                     const StopOnSignal& stop) {
    std::vector<scene::Override> settings = arguments.settings;
    settings.push_back(fmt::format("output.size=[{0},{0}]", thumbnail_size));
    Pictures pictures;
    try {
        scene::Scene scene = load_seen(arguments, settings);
        scene.sections.clear(); // the topology is that of the whole surface
        const Device device = open_device(arguments.backend);
        render::Renderer renderer(*device.parts().context, scene,
                                  {thumbnail_size, thumbnail_size, {}, {}, {}});
        const auto frames = topology::representative_frames(record, most_thumbnails);
        Progress progress("drawing", int(frames.size()), arguments.quiet);
        for (std::size_t k = 0; k < frames.size(); ++k) {
            progress.show(int(k));
            if (stop.asked()) {
                pictures.undrawn = frames.size() - k;
                break;
            }
            const double whole = std::floor(frames[k]);
            const render::Picture picture =
                renderer.draw(scene::at_frame(scene, std::int64_t(whole), frames[k] - whole));
            const auto png = image::encode(picture.frame, image::Format::png8);
            pictures.drawn.push_back({frames[k], "data:image/png;base64," + base::base64(png)});
        }
    } catch (const gpu::Unavailable&) {
        message("warning: no OpenGL here: {} has no pictures of the surface\n", arguments.plot);
    } catch (const std::exception& error) { // a shader too long, a value out of range in between
        warn(fmt::format("{} lacks pictures of the surface: {}", arguments.plot, error.what()));
    }
    return pictures;
}

// Writes each file, whatever becomes of the others. What the first that fails throws is thrown at
// the end. Returns how many pictures are missing, since the command was interrupted.
std::size_t write_files(const TopologyArguments& arguments, const topology::TimelineRecord& record,
                        const StopOnSignal& stop) {
    std::exception_ptr first;
    std::size_t undrawn = 0;
    const auto write = [&](const std::string& file, const auto& text) {
        if (file.empty()) return;
        try {
            write_text(file, text());
        } catch (...) {
            if (!first) first = std::current_exception();
        }
    };
    write(arguments.output, [&] { return topology::to_json(record); });
    write(arguments.csv, [&] { return topology::betti_csv(record); });
    write(arguments.plot, [&] {
        const Pictures pictures = pictures_of(arguments, record, stop);
        undrawn = pictures.undrawn;
        return topology::plot_svg(record, pictures.drawn);
    });
    if (first) std::rethrow_exception(first);
    return undrawn;
}

topology::TimelineRecord analysed(const TopologyArguments& arguments, const Subject& subject,
                                  const std::array<topology::Side, 2>& solids,
                                  std::pair<int, int> frames, const StopOnSignal& stop) {
    topology::AnalyseOptions how;
    how.solids = {solids[0], solids[1]};
    how.certify = parse_certify(arguments.certify);
    how.first = frames.first;
    how.last = frames.second;
    how.grid = arguments.grid;
    Progress progress("topology", 1000, arguments.quiet);
    how.progress = [&](const std::string& what, double part) {
        stop.work_has_begun();
        progress.show(int(1000 * part), what);
    };
    how.stop = [&] { return stop.asked(); };
    // A mistake in the last frame is told before minutes of searching.
    const animation::Timeline& timeline = subject.first.scene.timeline;
    const formula::Interval range{timeline.time(how.first), timeline.time(how.last)};
    const topology::TimelineHeader header = header_of(subject, range, solids);
    // Where F has no bounds, all that the search tells is that it could not prove anything.
    for (const std::string& why : topology::why_unbounded(subject, frames.first)) warn(why);
    try {
        return {header, analyse(subject, how)};
    } catch (const std::bad_alloc&) {
        throw std::runtime_error("out of memory: the search for events takes more than there is; "
                                 "search fewer --frames at a time, or with --certify fast");
    }
}

int judged(const TopologyArguments& arguments, const topology::Expectation& expectation,
           const topology::TimelineRecord& record) {
    const topology::Check check =
        topology::check(expectation, record, topology::parse_dt(arguments.dt, record.header.fps));
    const std::string text = topology::text(check, arguments.check);
    switch (check.outcome()) {
    case topology::Outcome::passes:
        if (!arguments.quiet) print_result("{}", text);
        return exit_done;
    case topology::Outcome::differs:
        message("{}", text);
        return exit_check_failed;
    case topology::Outcome::incomplete:
        break;
    }
    message("{}", text);
    return exit_incomplete;
}

// Tells, where there is no check, whether all was proved that was asked for.
int whole_or_open(const TopologyArguments& arguments, const topology::TimelineRecord& record) {
    const bool was_to_be_proved = parse_certify(arguments.certify) == topology::Certify::full;
    const bool is_complete = topology::gaps(record.timeline, record.header.fps).empty();
    return was_to_be_proved && !is_complete ? exit_open : exit_done;
}

// Refuses options that ask for one surface, or for one pair of surfaces.
void check_options_of_all(const TopologyArguments& arguments) {
    const std::pair<const char*, bool> of_one[] = {{"-o", !arguments.output.empty()},
                                                   {"--csv", !arguments.csv.empty()},
                                                   {"--plot", !arguments.plot.empty()},
                                                   {"--check", !arguments.check.empty()}};
    for (const auto& [option, is_given] : of_one) {
        if (!is_given) continue;
        throw std::invalid_argument(fmt::format(
            "{}: the scene has several surfaces; name one by --surface NAME, or two of them by "
            "--contact NAME NAME",
            option));
    }
}

void check_proves_contact(const TopologyArguments& arguments) {
    if (parse_certify(arguments.certify) == topology::Certify::full) return;
    throw std::invalid_argument(fmt::format(
        "--certify {}: contact of surfaces is proved or not found; leave it out, or name one "
        "surface by --surface NAME",
        arguments.certify));
}

void tell_of_sections(const TopologyArguments& arguments, const scene::Scene& scene) {
    if (scene.sections.empty() || arguments.quiet) return;
    message("sections cut what is seen; the topology is that of the whole surface\n");
}

// When and where each two surfaces of the scene touch.
int contacts_of(const TopologyArguments& arguments, const scene::Scene& scene) {
    tell_of_sections(arguments, scene);
    check_options_of_all(arguments);
    check_proves_contact(arguments);
    const auto frames = span_of(arguments.frames, scene);
    const std::size_t count = scene.surfaces.size();
    // A mistake in the last pair's last frame is told before minutes of searching the first.
    const formula::Interval range{scene.timeline.time(frames.first),
                                  scene.timeline.time(frames.second)};
    for (std::size_t first = 0; first < count; ++first) {
        for (std::size_t second = first + 1; second < count; ++second)
            header_of(topology::subject_of(scene, first, second), range, {});
    }
    const std::vector<SolidChoice> choices = parse_solids(arguments.solids, scene);
    const StopOnSignal stop;
    bool is_complete = true;
    for (std::size_t first = 0; first < count && !stop.asked(); ++first) {
        for (std::size_t second = first + 1; second < count && !stop.asked(); ++second) {
            const Subject subject = topology::subject_of(scene, first, second);
            const auto solids = solids_of(subject, choices);
            const topology::TimelineRecord record =
                analysed(arguments, subject, solids, frames, stop);
            is_complete = is_complete && topology::gaps(record.timeline, record.header.fps).empty();
            if (!arguments.quiet)
                print_result("{}{}", solid_text(subject, solids), contact_text(subject, record));
        }
    }
    if (stop.asked()) {
        message("interrupted; what was told is what was known\n");
        return exit_interrupted;
    }
    return is_complete ? exit_done : exit_open;
}

int topology_of(TopologyArguments arguments) {
    // What can be known to fail is told before minutes of searching.
    check_extension("-o", arguments.output, ".json");
    check_extension("--csv", arguments.csv, ".csv");
    check_extension("--plot", arguments.plot, ".svg");
    check_grid(arguments);
    topology::parse_dt(arguments.dt, {1, 1});
    gpu::parse_backend(arguments.backend);
    if (!arguments.contact.empty()) check_proves_contact(arguments);
    scene::Scene loaded =
        scene::load(arguments.scene, arguments.settings, api::reach_of(arguments.reach));
    if (const auto settings = settings_of(arguments, loaded); settings != arguments.settings) {
        arguments.settings = settings;
        loaded = scene::load(arguments.scene, settings, api::reach_of(arguments.reach));
    }
    sequence::Inputs inputs(loaded);
    inputs.add(arguments.check);
    inputs.expect_apart("-o", arguments.output);
    inputs.expect_apart("--csv", arguments.csv);
    inputs.expect_apart("--plot", arguments.plot);
    const bool is_of_all = arguments.surface.empty() && arguments.contact.empty();
    if (is_of_all && loaded.surfaces.size() > 1) return contacts_of(arguments, loaded);
    const Subject subject = subject_of(loaded, arguments.surface, arguments.contact);
    tell_of_sections(arguments, loaded);
    const auto frames = span_of(arguments.frames, loaded);
    std::optional<topology::Expectation> expectation;
    if (!arguments.check.empty()) {
        expectation = topology::read_expectation(arguments.check, loaded.timeline.fps);
    }
    const std::vector<SolidChoice> choices = parse_solids(arguments.solids, loaded);
    expect_searched(subject, choices);
    const auto solids = solids_of(subject, choices);
    const StopOnSignal stop;
    const topology::TimelineRecord record = analysed(arguments, subject, solids, frames, stop);
    const bool is_whole = !stop.asked();
    if (!arguments.quiet)
        print_result("{}{}", solid_text(subject, solids), topology::summary(record));
    if (!arguments.quiet && subject.second) print_result("{}", contact_text(subject, record));
    // The judgement is told first, so that no file that fails to be written keeps it back.
    const int code =
        expectation ? judged(arguments, *expectation, record) : whole_or_open(arguments, record);
    const std::size_t undrawn = write_files(arguments, record, stop);
    if (is_whole && undrawn == 0) return code;
    if (is_whole) {
        message("interrupted; {} lacks {} picture{} of the surface, all else is written\n",
                arguments.plot, undrawn, undrawn == 1 ? "" : "s");
    } else {
        message("interrupted; what was written is what was known\n");
    }
    return exit_interrupted;
}

} // namespace

void add_topology(CLI::App& app, Action& chosen) {
    const auto arguments = std::make_shared<TopologyArguments>();
    TopologyArguments& a = *arguments;
    CLI::App* command = app.add_subcommand(
        "topology",
        "find when parts of the surface merge, split, open and close; prove it, and check it");
    command
        ->add_option("scene", a.scene,
                     "a scene file (.toml, .jsurf, .pov), the name of an animation, or a formula")
        ->required();
    command->add_option("--surface", a.surface,
                        "search this one of the scene's [[surfaces]] alone, by its name");
    command
        ->add_option("--contact", a.contact,
                     "search what these two of the scene's [[surfaces]] have in common: it is born "
                     "where they touch (default with several surfaces: the contact of each two)")
        ->expected(2)
        ->excludes("--surface");
    command
        ->add_option(
            "--solid", a.solids,
            "negative or positive: the solid is where F < 0, or where F > 0; NAME=negative "
            "for one of several surfaces (default: the side that the bounds don't touch at "
            "the first frame; negative if they touch both)")
        ->allow_extra_args(false);
    command->add_option("--frames,--frame", a.frames,
                        "1-10: from frame 1 to frame 10 with all time between (default: all)");
    command->add_option("--certify", a.certify,
                        "off: sample; fast: prove events found from seeds, others may be missing; "
                        "full: prove all that can be, exit code 4 if something stays open "
                        "(default)");
    command->add_option("--grid", a.grid,
                        "vertices along each side of the grid that off and fast take signs on "
                        "(default: 128 for fast; 64 for off, fewer where that takes over about "
                        "ten seconds)");
    command->add_option("-o,--output", a.output, "file for the timeline: NAME.timeline.json");
    command->add_option("--csv", a.csv, "file for Betti numbers, frame by frame: NAME.betti.csv");
    command->add_option("--plot", a.plot, "file for a picture of the timeline: NAME.svg");
    command->add_option("--check", a.check,
                        "compare the timeline with this file: one written with -o, or claims in "
                        "JSON or TOML; all that it says must be so, and in the frames that are "
                        "searched; exit code 1 if it differs, 2 if it could not be decided");
    command
        ->add_option("--dt", a.dt,
                     "by how much events may have moved from a checked timeline's: seconds, or "
                     "\"0.5 frames\"")
        ->capture_default_str();
    command->add_option("--set", a.settings, "name=value, as for render")->allow_extra_args(false);
    add_allow_outside(*command, a.reach);
    command->add_option("--backend", a.backend,
                        "auto, egl, osmesa or glfw; for the pictures of --plot");
    command->add_flag("--quiet", a.quiet, "print neither summary nor progress");
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return topology_of(*arguments); }; });
}

} // namespace isomotion::app
