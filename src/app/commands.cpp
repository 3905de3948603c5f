#include "app/commands.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <sstream>

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "api/scene/errors.h"
#include "app/command_tree.h"
#include "app/console.h"
#include "app/help_text.h"
#include "app/plain_words.h"
#include "app/stop_on_signal.h"
#include "gpu/lost_display.h"

namespace isomotion::app {
namespace {

int report(const Error& error) {
    message("{}\n", error.what());
    switch (error.code()) {
    case Error::Code::input:
    case Error::Code::setting:
    case Error::Code::formula:
    case Error::Code::limit:
        return exit_usage;
    case Error::Code::stopped:
        return exit_interrupted;
    case Error::Code::device:
    case Error::Code::file:
        break;
    case Error::Code::internal:
        message(
            "This is a fault of the program, and nothing is claimed. Please report it, with the "
            "scene and what `isomotion doctor --json` prints.\n");
        break;
    }
    return exit_machine;
}

// An option that was given nothing, as by a shell's empty variable, is not one that was left out.
void refuse_empty_words(CLI::App& app) {
    const auto something = [](const std::string& word) {
        return word.empty() ? std::string("is given without a value") : std::string();
    };
    for (CLI::App* command : app.get_subcommands({})) {
        for (CLI::Option* option : command->get_options()) {
            if (option->get_items_expected_max() > 0) option->check(something, "", "not empty");
        }
    }
}

// Ends the process at once and destroys nothing, since threads still draw.
[[noreturn]] void end_without_display() {
    write_message("the display is gone; what is written is whole\n");
    ::_exit(exit_machine);
}

// The command that left words over.
std::string left_over(const CLI::App& app, const CommandTree& tree) {
    for (const CLI::App* command : app.get_subcommands()) {
        for (const CommandText& text : tree.commands) {
            if (text.name == command->get_name()) return why_left_over(app.remaining(true), text);
        }
    }
    return why_left_over(app.remaining(true), {tree.name, tree.description, tree.options});
}

// Parses the command line and carries it out.
int run_command(int argc, char** argv) {
    CLI::App app(
        "Renders implicit surfaces that move: a formula F(x, y, z; parameters) = 0 and how "
        "its parameters change, drawn frame by frame on the GPU.",
        "isomotion");
    Action chosen;
    add_commands(app, chosen);
    const CommandTree tree = command_tree(app);
    const std::vector<std::string> words =
        understood(std::vector<std::string>(argv + std::min(argc, 1), argv + argc), tree);
    if (words.empty()) {
        write_result(first_words());
        return exit_done;
    }
    if (const std::string why = why_no_command(words, tree); !why.empty()) {
        write_message(why);
        return exit_usage;
    }
    try {
        app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
    } catch (const CLI::ExtrasError&) {
        write_message(left_over(app, tree));
        return exit_usage;
    } catch (const CLI::ParseError& error) {
        // CLI11 counts --help and --version as errors with code 0. Its messages repeat words.
        std::ostringstream messages;
        if (app.exit(error, std::cout, messages) == 0) return exit_done;
        write_message(messages.str());
        return exit_usage;
    }
    try {
        end_with_input();
        gpu::end_when_display_is_lost(end_without_display);
        return api::with_errors(chosen);
    } catch (const Error& error) {
        return report(error);
    } catch (const std::bad_alloc&) {
        message("out of memory: this takes more than the machine or a limit allows\n");
        return exit_machine;
    }
}

} // namespace

void add_commands(CLI::App& app, Action& chosen) {
    write_help_with_examples(app);
    app.set_version_flag("--version", "isomotion " ISOMOTION_VERSION);
    app.require_subcommand(1);
    add_render(app, chosen);
    add_submit(app, chosen);
    add_play(app, chosen);
    add_show(app, chosen);
    add_new(app, chosen);
    add_list(app, chosen);
    add_accuracy(app, chosen);
    add_topology(app, chosen);
    add_page(app, chosen);
    add_verify(app, chosen);
    add_doctor(app, chosen);
    add_describe(app, chosen);
    refuse_empty_words(app);
}

CLI::Option* add_allow_outside(CLI::App& command, Reach& reach) {
    return command.add_flag_callback(
        "--allow-outside", [&reach] { reach = Reach::anywhere; },
        "let the scene name files outside its own folder and the program's");
}

void check_amount(std::string_view option, std::optional<double> amount, std::string_view right) {
    if (!amount || (*amount >= 0 && std::isfinite(*amount))) return;
    throw std::invalid_argument(fmt::format("{} {}: write {}", option, *amount, right));
}

int run(int argc, char** argv) {
    end_on_signal();
    keep_standard_descriptors();
    // Writing beyond a limit of a file's size makes the write fail, and does not end the program.
    std::signal(SIGXFSZ, SIG_IGN);
    // A reader that has gone makes a write fail, too: frames are written without one.
    std::signal(SIGPIPE, SIG_IGN);
    // Whoever started the program may ignore this; then nobody could tell how encoders end.
    std::signal(SIGCHLD, SIG_DFL);
    int code = exit_machine;
    try {
        code = run_command(argc, argv);
    } catch (const std::exception& error) { // where not even a command could be chosen, or told of
        write_message(error.what());
        write_message("\n");
    }
    // If not all of the output could be written, the exit code tells so.
    return code == exit_done && !finish_output() ? int(exit_machine) : code;
}

} // namespace isomotion::app
