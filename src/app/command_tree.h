// The command line as plain values. The manual page and the completions are generated from it, so
// that they always match the program's command line.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace isomotion::app {

struct OptionText {
    std::vector<std::string> names; // "-o", "--output"; for a positional argument only its name
    std::string value;              // "TEXT", "FLOAT"; empty: a flag
    std::string description;
    std::vector<std::string> choices; // all possible values; empty if any value is allowed
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
