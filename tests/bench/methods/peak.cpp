#include "methods/peak.h"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include "gpu/compute.h"
#include "gpu/draw.h"
#include "gpu/program.h"
#include "gpu/target.h"

namespace isomotion::bench {
namespace {

constexpr int size = 512;
constexpr int lanes = 4;     // of a vec4
constexpr int unrolled = 32; // multiply-adds of a chain in a round, beside which the loop is cheap

constexpr const char* vertex = R"(#version 330 core
void main() {
    gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}
)";

// Chains tend to 1, whatever the number of rounds, so that no number is denormal or infinite. Each
// begins elsewhere: they can't be merged.
std::string chains_text(int chains, bool function, const std::string& place) {
    std::string begin, once, sum;
    for (int k = 0; k < chains; ++k) {
        begin += fmt::format("    vec4 v{0} = {1} * 1e-3 + {0}.5;\n", k, place);
        once += function ? fmt::format("        v{0} = fma(v{0}, factor, term);\n", k)
                         : fmt::format("        v{0} = v{0} * factor + term;\n", k);
        sum += fmt::format("{}v{}", k ? " + " : "", k);
    }
    std::string round;
    for (int k = 0; k < unrolled; ++k) round += once;
    return fmt::format("{}    for (int k = 0; k < rounds; ++k) {{\n{}    }}\n    vec4 sum = {};\n",
                       begin, round, sum);
}

constexpr const char* uniforms = "uniform vec4 factor, term;\nuniform int rounds;\n";

gpu::Program in_fragments(int chains, bool function) {
    return {vertex,
            fmt::format(
                "#version {} core\n{}out vec4 color;\nvoid main() {{\n{}    color = sum;\n}}\n",
                function ? "400" : "330", uniforms, chains_text(chains, function, "gl_FragCoord")),
            "peak"};
}

gpu::Program in_compute(int chains, bool function) {
    return gpu::Program::compute(
        fmt::format("#version 430 core\nlayout(local_size_x = {0}, local_size_y = {0}) in;\n"
                    "layout(rgba32f, binding = 0) writeonly uniform image2D stored;\n{1}"
                    "void main() {{\n{2}    imageStore(stored, ivec2(gl_GlobalInvocationID.xy), "
                    "sum);\n}}\n",
                    synthesis::workgroup_side, uniforms,
                    chains_text(chains, function, "vec4(gl_GlobalInvocationID.xyzx)")),
        "peak");
}

double operations_a_second(const gpu::Target& target, synthesis::Stage stage, int chains,
                           bool function) {
    using Clock = std::chrono::steady_clock;
    constexpr double long_enough = 0.05; // seconds, beside which a draw's own cost is small
    constexpr int most_rounds = 50'000;  // below the loop limit of software drivers
    const bool computes = stage == synthesis::Stage::compute;
    const gpu::Program program =
        computes ? in_compute(chains, function) : in_fragments(chains, function);
    const gpu::Fullscreen fullscreen;
    program.set("factor", glm::vec4(0.999f));
    program.set("term", glm::vec4(0.001f));
    const auto seconds = [&](int rounds) {
        program.set("rounds", rounds);
        gpu::finish();
        const auto begin = Clock::now();
        program.use();
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
    return 2.0 * lanes * chains * unrolled * rounds * size * size / shortest;
}

} // namespace

double peak_operations(gpu::Context& context, synthesis::Stage stage) {
    const gpu::Target target(size, size);
    double best = 0;
    for (const bool function : {false, true}) {
        if (function && context.info().major < 4) continue;
        for (const int chains : {1, 2, 3, 4, 8}) {
            best = std::max(best, operations_a_second(target, stage, chains, function));
        }
    }
    return best;
}

} // namespace isomotion::bench
