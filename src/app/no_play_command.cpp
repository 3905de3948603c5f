// The command play of a program that was built without the window.
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/commands.h"
#include "app/console.h"

namespace isomotion::app {

void add_play(CLI::App& app, Action& chosen) {
    app.add_subcommand("play", "not in this build, which has no window")
        ->prefix_command()
        ->callback([&chosen] {
            chosen = [] {
                message("isomotion was built without the window (ISOMOTION_WINDOW=OFF); "
                        "isomotion render draws frames into files\n");
                return int(exit_machine);
            };
        });
}

} // namespace isomotion::app
