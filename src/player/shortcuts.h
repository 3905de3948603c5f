// Keys, and what they do.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "player/views.h"
#include "player/window.h"

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
// For reading, what belongs together side by side; an empty line parts groups.
std::span<const Shortcut> shortcuts();

} // namespace isomotion::player
