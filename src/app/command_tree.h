// The command line as plain values. The manual page and the completions are written from it, so
// that they always describe the command line that the program has.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace isomotion::app {

struct OptionText {
    std::vector<std::string> names; // "-o", "--output"; of a positional argument its name alone
    std::string value;              // "TEXT", "FLOAT"; empty: a flag
    std::string description;
    std::vector<std::string> choices; // all values there are; empty where any will do
    bool positional = false, required = false;
};

struct CommandText {
    std::string name, description;
    std::vector<OptionText> options; // positional arguments first
};

struct CommandTree {
    std::string name, description;
    std::vector<OptionText> options;
    std::vector<CommandText> commands; // without the hidden ones
};

CommandTree command_tree(const CLI::App& app);

} // namespace isomotion::app
