// Help that begins with an example.
#pragma once

namespace CLI {
class App;
}

namespace isomotion::app {

// For the command line and the commands that are added to it afterwards.
void write_help_with_examples(CLI::App& app);

} // namespace isomotion::app
