#include "player/ui/shortcuts.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace isomotion::player {
namespace {

struct Binding {
    int key;
    Command command;
    bool repeats = false; // while it is held
};

constexpr Binding bindings[] = {
    {GLFW_KEY_SPACE, Command::toggle},    {GLFW_KEY_RIGHT, Command::forward, true},
    {GLFW_KEY_LEFT, Command::back, true}, {GLFW_KEY_HOME, Command::first},
    {GLFW_KEY_END, Command::last},        {GLFW_KEY_F11, Command::full_screen},
    {GLFW_KEY_F12, Command::save},        {GLFW_KEY_TAB, Command::panel},
    {GLFW_KEY_ESCAPE, Command::dismiss},
};

// A key found by its character, wherever the keyboard's layout has it.
struct Letter {
    char32_t character;
    Command command;
};

constexpr Letter letters[] = {
    {U'[', Command::slower},
    {U']', Command::faster},
    {U'l', Command::loop},
    {U'r', Command::reset_camera},
    {U'f', Command::fit_camera},
    {U'o', Command::open},
    {U'e', Command::rings},
    {U'q', Command::quit},
    {U'?', Command::help},
    {U'1', Command::view_shaded},
    {U'2', Command::view_depth},
    {U'3', Command::view_normal},
    {U'4', Command::view_evaluations},
    {U'5', Command::view_verdicts},
    {U'6', Command::view_difference},
};

constexpr Shortcut all_shortcuts[] = {
    {"Space", "play, pause"},
    {"Left, Right", "a frame back, on"},
    {"Home, End", "first, last frame"},
    {"[  ]", "slower, faster"},
    {"L", "play over and over"},
    {"", ""},
    {"left mouse", "turn about the target"},
    {"Shift + left, middle", "move in the picture's plane"},
    {"wheel", "nearer, farther"},
    {"F", "fit the bounds into the picture"},
    {"R", "the scene's own camera"},
    {"", ""},
    {"1 - 5", "shaded, depth, normal, evaluations, verdicts"},
    {"6", "two methods, side by side"},
    {"E", "rings where the topology changes"},
    {"", ""},
    {"O", "open: the gallery (or drop a file here)"},
    {"F12", "save the picture, shaded"},
    {"Tab", "hide and show the panel"},
    {"F11", "full screen"},
    {"Q", "quit"},
};

} // namespace

std::optional<Command> command_of(const KeyPress& key) {
    if (key.character) {
        for (const Letter& letter : letters) {
            if (letter.character == key.character) return letter.command;
        }
        return std::nullopt;
    }
    if (key.key == GLFW_KEY_Q && (key.mods & GLFW_MOD_CONTROL)) return Command::quit;
    for (const Binding& binding : bindings) {
        if (binding.key == key.key && (binding.repeats || !key.repeats)) return binding.command;
    }
    return std::nullopt;
}

std::optional<View> view_of(Command command) {
    switch (command) {
    case Command::view_shaded:
        return View::shaded;
    case Command::view_depth:
        return View::depth;
    case Command::view_normal:
        return View::normal;
    case Command::view_evaluations:
        return View::evaluations;
    case Command::view_verdicts:
        return View::verdicts;
    case Command::view_difference:
        return View::difference;
    default:
        return std::nullopt;
    }
}

std::span<const Shortcut> shortcuts() { return all_shortcuts; }

} // namespace isomotion::player
