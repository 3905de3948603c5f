#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/commands.h"
#include "gpu/context.h"
#include "scene/data_folder.h"

namespace isomotion::app {
namespace {

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
    return egl || osmesa ? exit_done : exit_machine;
}

} // namespace

void add_doctor(CLI::App& app, Action& chosen) {
    CLI::App* command = app.add_subcommand("doctor", "which ways to OpenGL work on this machine");
    command->callback([&chosen] { chosen = doctor; });
}

} // namespace isomotion::app
