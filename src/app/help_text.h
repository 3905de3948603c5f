// Writes help that begins with an example.
#pragma once

namespace CLI {
class App;
}

namespace isomotion::app {

// Applies to the command line and to commands added to it later.
void write_help_with_examples(CLI::App& app);

} // namespace isomotion::app
