#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <span>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/commands.h"
#include "app/console.h"
#include "app/gallery_inputs.h"
#include "app/open_context.h"
#include "app/progress.h"
#include "app/stop_on_signal.h"
#include "base/file.h"
#include "base/printable.h"
#include "isomotion/isomotion.h"
#include "page/gallery.h"

namespace isomotion::app {
namespace fs = std::filesystem;
namespace {

struct PageArguments {
    std::string scene, output, backend = "auto";
    std::vector<std::string> settings;
    Reach reach = Reach::own_folder;
    std::string report;
    bool gallery = false, video = false, quiet = false;
};

void write(const fs::path& file, const std::string& text) {
    base::write_whole(file, std::as_bytes(std::span(text)));
}

fs::path file_of(const PageArguments& arguments, const Scene& scene) {
    if (arguments.output.empty()) return scene.name() + ".html";
    fs::path file = arguments.output;
    if (file.extension() == ".html" || file.extension() == ".htm") return file;
    throw std::invalid_argument(
        fmt::format("-o {0}: a page is an HTML file, as {0}.html", arguments.output));
}

// A folder of its own, which goes with this.
class Workplace {
public:
    Workplace() {
        std::string name = (fs::temp_directory_path() / "isomotion-page-XXXXXX").string();
        if (!::mkdtemp(name.data())) throw base::FileError(name, "cannot be made", errno);
        folder_ = name;
    }
    ~Workplace() {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    Workplace(const Workplace&) = delete;
    Workplace& operator=(const Workplace&) = delete;
    fs::path operator/(const char* name) const { return folder_ / name; }

private:
    fs::path folder_;
};

// All frames, small: sides of up to 320 pixels, even ones, as encoders want them. Empty if stopped.
std::vector<std::byte> movie_of(const PageArguments& arguments, const Scene& scene) {
    constexpr double side = 320;
    const double scale = side / std::max(scene.width(), scene.height());
    const auto even = [&](int length) { return std::max(2, 2 * int(0.5 * scale * length)); };
    const Scene small = scene.with(
        "output.size", fmt::format("[{}, {}]", even(scene.width()), even(scene.height())));
    const Workplace folder;
    const fs::path movie = folder / "movie.mp4";
    Exporter exporter(small, {.output = folder / "frame.####.png", .movies = {movie}, .audit = 0});
    exporter.prepare(); // without ffmpeg nothing is drawn
    Device device = open_device(arguments.backend);
    const StopOnSignal stop;
    Progress progress("drawing the movie", scene.frames(), arguments.quiet);
    const ExportWatcher watcher{
        .stop = [&] { return stop.asked(); },
        .progress = [&](const ExportProgress& now) { progress.show(now.done + now.part); },
        .warn = warn};
    stop.work_has_begun();
    const bool is_whole =
        !exporter.write_frames(device, watcher).stopped && exporter.write_movies(watcher.stop);
    return is_whole ? base::read_whole(movie) : std::vector<std::byte>();
}

// NAME.accuracy beside NAME.toml, where there is such a report.
std::optional<fs::path> report_beside(const Scene& scene) {
    const std::optional<fs::path> file = scene.file();
    if (!file) return std::nullopt;
    fs::path report = *file;
    report.replace_extension(".accuracy");
    std::error_code ignored;
    return fs::exists(report, ignored) ? std::optional(report) : std::nullopt;
}

// A report that was not asked for may be of other settings: the page goes without it.
std::string page_with_report_beside(const Scene& scene, PageSettings& settings) {
    settings.report = report_beside(scene);
    if (!settings.report) return page_of(scene, settings, warn);
    try {
        return page_of(scene, settings, warn);
    } catch (const Error& error) {
        if (error.code() != Error::Code::input) throw;
        warn(fmt::format("{}; the page goes without the report", error.what()));
        settings.report.reset();
        return page_of(scene, settings, warn);
    }
}

int write_page(const PageArguments& arguments) {
    const Scene scene = Scene::load(arguments.scene, arguments.settings, arguments.reach);
    const fs::path file = file_of(arguments, scene);
    sequence::Inputs inputs(scene.files());
    inputs.add(fs::is_directory(arguments.report) ? arguments.report / fs::path("accuracy.json")
                                                  : fs::path(arguments.report));
    inputs.expect_apart("-o", file);
    PageSettings settings;
    if (!arguments.report.empty()) settings.report = arguments.report;
    // What is refused is refused before anything is drawn.
    std::string text =
        settings.report ? page_of(scene, settings, warn) : page_with_report_beside(scene, settings);
    if (arguments.video) {
        settings.movie = movie_of(arguments, scene);
        if (settings.movie.empty()) return exit_interrupted;
        text = page_of(scene, settings); // its warnings were told
    }
    if (file.has_parent_path()) fs::create_directories(file.parent_path());
    write(file, text);
    if (!arguments.quiet)
        print_result("page: {}, {} kB\n", file.string(), (text.size() + 999) / 1000);
    return exit_done;
}

// File systems may take "Index" for "index".
bool is_index(std::string name) {
    std::ranges::transform(name, name.begin(), [](char c) { return char(std::tolower(c)); });
    return name == "index";
}

int write_gallery(const PageArguments& arguments) {
    constexpr int side = 256; // of the posters
    const fs::path folder = arguments.output.empty() ? "site" : arguments.output;
    fs::create_directories(folder);
    Device device = open_device(arguments.backend);
    const std::vector<std::string> names = animations();
    const sequence::Inputs inputs = gallery_inputs();
    inputs.expect_apart("-o", folder / "index.html");
    Progress progress("writing pages", int(names.size()), arguments.quiet);
    std::vector<page::GalleryEntry> entries;
    std::vector<std::string> left_out, shown; // with and without the scene's path
    const auto leave_out = [&](const std::string& name, const std::string& why) {
        left_out.push_back(fmt::format("{}: {}", name, why));
        shown.push_back(
            fmt::format("{}: {}", name, page::without_place_in_file(why, name + ".toml")));
    };
    for (const std::string& name : names) {
        progress.show(int(entries.size() + left_out.size()), name);
        if (is_index(name)) {
            leave_out(name, "its page would have the index's name; give its file another name");
            continue;
        }
        try {
            const Scene scene = Scene::load(name, {fmt::format("output.size=[{0},{0}]", side)});
            for (const char* extension : {".png", ".html"})
                inputs.expect_apart("-o", folder / (name + extension));
            const std::string text = page_of(scene);
            Renderer(device, scene).draw(scene.poster()).write(folder / (name + ".png"));
            write(folder / (name + ".html"), text);
            entries.push_back({name, scene.title()});
        } catch (const Error& error) {
            const bool is_of_scene =
                error.code() == Error::Code::input || error.code() == Error::Code::limit;
            if (!is_of_scene) throw;
            leave_out(name, error.what());
        }
    }
    write(folder / "index.html", page::gallery_index(entries, shown));
    if (!arguments.quiet)
        print_result("pages: {} and {}\n", entries.size(), (folder / "index.html").string());
    for (const std::string& line : left_out) message("left out: {}\n", base::printable_line(line));
    return exit_done;
}

int write_pages(const PageArguments& arguments) {
    check_backend(arguments.backend);
    if (arguments.gallery == !arguments.scene.empty()) {
        throw std::invalid_argument("page: name a scene, or write --gallery for all animations");
    }
    if (arguments.gallery && (arguments.video || !arguments.report.empty()))
        throw std::invalid_argument("--gallery: --video and --accuracy are of one scene");
    return arguments.gallery ? write_gallery(arguments) : write_page(arguments);
}

} // namespace

void add_page(CLI::App& app, Action& chosen) {
    const auto arguments = std::make_shared<PageArguments>();
    PageArguments& a = *arguments;
    CLI::App* command =
        app.add_subcommand("page", "write a scene as one HTML file, which plays it in a browser");
    command->add_option("scene", a.scene, "a scene file, the name of an animation, or a formula");
    command->add_option("-o,--output", a.output,
                        "file to write (default: SCENE.html), or with --gallery the folder (site)");
    command->add_flag("--video", a.video,
                      "add a small movie, for browsers that cannot draw the scene");
    command->add_option("--accuracy", a.report,
                        "show wrong pixels and time from this report of isomotion accuracy");
    command->add_flag("--gallery", a.gallery, "write pages of all animations and an index of them");
    command->add_option("--set", a.settings, "name=value, as for render")->allow_extra_args(false);
    add_allow_outside(*command, a.reach);
    command->add_option("--backend", a.backend,
                        "OpenGL back end for posters and the movie: auto, egl, osmesa or glfw");
    command->add_flag("--quiet", a.quiet, "print errors and warnings only");
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return write_pages(*arguments); }; });
}

} // namespace isomotion::app
