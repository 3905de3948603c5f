// The most arithmetic that the machine does in a shader.
#pragma once

#include "gpu/context.h"
#include "gpu/draw.h"
#include "gpu/program.h"
#include "gpu/target.h"
#include "render/arithmetic_speed.h"
#include "shader/stage.h"

namespace isomotion::bench {

// Independent chains of multiply-adds over a picture.
class Chains {
public:
    Chains(shader::Stage stage, const render::SpeedChains& chains);

    // Computes so many rounds, and does not wait for them.
    void begin(int rounds) const;
    // The seconds that so many rounds take.
    double seconds(int rounds) const;
    // The number of rounds that take at least so many seconds, as far as drivers' loops allow.
    int rounds_of(double seconds) const;
    double operations_of_a_round() const;

private:
    shader::Stage stage_;
    render::SpeedChains chains_;
    gpu::Target target_;
    gpu::Program program_;
    gpu::Fullscreen fullscreen_;
};

// Floating-point operations a second of independent chains of multiply-adds, two operations each:
// the best of several numbers of chains, with and without the function fma.
double peak_operations(gpu::Context& context, shader::Stage stage = shader::Stage::fragment);

// Keeps a graphics card at the clock that it has under load: one that waits for the processor
// between pictures lowers it.
class Load {
public:
    explicit Load(shader::Stage stage);

    // Computes for some milliseconds, and does not wait for it.
    void begin() const { chains_.begin(rounds_); }

private:
    Chains chains_;
    int rounds_;
};

} // namespace isomotion::bench
