// The commands of the program. Each adds itself to the command line and throws on failure; run()
// converts exceptions to messages and exit codes.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isomotion/isomotion.h"

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace isomotion::app {

enum ExitCode {
    exit_done = 0,
    exit_check_failed = 1,
    exit_usage = 2,         // a wrong command line or scene
    exit_incomplete = 2,    // a check neither passed nor failed
    exit_machine = 3,       // no GL, disk full, unwritable
    exit_open = 4,          // a timeline that should be proved is not complete
    exit_interrupted = 130, // Ctrl-C, as shells count it
};

// Each sets `chosen` to its action if its command is given.
using Action = std::function<int()>;
void add_render(CLI::App& app, Action& chosen);
void add_submit(CLI::App& app, Action& chosen);
void add_list(CLI::App& app, Action& chosen);
void add_new(CLI::App& app, Action& chosen);
void add_show(CLI::App& app, Action& chosen);
void add_accuracy(CLI::App& app, Action& chosen);
void add_topology(CLI::App& app, Action& chosen);
void add_play(CLI::App& app, Action& chosen);
void add_page(CLI::App& app, Action& chosen);
void add_verify(CLI::App& app, Action& chosen);
void add_doctor(CLI::App& app, Action& chosen);
void add_describe(CLI::App& app, Action& chosen);

// Adds all commands and the common options.
void add_commands(CLI::App& app, Action& chosen);

// --allow-outside: the scene may name files outside of its own folder.
CLI::Option* add_allow_outside(CLI::App& command, Reach& reach);

// Throws unless a given option is finite and at least 0. `right` states what to write: "--dt nan:
// write seconds, 0 or more: 1e-9".
void check_amount(std::string_view option, std::optional<double> amount, std::string_view right);
inline constexpr std::string_view wrong_pixels = "wrong pixels in a million, 0 or more: 10";

int run(int argc, char** argv);

} // namespace isomotion::app
