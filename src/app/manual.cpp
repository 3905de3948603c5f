#include "app/manual.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/examples.h"

namespace isomotion::app {
namespace {

// Writes a text so that roff takes all of it for text.
std::string plain(const std::string& text) {
    std::string all;
    for (const char c : text) {
        if (c == '\\') {
            all += "\\e";
        } else if (c == '-') {
            all += "\\-";
        } else {
            // A line's first dot or quote would be a request.
            if ((c == '.' || c == '\'') && (all.empty() || all.back() == '\n')) all += "\\&";
            all += c;
        }
    }
    return all;
}

std::string option_entry(const OptionText& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.names) {
        names.push_back(fmt::format("{}{}\\fR", option.positional ? "\\fI" : "\\fB", plain(name)));
    }
    std::string text = fmt::format(".TP\n{}", fmt::join(names, ", "));
    if (!option.value.empty() && !option.positional) {
        text += fmt::format(" \\fI{}\\fR", plain(option.value));
    }
    return text + "\n" + plain(option.description) + "\n";
}

std::string synopsis(const std::string& program, const CommandText& command) {
    std::string text = fmt::format(".B {} {}\n", program, command.name);
    for (const OptionText& option : command.options) {
        if (!option.positional) continue;
        text += option.required ? fmt::format(".I {}\n", option.names.front())
                                : fmt::format(".RI [ {} ]\n", option.names.front());
    }
    return text + ".RI [ options ]\n";
}

// These words are those of docs/, which tell more.
constexpr const char* around = R"(.SH FILES
Scenes are files of TOML, or names of the gallery that comes with the program:
.B isomotion list
names them. The program finds its shaders and animations in
.I share/isomotion
beside its own folder.
.SH ENVIRONMENT
.TP
.B ISOMOTION_DATA
the folder to take shaders and animations from instead
.TP
.B ISOMOTION_OSMESA
the OSMesa library to load instead of the system's
.TP
.B ISOMOTION_LARGEST_SHADERS
how many operations a scene's shaders may have, as
.B isomotion show
counts them, instead of what a driver compiles in some ten seconds; longer formulas are run
instruction by instruction, all of them with a limit of 1
.SH EXIT STATUS
.TP
.B 0
done
.TP
.B 1
a check failed: frames, topology or accuracy are not what was asked for
.TP
.B 2
a wrong command line or scene file; or a check that could not be decided
.TP
.B 3
what the machine can't: no OpenGL, a full disk, a folder that can't be written
.TP
.B 130
interrupted
)";

} // namespace

std::string manual_page(const CommandTree& tree, const std::string& version) {
    std::string text = fmt::format(".TH ISOMOTION 1 \"\" \"isomotion {}\" \"User Commands\"\n"
                                   ".SH NAME\n{} \\- renders implicit surfaces that move\n"
                                   ".SH SYNOPSIS\n.nh\n",
                                   plain(version), tree.name);
    for (const CommandText& command : tree.commands) {
        text += synopsis(tree.name, command) + ".br\n";
    }
    text += ".hy\n.SH DESCRIPTION\n" + plain(tree.description) + "\n.SH OPTIONS\n";
    for (const OptionText& option : tree.options) text += option_entry(option);
    text += ".SH COMMANDS\n";
    for (const CommandText& command : tree.commands) {
        text += fmt::format(".SS {}\n{}\n", command.name, plain(command.description));
        for (const OptionText& option : command.options) text += option_entry(option);
    }
    text += std::string(around) + ".SH EXAMPLES\n";
    for (const Example& example : examples) {
        text += fmt::format(".TP\n.B {}\n{}\n", plain(std::string(example.line)),
                            plain(std::string(example.what)));
    }
    return text;
}

} // namespace isomotion::app
