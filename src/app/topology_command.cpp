#include <algorithm>
#include <exception>
#include <filesystem>
#include <new>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/commands.h"
#include "app/console.h"
#include "app/open_context.h"
#include "app/progress.h"
#include "app/render_arguments.h"
#include "app/stop_on_signal.h"
#include "app/time_amount.h"
#include "base/file.h"
#include "sequence/inputs.h"

namespace isomotion::app {
namespace fs = std::filesystem;
namespace {

using Certify = TopologySettings::Certify;

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

void check_extension(const char* option, const std::string& file, const char* extension) {
    if (file.empty() || fs::path(file).extension() == extension) return;
    throw std::invalid_argument(fmt::format("{} {}: the name must end in {}: {}", option, file,
                                            extension,
                                            fs::path(file).replace_extension(extension).string()));
}

Certify parse_certify(const std::string& text) {
    if (text == "off") return Certify::off;
    if (text == "fast") return Certify::fast;
    if (text == "full") return Certify::full;
    throw std::invalid_argument(fmt::format("--certify {}: write off, fast or full", text));
}

// The first and the last frame of what is searched; all time in between is searched, too.
std::pair<int, int> span_of(const std::string& text, const Scene& scene) {
    if (text.empty()) {
        if (scene.frames() > 1) return {1, scene.frames()};
        throw std::invalid_argument(
            "the scene has one frame, in which nothing happens; a timeline needs two: set frames "
            "in its [time], or --frames 1-100");
    }
    const std::vector<int> frames = frame_numbers(text);
    const bool is_span =
        frames.size() > 1 && frames.back() - frames.front() + 1 == std::ptrdiff_t(frames.size());
    if (!is_span || !std::ranges::is_sorted(frames)) {
        throw std::invalid_argument(fmt::format(
            "--frames {}: topology searches a span with all time in it; write 1-10", text));
    }
    return {frames.front(), frames.back()};
}

// Which side of a surface is the solid, as `--solid` says: SIDE for each surface, or NAME=SIDE for
// one of several.
std::vector<Solid> parse_solids(const std::vector<std::string>& texts, const Scene& scene) {
    std::vector<Solid> solids;
    for (const std::string& text : texts) {
        const std::size_t equals = text.rfind('=');
        const bool is_named = equals != std::string::npos;
        const std::string name = is_named ? text.substr(0, equals) : "";
        const std::string side = is_named ? text.substr(equals + 1) : text;
        if (side != "negative" && side != "positive") {
            throw std::invalid_argument(fmt::format(
                "--solid {}: write negative, where F < 0 is the solid, or positive, where F > 0 "
                "is; for one of several surfaces NAME=negative",
                text));
        }
        if (is_named && scene.surfaces().size() == 1) {
            throw std::invalid_argument(
                fmt::format("--solid {}: the scene has one surface; write --solid {}", text, side));
        }
        if (is_named) expect_surface(scene, name, "--solid");
        solids.push_back({name, side == "negative"});
    }
    return solids;
}

void expect_names(const TopologyArguments& arguments, const Scene& scene) {
    if (!arguments.surface.empty()) expect_surface(scene, arguments.surface, "--surface");
    for (const std::string& name : arguments.contact) expect_surface(scene, name, "--contact");
    if (!arguments.contact.empty() && arguments.contact[0] == arguments.contact[1]) {
        throw std::invalid_argument(
            fmt::format("--contact {0} {0}: name two surfaces of the scene", arguments.contact[0]));
    }
}

TopologySettings settings_of(const TopologyArguments& arguments, const Scene& scene) {
    TopologySettings settings;
    settings.certify = parse_certify(arguments.certify);
    settings.grid = arguments.grid;
    settings.surface = arguments.surface;
    if (!arguments.contact.empty()) {
        settings.surface = arguments.contact[0];
        settings.touching = arguments.contact[1];
    }
    std::tie(settings.first, settings.last) = span_of(arguments.frames, scene);
    settings.solid = parse_solids(arguments.solids, scene);
    return settings;
}

void expect_searched(const TopologySettings& settings, const Scene& scene) {
    if (scene.surfaces().size() == 1) return;
    for (const Solid& solid : settings.solid) {
        const std::string& name = solid.surface;
        if (name.empty() || name == settings.surface || name == settings.touching) continue;
        throw std::invalid_argument(
            fmt::format("--solid {}: that surface is not searched", solid.surface));
    }
}

// A line for each solid that is {F > 0}; empty if there is none.
std::string solid_text(const Topology& found) {
    std::string lines;
    const bool are_named = found.solids.size() > 1;
    for (const auto& [name, is_negative] : found.solids) {
        if (is_negative) continue;
        lines += fmt::format("{}the solid is F > 0; --solid {}negative takes F < 0\n",
                             are_named ? name + ": " : "", are_named ? name + "=" : "");
    }
    return lines;
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

// The picture of the timeline. Returns how many of those in it are missing, since the command was
// interrupted.
int write_plot(const TopologyArguments& arguments, const Topology& found,
               const StopOnSignal& stop) {
    std::optional<Device> device;
    try {
        device = open_device(arguments.backend);
    } catch (const Error& error) {
        if (error.code() != Error::Code::device) throw;
        message("warning: no OpenGL here: {} has no pictures of the surface\n", arguments.plot);
    }
    TopologyPlot plot;
    {
        Progress progress("drawing", 1000, arguments.quiet);
        plot = plot_of(
            found, device ? &*device : nullptr,
            {.stop = [&] { return stop.asked(); },
             .progress = [&](const std::string&, double part) { progress.show(1000 * part); }});
    }
    if (!plot.why_incomplete.empty()) {
        warn(fmt::format("{} lacks pictures of the surface: {}", arguments.plot,
                         plot.why_incomplete));
    }
    write_text(arguments.plot, plot.svg);
    return plot.undrawn;
}

// Writes each file, whatever becomes of the others. What the first that fails throws is thrown at
// the end. Returns how many pictures are missing, since the command was interrupted.
int write_files(const TopologyArguments& arguments, const Topology& found,
                const StopOnSignal& stop) {
    std::exception_ptr first;
    int undrawn = 0;
    const auto write = [&](const std::string& file, const auto& work) {
        if (file.empty()) return;
        try {
            work();
        } catch (...) {
            if (!first) first = std::current_exception();
        }
    };
    write(arguments.output, [&] { write_text(arguments.output, found.json()); });
    write(arguments.csv, [&] { write_text(arguments.csv, found.csv()); });
    write(arguments.plot, [&] { undrawn = write_plot(arguments, found, stop); });
    if (first) std::rethrow_exception(first);
    return undrawn;
}

Topology searched(const TopologyArguments& arguments, const Scene& scene,
                  const TopologySettings& settings, const StopOnSignal& stop) {
    Progress progress("topology", 1000, arguments.quiet);
    const Watcher watcher{.stop = [&] { return stop.asked(); },
                          .progress =
                              [&](const std::string& what, double part) {
                                  stop.work_has_begun();
                                  progress.show(int(1000 * part), what);
                              },
                          .warn = warn};
    try {
        return with_options_named([&] { return topology_of(scene, settings, watcher); });
    } catch (const std::bad_alloc&) {
        throw Error(Error::Code::device,
                    "out of memory: the search for events takes more than there is; "
                    "search fewer --frames at a time, or with --certify fast");
    }
}

int judged(const TopologyArguments& arguments, const TopologyCheck& check) {
    using Outcome = TopologyCheck::Outcome;
    if (check.outcome != Outcome::passes) {
        message("{}", check.summary);
        return check.outcome == Outcome::differs ? exit_check_failed : exit_incomplete;
    }
    if (!arguments.quiet) print_result("{}", check.summary);
    return exit_done;
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
    if (parse_certify(arguments.certify) == Certify::full) return;
    throw std::invalid_argument(fmt::format(
        "--certify {}: contact of surfaces is proved or not found; leave it out, or name one "
        "surface by --surface NAME",
        arguments.certify));
}

void tell_of_sections(const TopologyArguments& arguments, const Scene& scene) {
    if (!scene.is_cut() || arguments.quiet) return;
    message("sections cut what is seen; the topology is that of the whole surface\n");
}

// When and where each two surfaces of the scene touch.
int contacts_of(const TopologyArguments& arguments, const Scene& scene) {
    tell_of_sections(arguments, scene);
    check_options_of_all(arguments);
    check_proves_contact(arguments);
    const TopologySettings settings = settings_of(arguments, scene);
    const std::vector<std::string> names = scene.surfaces();
    std::vector<TopologySettings> pairs;
    for (std::size_t first = 0; first < names.size(); ++first) {
        for (std::size_t second = first + 1; second < names.size(); ++second) {
            pairs.push_back(settings);
            pairs.back().surface = names[first];
            pairs.back().touching = names[second];
            // A mistake in the last pair's last frame is told before minutes of searching the
            // first.
            with_options_named([&] { topology_plan(scene, pairs.back()); });
        }
    }
    const StopOnSignal stop;
    bool is_complete = true;
    for (const TopologySettings& pair : pairs) {
        if (stop.asked()) break;
        const Topology found = searched(arguments, scene, pair, stop);
        is_complete = is_complete && found.doubts.empty();
        if (!arguments.quiet) print_result("{}{}", solid_text(found), found.contact());
    }
    if (stop.asked()) {
        message("interrupted; what was told is what was known\n");
        return exit_interrupted;
    }
    return is_complete ? exit_done : exit_open;
}

int search(const TopologyArguments& arguments) {
    // What can be known to fail is told before minutes of searching.
    check_extension("-o", arguments.output, ".json");
    check_extension("--csv", arguments.csv, ".csv");
    check_extension("--plot", arguments.plot, ".svg");
    const Certify certify = parse_certify(arguments.certify);
    const TimeAmount dt = parse_time_amount("--dt", arguments.dt);
    check_backend(arguments.backend);
    if (!arguments.contact.empty()) check_proves_contact(arguments);
    const Scene scene = Scene::load(arguments.scene, arguments.settings, arguments.reach);
    sequence::Inputs inputs(scene.files());
    inputs.add(arguments.check);
    inputs.expect_apart("-o", arguments.output);
    inputs.expect_apart("--csv", arguments.csv);
    inputs.expect_apart("--plot", arguments.plot);
    const bool is_of_all = arguments.surface.empty() && arguments.contact.empty();
    if (is_of_all && scene.surfaces().size() > 1) return contacts_of(arguments, scene);
    expect_names(arguments, scene);
    tell_of_sections(arguments, scene);
    const TopologySettings settings = settings_of(arguments, scene);
    std::optional<Expectation> expectation;
    if (!arguments.check.empty()) expectation.emplace(arguments.check, scene);
    expect_searched(settings, scene);
    const StopOnSignal stop;
    const Topology found = searched(arguments, scene, settings, stop);
    const bool is_whole = !stop.asked();
    if (!arguments.quiet)
        print_result("{}{}{}", solid_text(found), found.summary(), found.contact());
    // The judgement is told first, so that no file that fails to be written keeps it back.
    int code = certify == Certify::full && !found.doubts.empty() ? exit_open : exit_done;
    if (expectation)
        code = judged(arguments, expectation->check(found, dt.seconds(scene.frames_per_second())));
    const int undrawn = write_files(arguments, found, stop);
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
        ->add_option(
            "scene", a.scene,
            "a scene file (.toml, .jsurf, .pov, .js), the name of an animation, or a formula")
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
        [arguments, &chosen] { chosen = [arguments] { return search(*arguments); }; });
}

} // namespace isomotion::app
