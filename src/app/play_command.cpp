#include <algorithm>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "animation/frame_range.h"
#include "api/scene/reach.h"
#include "app/commands.h"
#include "app/console.h"
#include "app/gallery_inputs.h"
#include "app/open_context.h"
#include "player/player.h"
#include "player/ui/window.h"
#include "scene/reading/load.h"

namespace isomotion::app {
namespace {

player::PlayOptions with_frames(player::PlayOptions options, const std::string& frames) {
    if (frames.empty()) return options;
    const std::vector<int> all = animation::parse_frame_range(frames);
    const auto [first, last] = std::ranges::minmax_element(all);
    options.frames = {*first, *last};
    return options;
}

void expect_log_apart(const player::PlayOptions& options) {
    if (options.log.empty()) return;
    const sequence::Inputs inputs =
        options.scene.empty()
            ? gallery_inputs()
            : sequence::Inputs(scene::load(options.scene, options.overrides, options.reach));
    inputs.expect_apart("--log", options.log);
}

int play_in_window(const player::PlayOptions& options) {
    expect_log_apart(options);
    try {
        player::PlayOptions guarded = options;
        guarded.guard = words_on_crash;
        player::play(guarded);
        return exit_done;
    } catch (const player::NoWindow& error) {
        message("{}\nwithout a display, isomotion render draws frames into files\n", error.what());
        return exit_machine;
    }
}

} // namespace

void add_play(CLI::App& app, Action& chosen) {
    const auto options = std::make_shared<player::PlayOptions>();
    const auto frames = std::make_shared<std::string>();
    player::PlayOptions& o = *options;
    CLI::App* command = app.add_subcommand("play", "play a scene in a window");
    command->add_option(
        "scene", o.scene,
        "a scene file (.toml, .jsurf, .pov, .js), the name of an animation, or a formula; "
        "without one the gallery is shown");
    command
        ->add_option("--set", o.overrides,
                     "set a parameter (r=0.5) or a key of the scene file (camera.fov=30)")
        ->allow_extra_args(false);
    const auto reach = std::make_shared<Reach>(Reach::own_folder);
    add_allow_outside(*command, *reach);
    command->add_option("--frames,--frame", *frames,
                        "1-120: play from frame 1 to frame 120 (default: all of the scene)");
    command->add_flag("!--paused", o.playing, "open paused");
    command->add_flag("!--forget", o.remembers,
                      "do not remember where the window and the cameras were");
    command->add_option("--log", o.log, "write a line of JSON to this file for each picture shown");
    command->callback([options, frames, reach, &chosen] {
        options->reach = api::reach_of(*reach);
        chosen = [options, frames] { return play_in_window(with_frames(*options, *frames)); };
    });
}

} // namespace isomotion::app
