#include "render/arithmetic_speed.h"

#include <chrono>
#include <map>
#include <mutex>
#include <string>
#include <tuple>
#include <utility>

#include "gpu/compute.h"
#include "gpu/draw.h"
#include "gpu/query.h"
#include "gpu/target.h"
#include "shader/shader_files.h"
#include "shader/shader_text.h"

namespace isomotion::render {
namespace {

constexpr int size = 512; // pixels a side

// `run` does the work of so many rounds. 0 if no clock tells how long that takes.
//
// Drivers may have timers that always tell 0, or the time of a part of the draw (gpu/query.h). A
// timer that tells less than a tenth of a draw that took long is one of these; the wall's time,
// which holds what the driver does besides, then takes its place.
template<typename Run> double operations_a_second(const SpeedChains& chains, const Run& run) {
    using Clock = std::chrono::steady_clock;
    constexpr double long_enough = 1e-3; // seconds, beside which a draw's own cost is small
    constexpr int most_rounds = 4096;
    gpu::Timer timer;
    const auto seconds = [&](int rounds) {
        gpu::finish();
        const Clock::time_point begin = Clock::now();
        timer.begin();
        run(rounds);
        timer.end();
        gpu::finish();
        const double on_the_wall = std::chrono::duration<double>(Clock::now() - begin).count();
        return std::pair(1e-9 * double(timer.nanoseconds()), on_the_wall);
    };
    constexpr double long_on_the_wall = 20e-3; // far more than what drivers do besides
    int rounds = 1;
    seconds(rounds); // drivers make their code at the first draw
    auto [timed, wall] = seconds(rounds);
    while (timed < long_enough && wall < long_on_the_wall && rounds < most_rounds) {
        rounds *= 4;
        std::tie(timed, wall) = seconds(rounds);
    }
    const double taken = timed < 0.1 * wall ? wall : timed;
    return taken > 0 ? chains.operations_of_a_round(size * size) * rounds / taken : 0;
}

} // namespace

gpu::Program speed_program(shader::Stage stage, const SpeedChains& chains) {
    const bool computes = stage == shader::Stage::compute;
    shader::ShaderText text(stage);
    if (chains.fused && !computes) text.version(400);
    text.define(shader::Feature::chains, chains.chains);
    text.define(shader::Feature::unrolled, chains.unrolled);
    text.define(shader::Feature::fused, chains.fused);
    text.file("probe/speed.glsl");
    const std::string name = "speed of arithmetic";
    if (computes) return gpu::Program::compute(text.text(), name);
    return {"#version 330 core\n" + shader::read_shader("probe/corners.vert"), text.text(), name};
}

void set_rounds(const gpu::Program& program, int rounds) {
    program.set("factor", glm::vec4(0.999f));
    program.set("term", glm::vec4(0.001f));
    program.set("rounds", rounds);
    program.use();
}

ArithmeticSpeed measure_arithmetic_speed() try {
    const SpeedChains chains;
    const gpu::Target target(size, size);
    ArithmeticSpeed speed;
    {
        const gpu::Program program = speed_program(shader::Stage::fragment, chains);
        const gpu::Fullscreen triangle;
        target.bind();
        speed.in_fragments = operations_a_second(chains, [&](int rounds) {
            set_rounds(program, rounds);
            triangle.draw();
        });
    }
    if (gpu::has_compute(gpu::Context::current()->info())) {
        const gpu::Program program = speed_program(shader::Stage::compute, chains);
        gpu::bind_image(target.texture(0), 0);
        speed.in_compute = operations_a_second(chains, [&](int rounds) {
            set_rounds(program, rounds);
            gpu::dispatch(glm::ivec2(size / shader::workgroup_side));
        });
    }
    return speed;
} catch (const std::exception&) {
    // A driver that can't do this may still draw: its speed is not known.
    return {};
}

ArithmeticSpeed arithmetic_speed(const gpu::ContextInfo& info) {
    if (info.software) return {};
    static std::mutex mutex;
    static std::map<std::string, ArithmeticSpeed> of_renderers;
    const std::lock_guard lock(mutex);
    const auto [found, is_new] = of_renderers.try_emplace(info.renderer);
    if (is_new) found->second = measure_arithmetic_speed();
    return found->second;
}

} // namespace isomotion::render
