// How a program calls the kernels of shaders/math/.
//
// Mostly there is one call per operation. But a value and its slope often come from one kernel: the
// sine and the cosine of a, a^b and a^(b-1).
//
// Drivers inline a kernel's text at each call, so hundreds of calls take seconds to compile. Loops
// over arrays that call one kernel link several times faster. But measured on llvmpipe they draw
// two to three times slower, since it keeps such arrays in memory.
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
    int results = 1;       // a float, or a vec2
    std::string numbers{}; // further arguments
};

struct KernelResult {
    int call = 0;
    int component = 0; // of a vec2
};

struct KernelCalls {
    std::vector<KernelCall> calls;
    std::map<Register, KernelResult> results; // the call that gives a register's value
};

KernelCalls kernel_calls(const Program& program);

// ", ivec3(1, 0, 0)": how often noise is differentiated along each axis.
std::string glsl_noise_order(const Instruction& noise);

// The operations ("exp", "pow", ...) for which a program needs kernels; each has a file in
// shaders/math/.
std::set<std::string> kernels_used(const Program& program);

} // namespace isomotion::formula
