// How much arithmetic a driver does, which decides how much work a draw may be given.
#pragma once

#include "gpu/context.h"
#include "gpu/program.h"
#include "shader/stage.h"

namespace isomotion::render {

// Floating-point operations a second of independent chains of multiply-adds, two operations each,
// in shaders of the two stages. Measured in some milliseconds, so a lower bound, good to a factor
// of two. 0 if it is not known.
struct ArithmeticSpeed {
    double in_fragments = 0;
    double in_compute = 0; // 0 without compute shaders

    double in(shader::Stage stage) const {
        return stage == shader::Stage::fragment ? in_fragments : in_compute;
    }
};

// Measures in the context that is current. Changes the bound target and texture bindings.
ArithmeticSpeed measure_arithmetic_speed();

// The speed of the current context's hardware, measured once in a process; of software renderers 0,
// without measuring.
ArithmeticSpeed arithmetic_speed(const gpu::ContextInfo& info);

// What shaders/probe/speed.glsl is compiled with.
struct SpeedChains {
    int chains = 4;     // 1, 2, 3, 4 or 8, of four numbers each
    int unrolled = 16;  // turns in a round, 16 or 32
    bool fused = false; // fma(), from GLSL 4.00 on

    double operations_of_a_round(double invocations) const {
        return 2.0 * 4 * chains * unrolled * invocations;
    }
};

// Throws gpu::CompileError.
gpu::Program speed_program(shader::Stage stage, const SpeedChains& chains);
// Sets how often each invocation goes through its round, and makes the program the current one.
void set_rounds(const gpu::Program& program, int rounds);

} // namespace isomotion::render
