#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/commands.h"
#include "app/completions.h"
#include "app/console.h"
#include "app/manual.h"
#include "scene/data_folder.h"

namespace isomotion::app {
namespace {

std::string described(const CommandTree& tree, const std::string& as) {
    if (as == "man") return manual_page(tree, ISOMOTION_VERSION);
    const auto scenes = scene::animation_names();
    if (as == "bash") return bash_completion(tree, scenes);
    return as == "zsh" ? zsh_completion(tree, scenes) : fish_completion(tree, scenes);
}

} // namespace

void add_describe(CLI::App& app, Action& chosen) {
    const auto as = std::make_shared<std::string>();
    CLI::App* command =
        app.add_subcommand("describe", "the command line as a manual page or a shell's completion");
    command->group(""); // for the build, which installs what it prints
    command->add_option("as", *as, "man, bash, zsh or fish")
        ->required()
        ->check(CLI::IsMember({"man", "bash", "zsh", "fish"}));
    command->callback([as, &app, &chosen] {
        chosen = [as, &app] {
            print_result("{}", described(command_tree(app), *as));
            return exit_done;
        };
    });
}

} // namespace isomotion::app
