#include "render/velocity_pass.h"

#include <glm/gtc/type_ptr.hpp>

#include "shader/section_text.h"

namespace isomotion::render {

std::vector<float> VelocityPass::field_there(PassTable& table, const gpu::Rectangle& tile,
                                             const scene::PlacementAt& from,
                                             const scene::OneSurfaceAt& to) const {
    const auto rows = change_of_place(from, to.surface.placement);
    const gpu::Program& program = table.program(shader::Role::motion);
    program.set("move_x", rows[0]);
    program.set("move_y", rows[1]);
    program.set("move_z", rows[2]);
    if (!to.scene.sections.empty()) {
        const shader::Uniform there = shader::sections_uniform(to);
        program.set(there.name,
                    std::span<const glm::vec4>(std::get<std::vector<glm::vec4>>(there.value)));
    }
    table.draw(program, tile, field_);
    return field_.read(0, 0, 0, tile.width, tile.height);
}

std::vector<glm::dvec3> velocities(const SurfaceMotion& motion, int width, int height,
                                   const gpu::Rectangle& tile, const Record& record,
                                   std::span<const float> rays, std::span<const float> before,
                                   std::span<const float> after) {
    const scene::Rays from = scene::rays(motion.now, width, height);
    std::vector<glm::dvec3> found(before.size() / 4, glm::dvec3(0));
    for (std::size_t at = 0; at < found.size(); ++at) {
        if (Verdict(record.verdict(at)) != Verdict::hit) continue;
        const glm::ivec2 pixel(tile.x + int(at) % tile.width, tile.y + int(at) / tile.width);
        found[at] = velocity(motion, width, height,
                             place_on_ray(from, pixel, width, height, double(rays[4 * at])),
                             glm::dvec4(glm::make_vec4(&before[4 * at])),
                             glm::dvec4(glm::make_vec4(&after[4 * at])));
    }
    return found;
}

} // namespace isomotion::render
