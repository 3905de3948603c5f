// How a program calls the kernels of shaders/math/.
//
// Mostly one call an operation; but a value and its slope often come from one kernel: the sine and
// the cosine of a, a^b and a^(b-1).
//
// Drivers put a kernel's text wherever it is called, so that hundreds of calls take seconds to
// compile. Making calls of one kernel in a loop over arrays links several times faster, but was
// measured to draw two to three times slower on llvmpipe, which keeps such arrays in memory.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "formula/graph/program.h"

namespace isomotion::formula {

struct KernelCall {
    std::string_view kernel; // of im_<kernel>
    std::vector<Register> arguments;
    int results = 1; // a float, or a vec2
};

struct KernelResult {
    int call = 0;
    int component = 0; // of a vec2
};

struct KernelCalls {
    std::vector<KernelCall> calls;
    std::map<Register, KernelResult> results; // which call gives a register's value
};

KernelCalls kernel_calls(const Program& program);

// The operations ("exp", "pow", ...) a program needs kernels for; each has a file in shaders/math/.
std::set<std::string> kernels_used(const Program& program);

} // namespace isomotion::formula
