// What a sequence costs beside drawing its frames. Read the ratios: times vary with the machine.
//
//   render_to_png          wall time of the program over the sum of the frames' drawing times
//   frame_time_and_memory  drawing time of the last tenth of 1,000 frames over the first; growth of
//                          resident memory after the first 100
//   first_frame            compile, link and first draw, where software renderers make their code

#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <unistd.h>

#include "render/renderer.h"
#include "scene/reading/load.h"

namespace {

using namespace isomotion;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

// Everything that a command prints.
std::string output_of(const std::string& command) {
    std::string text;
    FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) return text;
    std::array<char, 512> line{};
    while (std::fgets(line.data(), int(line.size()), pipe)) text += line.data();
    return pclose(pipe) == 0 ? text : std::string();
}

double resident_megabytes() {
    std::ifstream statm("/proc/self/statm");
    long total = 0, resident = 0;
    statm >> total >> resident;
    return double(resident) * double(sysconf(_SC_PAGESIZE)) / 1e6;
}

void render_to_png(benchmark::State& state) {
    const auto folder =
        std::filesystem::temp_directory_path() / ("isomotion-bench-" + std::to_string(getpid()));
    for (auto _ : state) {
        const std::string said = output_of(
            fmt::format("{} render blobby75 --size 512x512 --frames 1-120x{} -o {}/b.####.png",
                        ISOMOTION_PROGRAM, state.range(0), folder.string()));
        const std::size_t before = said.find(" s, ", said.find("all of it took"));
        if (before == std::string::npos) {
            state.SkipWithError("the program failed");
            break;
        }
        state.counters["wall/drawing"] = std::stod(said.substr(before + 4));
    }
    std::filesystem::remove_all(folder);
}
// Every tenth frame: 12 of the 120, from separate spheres to one body and back.
BENCHMARK(render_to_png)->Arg(10)->Iterations(1)->Repetitions(3)->Unit(benchmark::kSecond);

void frame_time_and_memory(benchmark::State& state) {
    const auto context = gpu::Context::create();
    const scene::Scene scene = scene::load("blobby75", {"look=none", "output.size=[64,64]"});
    render::Renderer renderer(*context, scene, {64, 64, {}, {}});
    renderer.draw(scene::at_frame(scene, 1)); // the driver makes its code here
    for (auto _ : state) {
        constexpr int frames = 1000;
        std::array<double, 10> tenths{};
        double memory = 0;
        for (int k = 0; k < frames; ++k) {
            // The same 50 frames over and over: only how many came before differs.
            const scene::SceneAt now = scene::at_frame(scene, 1 + k % 50);
            tenths[std::size_t(k / 100)] += renderer.draw(now).drawing.count();
            if (k == 99) memory = resident_megabytes();
        }
        state.counters["last/first"] = tenths.back() / tenths.front();
        state.counters["growth_MB"] = resident_megabytes() - memory;
    }
}
BENCHMARK(frame_time_and_memory)->Iterations(1)->Unit(benchmark::kSecond);

// A formula of about `nodes` operations, different for every seed.
std::string long_formula(int nodes, unsigned seed) {
    std::mt19937 random(seed);
    std::string text = "x^2 + y^2 + z^2 - 1";
    for (int count = 8; count < nodes; count += 10) {
        const auto number = [&] { return 0.001 * (1 + int(random() % 997)); };
        const char axis = "xyz"[random() % 3], other = "xyz"[random() % 3];
        text += random() % 4 == 0
                    ? fmt::format(" + {}*sin({}*{} + {}*{})*cos({}*{})", 1e-3 * number(), number(),
                                  axis, number(), other, number(), other)
                    : fmt::format(" + {}*({}*{} + {})^3*({} - {}*{})", 1e-3 * number(), number(),
                                  axis, number(), number(), number(), other);
    }
    return text;
}

void first_frame(benchmark::State& state, const scene::Scene& scene) {
    const auto context = gpu::Context::create();
    for (auto _ : state) {
        const auto begin = Clock::now();
        render::Renderer renderer(*context, scene, {32, 32, {}, {}});
        const scene::SceneAt now = scene::at_frame(scene, 1);
        renderer.draw(now);
        const double cold = seconds_since(begin);
        const auto again = Clock::now();
        renderer.draw(now);
        state.SetIterationTime(cold - seconds_since(again));
    }
    state.counters["nodes"] = double(scene.surfaces[0].field->value.registers);
}

void first_frame_of_blobby75(benchmark::State& state) {
    first_frame(state, scene::load("blobby75", {"look=none", "output.size=[32,32]"}));
}
BENCHMARK(first_frame_of_blobby75)->UseManualTime()->Iterations(3)->Unit(benchmark::kSecond);

// A formula of 2,000 nodes, as many of them calls of one kernel as can be.
std::string formula_of(const std::string& kernel) {
    std::string text = "x^2 + y^2 + z^2 - 1";
    const int calls = kernel == "pow" ? 285 : 400; // with the 7 or 5 nodes each of them takes
    for (int k = 1; k <= calls; ++k) {
        text += kernel == "pow"
                    ? fmt::format(" + 1e-5*pow(abs({0}*x + y), 1.5 + 0.{1:03}*z^2)", k, k)
                    : fmt::format(" + 1e-5*{}(0.{:03}*x + y)", kernel, k);
    }
    return text;
}

void first_frame_of(benchmark::State& state, const std::string& formula) {
    const auto file =
        std::filesystem::temp_directory_path() / fmt::format("isomotion-long-{}.toml", getpid());
    std::ofstream(file) << "[surface]\nformula = \"" << formula
                        << "\"\nbounds = { sphere = 1.5 }\n[output]\nsize = [32, 32]\n";
    const scene::Scene scene = scene::load(file.string());
    std::filesystem::remove(file);
    first_frame(state, scene);
}
void first_frame_of_2000_nodes(benchmark::State& state) {
    first_frame_of(state, long_formula(2000, unsigned(state.range(0))));
}
BENCHMARK(first_frame_of_2000_nodes)
    ->Arg(1)
    ->Arg(2)
    ->UseManualTime()
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

void first_frame_of_2000_nodes_of_one_kernel(benchmark::State& state, const char* kernel) {
    first_frame_of(state, formula_of(kernel));
}
BENCHMARK_CAPTURE(first_frame_of_2000_nodes_of_one_kernel, exp, "exp")
    ->UseManualTime()
    ->Iterations(1)
    ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(first_frame_of_2000_nodes_of_one_kernel, sin, "sin")
    ->UseManualTime()
    ->Iterations(1)
    ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(first_frame_of_2000_nodes_of_one_kernel, acos, "acos")
    ->UseManualTime()
    ->Iterations(1)
    ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(first_frame_of_2000_nodes_of_one_kernel, pow, "pow")
    ->UseManualTime()
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

} // namespace

int main(int argc, char** argv) {
    // A cached shader would hide what compiling costs.
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
