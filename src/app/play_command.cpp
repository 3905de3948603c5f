#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/commands.h"
#include "app/console.h"
#include "player/player.h"
#include "player/ui/window.h"

namespace isomotion::app {
namespace {

int play_in_window(const player::PlayOptions& options) {
    try {
        player::play(options);
        return exit_done;
    } catch (const player::NoWindow& error) {
        message("{}\nwithout a display, isomotion render draws frames into files\n", error.what());
        return exit_machine;
    }
}

} // namespace

void add_play(CLI::App& app, Action& chosen) {
    const auto options = std::make_shared<player::PlayOptions>();
    player::PlayOptions& o = *options;
    CLI::App* command = app.add_subcommand("play", "play a scene in a window");
    command->add_option("scene", o.scene,
                        "a scene file (.toml) or the name of a gallery animation; without one the "
                        "gallery is shown");
    command
        ->add_option("--set", o.overrides,
                     "name=value: a parameter, or a key of the scene file (camera.fov=30)")
        ->allow_extra_args(false);
    add_allow_outside(*command, o.reach);
    command->add_flag("!--paused", o.playing, "do not play at once");
    command->add_flag("!--forget", o.remembers,
                      "neither use nor keep what is remembered: the window's place, cameras");
    command->add_option("--log", o.log, "a file: a line of JSON for each picture shown");
    command->callback(
        [options, &chosen] { chosen = [options] { return play_in_window(*options); }; });
}

} // namespace isomotion::app
