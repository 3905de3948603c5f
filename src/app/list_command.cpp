#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/commands.h"
#include "app/console.h"
#include "scene/data_folder.h"
#include "scene/method.h"
#include "scene/reading/load.h"
#include "synthesis/effect.h"

namespace isomotion::app {
namespace {

int list(const std::string& what) {
    if (what == "methods") {
        for (const auto& method : scene::method_traits) {
            print_result("{:<12} {}\n", method.name, method.summary);
        }
        return exit_done;
    }
    if (what == "effects") {
        for (const auto& effect : synthesis::effect_traits()) {
            print_result("{:<16} {}\n", effect.name, effect.summary);
        }
        return exit_done;
    }
    const bool surfaces = what == "surfaces";
    for (const auto& name : surfaces ? scene::surface_names() : scene::animation_names()) {
        const auto file = surfaces ? scene::surface_file(name) : scene::animation_file(name);
        print_result("{:<26} {}\n", name, scene::title(file));
    }
    return exit_done;
}

} // namespace

void add_list(CLI::App& app, Action& chosen) {
    const auto what = std::make_shared<std::string>("animations");
    CLI::App* command = app.add_subcommand("list", "list animations, surfaces, methods or effects");
    command->add_option("what", *what, "animations (default), surfaces, methods or effects")
        ->check(CLI::IsMember({"animations", "surfaces", "methods", "effects"}));
    command->callback([what, &chosen] { chosen = [what] { return list(*what); }; });
}

} // namespace isomotion::app
