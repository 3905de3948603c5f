#include "gpu/arithmetic_speed.h"

#include <chrono>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "gpu/compute.h"
#include "gpu/draw.h"
#include "gpu/program.h"
#include "gpu/query.h"
#include "gpu/target.h"

namespace isomotion::gpu {
namespace {

constexpr int size = 512;     // pixels a side
constexpr int group_side = 8; // of work groups
constexpr int unrolled = 16;  // turns of the chains in a round
constexpr double operations_of_a_round = 2.0 * 4 * 4 * unrolled * size * size;

// Four chains of four numbers. They tend to 1, whatever the number of rounds, so that no number is
// denormal or infinite, and each begins elsewhere, so that they can't be merged.
std::string chains(const char* place) {
    std::string turns;
    for (int k = 0; k < unrolled; ++k)
        turns += "a = a * factor + term; b = b * factor + term; c = c * factor + term; "
                 "d = d * factor + term;\n";
    return fmt::format("vec4 a = {} * 1e-3 + 0.5, b = a + 1.0, c = a + 2.0, d = a + 3.0;\n"
                       "for (int k = 0; k < rounds; ++k) {{\n{}}}\n",
                       place, turns);
}

constexpr const char* uniforms = "uniform vec4 factor, term;\nuniform int rounds;\n";

constexpr const char* vertex = R"(#version 330 core
void main() {
    gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}
)";

Program in_fragments() {
    return {vertex,
            fmt::format("#version 330 core\n{}out vec4 sum;\nvoid main() {{\n{}sum = a + b + c + "
                        "d;\n}}\n",
                        uniforms, chains("gl_FragCoord")),
            "speed of fragment shaders"};
}

Program in_compute() {
    return Program::compute(
        fmt::format("#version 430 core\nlayout(local_size_x = {0}, local_size_y = {0}) in;\n"
                    "layout(rgba32f, binding = 0) writeonly uniform image2D sum;\n{1}"
                    "void main() {{\n{2}imageStore(sum, ivec2(gl_GlobalInvocationID.xy), a + b + c "
                    "+ d);\n}}\n",
                    group_side, uniforms, chains("vec4(gl_GlobalInvocationID.xyzx)")),
        "speed of compute shaders");
}

// `run` does the work of so many rounds. 0 if no clock tells how long that takes.
//
// Drivers may have timers that always tell 0, or the time of a part of the draw (gpu/query.h). A
// timer that tells less than a tenth of a draw that took long is one of these; the wall's time,
// which holds what the driver does besides, then takes its place.
template<typename Run> double operations_a_second(const Run& run) {
    using Clock = std::chrono::steady_clock;
    constexpr double long_enough = 1e-3; // seconds, beside which a draw's own cost is small
    constexpr int most_rounds = 4096;
    Timer timer;
    const auto seconds = [&](int rounds) {
        finish();
        const Clock::time_point begin = Clock::now();
        timer.begin();
        run(rounds);
        timer.end();
        finish();
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
    return taken > 0 ? operations_of_a_round * rounds / taken : 0;
}

void set_numbers(const Program& program, int rounds) {
    program.set("factor", glm::vec4(0.999f));
    program.set("term", glm::vec4(0.001f));
    program.set("rounds", rounds);
    program.use();
}

} // namespace

ArithmeticSpeed measure_arithmetic_speed() try {
    const Target target(size, size);
    ArithmeticSpeed speed;
    {
        const Program program = in_fragments();
        const Fullscreen triangle;
        target.bind();
        speed.in_fragments = operations_a_second([&](int rounds) {
            set_numbers(program, rounds);
            triangle.draw();
        });
    }
    if (has_compute(Context::current()->info())) {
        const Program program = in_compute();
        bind_image(target.texture(0), 0);
        speed.in_compute = operations_a_second([&](int rounds) {
            set_numbers(program, rounds);
            dispatch(glm::ivec2(size / group_side));
        });
    }
    return speed;
} catch (const std::exception&) {
    // A driver that can't do this may still draw: its speed is not known.
    return {};
}

} // namespace isomotion::gpu
