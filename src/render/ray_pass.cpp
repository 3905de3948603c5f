#include "render/ray_pass.h"

#include "gpu/compute.h"

namespace isomotion::render {

gpu::Program ray_program(const synthesis::Shaders& shaders, const std::string& text,
                         const char* label) {
    return shaders.stage == synthesis::Stage::compute ? gpu::Program::compute(text, label)
                                                      : gpu::Program(shaders.vertex, text, label);
}

void run_ray_pass(synthesis::Stage stage, const gpu::Program& program, const gpu::Target& into,
                  int width, int height, const gpu::Fullscreen& triangle) {
    if (stage == synthesis::Stage::fragment) {
        into.bind();
        gpu::set_viewport({0, 0, width, height});
        program.use();
        triangle.draw();
        return;
    }
    for (int k = 0; k < into.attachments(); ++k) gpu::bind_image(into.texture(k), k);
    const glm::ivec2 size(width, height);
    program.set("tile_size", size);
    program.use();
    gpu::dispatch((size + synthesis::workgroup_side - 1) / synthesis::workgroup_side);
}

} // namespace isomotion::render
