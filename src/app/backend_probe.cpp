#include "app/backend_probe.h"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/child_process.h"
#include "gpu/compute.h"
#include "gpu/error.h"
#include "gpu/program.h"
#include "gpu/target.h"
#include "render/arithmetic.h"
#include "render/arithmetic_speed.h"
#include "render/stage.h"

namespace isomotion::app {
namespace {

using Json = nlohmann::ordered_json;

// Runs a compute shader that stores into a texture; throws where that does not work.
void store_a_pixel(const gpu::ContextInfo& info) {
    gpu::expect_compute(info, "--stage compute");
    const gpu::Program program = gpu::Program::compute(
        "#version 430 core\n"
        "layout(local_size_x = 1) in;\n"
        "layout(rgba32f, binding = 0) writeonly uniform image2D stored;\n"
        "void main() { imageStore(stored, ivec2(0), vec4(1.0, 2.0, 3.0, 4.0)); }\n",
        "doctor");
    const gpu::Target target(1, 1);
    gpu::bind_image(target.texture(0), 0);
    program.use();
    gpu::dispatch({1, 1});
    if (target.read(0, 0, 0, 1, 1) != std::vector<float>{1, 2, 3, 4}) {
        throw gpu::ResourceError("--stage compute: what a shader stores is not what is read");
    }
}

Json compute_of(const gpu::ContextInfo& info) {
    try {
        store_a_pixel(info);
        const auto stage = render::choose_stage(render::StageChoice::automatic, info);
        return {{"works", true}, {"automatic_stage", render::name(stage)}};
    } catch (const std::runtime_error& error) {
        return {{"works", false}, {"reason", error.what()}};
    }
}

// JSON has no infinity.
Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json arithmetic() {
    Json all = {{"behaviours", Json::array()}, {"errors", Json::array()}};
    try {
        for (const render::Behaviour& behaviour : render::behaviours()) {
            all["behaviours"].push_back({{"what", behaviour.what},
                                         {"found", behaviour.found},
                                         {"ieee", behaviour.is_ieee}});
        }
        for (const render::FunctionError& error : render::function_errors()) {
            all["errors"].push_back({{"function", error.function},
                                     {"from", error.low},
                                     {"to", error.high},
                                     {"driver", finite(error.of_driver)},
                                     {"driver_at", error.driver_at},
                                     {"own", finite(error.of_kernel)}});
        }
    } catch (const std::exception& error) { // no shaders/, a compiler that refuses
        all["reason"] = error.what();
    }
    return all;
}

Json failed(gpu::Backend backend, const std::string& reason) {
    return {{"name", gpu::name(backend)}, {"works", false}, {"reason", reason}};
}

std::string how_it_ended(const base::ChildProcess& child, bool in_time,
                         std::chrono::seconds longest) {
    if (!in_time)
        return fmt::format("no answer within {} s; the process was killed", longest.count());
    std::string ending = child.ending();
    int number = 0;
    if (std::sscanf(ending.c_str(), "signal %d", &number) == 1) {
        ending += fmt::format(" ({})", ::strsignal(number));
    }
    const std::string words = child.last_words(1);
    return fmt::format("the driver ended its process: {}{}{}", ending, words.empty() ? "" : "; ",
                       words);
}

// Drivers may write to the standard output, too; the answer is its last line.
Json answer_of(const std::string& output) {
    const std::size_t end = output.find_last_not_of('\n');
    const std::size_t begin = end == std::string::npos ? end : output.rfind('\n', end);
    return Json::parse(output.substr(begin == std::string::npos ? 0 : begin + 1), nullptr, false);
}

} // namespace

Json probe_here(gpu::Backend backend) {
    try {
        const auto context = gpu::Context::create(backend);
        const gpu::ContextInfo& info = context->info();
        const render::ArithmeticSpeed speed = render::arithmetic_speed(info);
        return {{"name", gpu::name(backend)},
                {"works", true},
                {"backend", info.backend},
                {"vendor", info.vendor},
                {"renderer", info.renderer},
                {"opengl", info.version},
                {"glsl", info.glsl_version},
                {"software", info.software},
                {"limits",
                 {{"texture_size", info.max_texture_size},
                  {"uniform_block_bytes", info.max_uniform_block_size},
                  {"texture_buffer_texels", info.max_texture_buffer_size},
                  {"storage_block_bytes", info.max_storage_block_size}}},
                {"operations_a_second",
                 {{"fragment", speed.in_fragments}, {"compute", speed.in_compute}}},
                {"compute", compute_of(info)},
                {"arithmetic", arithmetic()}};
    } catch (const std::exception& error) {
        return failed(backend, error.what());
    }
}

std::vector<Json> probe_apart(const std::vector<gpu::Backend>& backends,
                              std::chrono::seconds longest) {
    const auto program = std::filesystem::read_symlink("/proc/self/exe");
    const auto deadline = std::chrono::steady_clock::now() + longest;
    std::vector<std::unique_ptr<base::ChildProcess>> children;
    for (const gpu::Backend backend : backends) {
        const std::vector<std::string> words{"doctor", "--probe", std::string(gpu::name(backend))};
        children.push_back(
            std::make_unique<base::ChildProcess>(program, words, base::Output::keep));
    }
    std::vector<Json> found;
    for (std::size_t k = 0; k < backends.size(); ++k) {
        base::ChildProcess& child = *children[k];
        const bool in_time = child.finish_by(deadline);
        const Json answer = child.succeeded() ? answer_of(child.output()) : Json();
        found.push_back(answer.is_object()
                            ? answer
                            : failed(backends[k], how_it_ended(child, in_time, longest)));
    }
    return found;
}

} // namespace isomotion::app
