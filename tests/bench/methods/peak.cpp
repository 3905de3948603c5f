#include "methods/peak.h"

#include <algorithm>
#include <chrono>

#include "gpu/compute.h"
#include "gpu/draw.h"
#include "gpu/target.h"
#include "render/arithmetic_speed.h"

namespace isomotion::bench {
namespace {

constexpr int size = 512;

double operations_a_second(const gpu::Target& target, synthesis::Stage stage,
                           const render::SpeedChains& chains) {
    using Clock = std::chrono::steady_clock;
    constexpr double long_enough = 0.05; // seconds, beside which a draw's own cost is small
    constexpr int most_rounds = 50'000;  // below the loop limit of software drivers
    const bool computes = stage == synthesis::Stage::compute;
    const gpu::Program program = render::speed_program(stage, chains);
    const gpu::Fullscreen fullscreen;
    const auto seconds = [&](int rounds) {
        gpu::finish();
        const auto begin = Clock::now();
        render::set_rounds(program, rounds);
        if (computes) {
            gpu::bind_image(target.texture(0), 0);
            gpu::dispatch(glm::ivec2(size / synthesis::workgroup_side));
        } else {
            fullscreen.draw();
        }
        gpu::finish();
        return std::chrono::duration<double>(Clock::now() - begin).count();
    };
    target.bind();
    seconds(1); // drivers make their code at the first draw
    int rounds = 16;
    double shortest = seconds(rounds);
    while (shortest < long_enough && rounds < most_rounds) {
        rounds = std::min(2 * rounds, most_rounds);
        shortest = seconds(rounds);
    }
    for (int again = 0; again < 4; ++again) shortest = std::min(shortest, seconds(rounds));
    return chains.operations_of_a_round(size * size) * rounds / shortest;
}

} // namespace

double peak_operations(gpu::Context& context, synthesis::Stage stage) {
    const gpu::Target target(size, size);
    double best = 0;
    for (const bool function : {false, true}) {
        if (function && context.info().major < 4) continue;
        for (const int chains : {1, 2, 3, 4, 8}) {
            best = std::max(
                best, operations_a_second(target, stage,
                                          {.chains = chains, .unrolled = 32, .fused = function}));
        }
    }
    return best;
}

} // namespace isomotion::bench
