#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/commands.h"
#include "app/console.h"
#include "scene/data_folder.h"
#include "scene/key_documents.h"
#include "scene/method.h"
#include "scene/reading/load.h"
#include "shader/effect.h"

namespace isomotion::app {
namespace {

struct Folder {
    std::vector<std::string> (*names)();
    std::filesystem::path (*file)(const std::string& name);
};

// Each file's name and title.
void list_files(const Folder& folder) {
    for (const std::string& name : folder.names())
        print_result("{:<26} {}\n", name, scene::title(folder.file(name)));
}

// The keys of scene files, section by section.
void list_keys() {
    for (const scene::SectionDescription& section : scene::key_sections()) {
        const std::string name = section.most > 0 ? "[" + section.name + "]" : section.name;
        const std::string what = scene::plain_text(section.what);
        if (!name.empty()) print_result("\n[{}]{}{}\n", name, what.empty() ? "" : "  ", what);
        for (const scene::KeyDescription& key : section.keys) {
            const std::string otherwise = key.is_needed           ? " (must be given)"
                                          : key.otherwise.empty() ? ""
                                                                  : " (" + key.otherwise + ")";
            print_result("{:<14} {}\n", key.name, scene::plain_text(key.what + otherwise));
        }
    }
}

int list(const std::string& what) {
    if (what == "keys") {
        list_keys();
    } else if (what == "methods") {
        for (const auto& method : scene::method_traits) {
            print_result("{:<12} {}\n", method.name, method.summary);
        }
    } else if (what == "effects") {
        for (const auto& effect : shader::effect_traits()) {
            print_result("{:<16} {}\n", effect.name, effect.summary);
        }
    } else if (what == "looks") {
        list_files({scene::look_names, scene::look_file});
    } else if (what == "surfaces") {
        list_files({scene::surface_names, scene::surface_file});
    } else {
        list_files({scene::animation_names, scene::animation_file});
    }
    return exit_done;
}

} // namespace

void add_list(CLI::App& app, Action& chosen) {
    const auto what = std::make_shared<std::string>("animations");
    CLI::App* command = app.add_subcommand(
        "list", "list animations, surfaces, looks, methods, effects or the keys of scenes");
    command
        ->add_option("what", *what,
                     "animations (default), surfaces, looks, methods, effects or keys")
        ->check(CLI::IsMember({"animations", "surfaces", "looks", "methods", "effects", "keys"}));
    command->callback([what, &chosen] { chosen = [what] { return list(*what); }; });
}

} // namespace isomotion::app
