#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/commands.h"
#include "gpu/compute.h"
#include "gpu/context.h"
#include "gpu/error.h"
#include "gpu/program.h"
#include "gpu/target.h"
#include "render/stage.h"
#include "scene/data_folder.h"

namespace isomotion::app {
namespace {

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

void examine_compute(const gpu::ContextInfo& info) {
    try {
        store_a_pixel(info);
        fmt::print("         compute shaders work; --stage auto: {}\n",
                   render::name(render::choose_stage(render::StageChoice::automatic, info)));
    } catch (const std::runtime_error& error) {
        fmt::print("         {}\n", error.what());
    }
}

bool examine(gpu::Backend backend) {
    try {
        const auto context = gpu::Context::create(backend);
        const gpu::ContextInfo& info = context->info();
        fmt::print("{:<8} works: {}\n", gpu::name(backend), info.backend);
        fmt::print("         {}, {}\n         OpenGL {}, GLSL {}\n", info.vendor, info.renderer,
                   info.version, info.glsl_version);
        fmt::print("         textures to {}, uniform blocks to {} bytes, texture buffers to {} "
                   "texels\n",
                   info.max_texture_size, info.max_uniform_block_size,
                   info.max_texture_buffer_size);
        examine_compute(info);
        return true;
    } catch (const gpu::Unavailable& error) {
        fmt::print("{:<8} does not work: {}\n", gpu::name(backend), error.what());
        return false;
    }
}

int doctor() {
    fmt::print("files    {}\n", scene::data_folder().string());
    const bool egl = examine(gpu::Backend::egl);
    const bool osmesa = examine(gpu::Backend::osmesa);
    const bool glfw = examine(gpu::Backend::glfw);
    return egl || osmesa || glfw ? exit_done : exit_machine;
}

} // namespace

void add_doctor(CLI::App& app, Action& chosen) {
    CLI::App* command = app.add_subcommand("doctor", "which ways to OpenGL work on this machine");
    command->callback([&chosen] { chosen = doctor; });
}

} // namespace isomotion::app
