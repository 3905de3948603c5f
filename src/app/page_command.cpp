#include <filesystem>
#include <span>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/commands.h"
#include "app/console.h"
#include "app/progress.h"
#include "base/file.h"
#include "image/encode.h"
#include "page/gallery.h"
#include "page/page.h"
#include "render/exposure.h"
#include "scene/data_folder.h"
#include "scene/reading/load.h"

namespace isomotion::app {
namespace fs = std::filesystem;
namespace {

struct PageArguments {
    std::string scene, output, backend = "auto";
    std::vector<std::string> settings;
    scene::Reach reach = scene::Reach::own_folder;
    bool gallery = false, quiet = false;
};

void write(const fs::path& file, const std::string& text) {
    base::write_whole(file, std::as_bytes(std::span(text)));
}

fs::path file_of(const PageArguments& arguments, const scene::Scene& scene) {
    if (!arguments.output.empty()) return arguments.output;
    return scene.formula.empty() ? fs::path(scene.file.stem().string() + ".html")
                                 : fs::path("formula.html");
}

int write_page(const PageArguments& arguments) {
    const scene::Scene scene = scene::load(arguments.scene, arguments.settings, arguments.reach);
    const fs::path file = file_of(arguments, scene);
    const std::string text = page::page(scene);
    if (file.has_parent_path()) fs::create_directories(file.parent_path());
    write(file, text);
    if (!arguments.quiet)
        print_result("page: {}, {} kB\n", file.string(), (text.size() + 999) / 1000);
    return exit_done;
}

// The frame that stands for the whole, small.
std::vector<std::byte> poster_of(gpu::Context& context, const scene::Scene& scene) {
    constexpr int side = 256;
    render::Renderer renderer(context, scene, {.width = side, .height = side});
    return image::encode(render::expose(renderer, scene, scene.output.poster).frame,
                         image::Format::png8);
}

int write_gallery(const PageArguments& arguments) {
    const fs::path folder = arguments.output.empty() ? "site" : arguments.output;
    fs::create_directories(folder);
    const auto context = gpu::Context::create(gpu::parse_backend(arguments.backend));
    const std::vector<std::string> names = scene::animation_names();
    Progress progress("writing pages", int(names.size()), arguments.quiet);
    std::vector<page::GalleryEntry> entries;
    std::vector<std::string> left_out;
    for (const std::string& name : names) {
        scene::Scene scene = scene::load(name, {"output.size=[256,256]"});
        progress.show(int(entries.size() + left_out.size()), name);
        try {
            write(folder / (name + ".html"), page::page(scene));
        } catch (const scene::SceneError& error) {
            left_out.push_back(fmt::format("{}: {}", scene.title, error.what()));
            continue;
        }
        base::write_whole(folder / (name + ".png"), poster_of(*context, scene));
        entries.push_back({name, scene.title});
    }
    write(folder / "index.html", page::gallery_index(entries, left_out));
    if (!arguments.quiet)
        print_result("pages: {} and {}\n", entries.size(), (folder / "index.html").string());
    for (const std::string& line : left_out) message("left out: {}\n", line);
    return exit_done;
}

int write_pages(const PageArguments& arguments) {
    if (arguments.gallery == !arguments.scene.empty()) {
        throw std::invalid_argument("page: name a scene, or write --gallery for all animations");
    }
    return arguments.gallery ? write_gallery(arguments) : write_page(arguments);
}

} // namespace

void add_page(CLI::App& app, Action& chosen) {
    const auto arguments = std::make_shared<PageArguments>();
    PageArguments& a = *arguments;
    CLI::App* command =
        app.add_subcommand("page", "a scene as one HTML file, which plays it in a browser");
    command->add_option("scene", a.scene, "a scene file, the name of an animation, or a formula");
    command->add_option("-o,--output", a.output,
                        "the file (SCENE.html), or with --gallery the folder (site)");
    command->add_flag("--gallery", a.gallery, "pages of all animations and an index of them");
    command->add_option("--set", a.settings, "name=value, as for render")->allow_extra_args(false);
    add_allow_outside(*command, a.reach);
    command->add_option("--backend", a.backend,
                        "of the gallery's posters: auto, egl, osmesa or glfw");
    command->add_flag("--quiet", a.quiet, "errors and warnings only");
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return write_pages(*arguments); }; });
}

} // namespace isomotion::app
