// The command line as plain values: what manual pages and shells' completions are written from, so
// that they never tell of another command line than the one there is.
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
    std::vector<std::string> choices; // all that the value may be; empty where it is open
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
