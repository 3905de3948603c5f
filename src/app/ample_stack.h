// A stack that is deep enough, whatever the shell's limit (`ulimit -s`).
#pragma once

namespace isomotion::app {

// What run(argc, argv) returns, called where the stack has at least 8 MB, as Linux has by default.
// The threads that a driver starts get as much: compilers of shaders call themselves deeply.
int run_on_ample_stack(int (*run)(int, char**), int argc, char** argv);

} // namespace isomotion::app
