// Ensures a stack that is deep enough, whatever the shell's limit (`ulimit -s`).
#pragma once

namespace isomotion::app {

// Calls run(argc, argv) on a stack of at least 8 MB, Linux's default, and returns its result.
// Threads that a driver starts get as much, since compilers of shaders recurse deeply.
int run_on_ample_stack(int (*run)(int, char**), int argc, char** argv);

} // namespace isomotion::app
