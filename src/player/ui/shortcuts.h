// Keys and their commands.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "player/model/view.h"
#include "player/ui/window.h"

namespace isomotion::player {

enum class Command {
    toggle,
    forward,
    back,
    first,
    last,
    faster,
    slower,
    loop,
    view_shaded,
    view_depth,
    view_normal,
    view_evaluations,
    view_verdicts,
    view_difference,
    reset_camera,
    fit_camera,
    copy_camera,
    panel,
    rings,
    open,
    save,
    full_screen,
    help,
    dismiss,
    quit,
};

std::optional<Command> command_of(const KeyPress& key);

// The view that a command chooses.
std::optional<View> view_of(Command command);

struct Shortcut {
    std::string_view keys, what;
};
// For the help, in groups separated by empty entries.
std::span<const Shortcut> shortcuts();

} // namespace isomotion::player
