#include "app/speed_probe.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/child_process.h"
#include "render/exposure.h"
#include "render/renderer.h"
#include "scene/reading/load.h"

namespace isomotion::app {
namespace {

using Json = nlohmann::ordered_json;
using Milliseconds = std::chrono::duration<double, std::milli>;

constexpr const char* scene_name = "blobby75";
constexpr int side = 256;
constexpr double frames_a_second = 30; // that playing aims at
constexpr double largest_window = 2000;

} // namespace

Json measure_speed_here(gpu::Backend backend) {
    try {
        const auto context = gpu::Context::create(backend);
        const scene::Scene scene = scene::load(scene_name, {"look=none"});
        render::Renderer renderer(*context, scene, {side, side, {}, {}});
        render::expose(renderer, scene, 1); // drivers make their code at the first draw
        Milliseconds all{};
        const int count = 4;
        for (int k = 0; k < count; ++k) {
            const int frame = 1 + k * scene.timeline.frames / count;
            all += render::expose(renderer, scene, frame).drawing;
        }
        return {{"scene", scene_name}, {"size", side}, {"frame_ms", all.count() / count}};
    } catch (const std::exception& error) {
        return {{"reason", error.what()}};
    }
}

Json measure_speed_apart(gpu::Backend backend, std::chrono::seconds longest) {
    const auto program = std::filesystem::read_symlink("/proc/self/exe");
    base::ChildProcess child(program, {"doctor", "--speed", std::string(gpu::name(backend))},
                             base::Output::keep);
    if (!child.finish_by(std::chrono::steady_clock::now() + longest) || !child.succeeded())
        return {{"reason", "the driver draws no picture: " + child.ending()}};
    // Drivers may write to the standard output, too; the answer is its last line.
    const std::string output = child.output();
    const std::size_t end = output.find_last_not_of('\n');
    const std::size_t begin = end == output.npos ? end : output.rfind('\n', end);
    const Json answer =
        Json::parse(output.substr(begin == output.npos ? 0 : begin + 1), nullptr, false);
    return answer.is_object() ? answer : Json{{"reason", "the driver draws no picture"}};
}

std::string expectation(const Json& report) {
    if (!report.contains("speed") || !report["speed"].contains("frame_ms")) return "";
    const Json& speed = report["speed"];
    const double ms = std::max(speed["frame_ms"].get<double>(), 1e-3);
    const int size = speed["size"].get<int>();
    // Time grows with the pixels.
    const double played = std::min(largest_window, size * std::sqrt(1000 / frames_a_second / ms));
    const double rounded = std::max(10.0, std::round(played / 10) * 10);
    const auto processors = report["processors"].get<unsigned>();
    const std::string machine =
        speed.value("software", true)
            ? fmt::format("software renderer, {} core{}", processors, processors == 1 ? "" : "s")
            : "graphics card";
    const std::string rate = fmt::format("{:.{}f}", 1000 / ms, ms > 100 ? 1 : 0);
    return fmt::format("{0}: {1} renders {2} frames a second at {3}x{3}, and plays at about "
                       "{4:.0f} "
                       "pixels{5}",
                       machine, speed["scene"].get<std::string>(), rate, size, rounded,
                       played == largest_window ? " or more" : "");
}

} // namespace isomotion::app
