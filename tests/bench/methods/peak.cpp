#include "methods/peak.h"

#include <algorithm>
#include <chrono>

#include "gpu/compute.h"

namespace isomotion::bench {
namespace {

constexpr int size = 512;

double operations_a_second(const Chains& chains) {
    constexpr double long_enough = 0.05; // seconds, beside which a draw's own cost is small
    const int rounds = chains.rounds_of(long_enough);
    double shortest = chains.seconds(rounds);
    for (int again = 0; again < 4; ++again) shortest = std::min(shortest, chains.seconds(rounds));
    return chains.operations_of_a_round() * rounds / shortest;
}

} // namespace

Chains::Chains(shader::Stage stage, const render::SpeedChains& chains)
    : stage_(stage)
    , chains_(chains)
    , target_(size, size)
    , program_(render::speed_program(stage, chains)) {
    seconds(1); // drivers make their code at the first draw
}

void Chains::begin(int rounds) const {
    render::set_rounds(program_, rounds);
    if (stage_ == shader::Stage::compute) {
        gpu::bind_image(target_.texture(0), 0);
        gpu::dispatch(glm::ivec2(size / shader::workgroup_side));
    } else {
        target_.bind();
        fullscreen_.draw();
    }
}

double Chains::seconds(int rounds) const {
    using Clock = std::chrono::steady_clock;
    gpu::finish();
    const auto begun = Clock::now();
    begin(rounds);
    gpu::finish();
    return std::chrono::duration<double>(Clock::now() - begun).count();
}

int Chains::rounds_of(double wanted) const {
    constexpr int most = 50'000; // below the loop limit of software drivers
    int rounds = 16;
    while (seconds(rounds) < wanted && rounds < most) rounds = std::min(2 * rounds, most);
    return rounds;
}

double Chains::operations_of_a_round() const { return chains_.operations_of_a_round(size * size); }

double peak_operations(gpu::Context& context, shader::Stage stage) {
    double best = 0;
    for (const bool function : {false, true}) {
        if (function && context.info().major < 4) continue;
        for (const int chains : {1, 2, 3, 4, 8}) {
            best =
                std::max(best, operations_a_second(Chains(
                                   stage, {.chains = chains, .unrolled = 32, .fused = function})));
        }
    }
    return best;
}

Load::Load(shader::Stage stage)
    : chains_(stage, {.unrolled = 32})
    , rounds_(chains_.rounds_of(0.1)) {}

} // namespace isomotion::bench
