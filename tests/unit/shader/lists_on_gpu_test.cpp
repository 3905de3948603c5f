// What proofs are told where a list leaves elements out: F with any sum that these may have.
#include <array>

#include <gtest/gtest.h>

#include "gpu/buffer.h"
#include "scenes.h"
#include "shader/field_text.h"
#include "shader/shader_text.h"
#include "unit/gpu/every_backend.h"

namespace isomotion::shader {
namespace {

// The bounds of F and of its slope along x at a place, none of the elements in the list.
std::array<glm::dvec2, 2> without_elements(const scene::Scene& scene, glm::vec3 p) {
    use_shaders_of_source_tree();
    const formula::Field& field = *scene.surfaces[0].field;
    const FieldStorage storage = field_storage(field, scene.surfaces[0].parameters,
                                               scene.surfaces[0].animation.counts(), {true, {}});
    ShaderText text;
    add_enclosures(text, field, storage,
                   {FieldFunction::value_interval, FieldFunction::directional_interval});
    text.generated("bounds of F and its slope", R"(
uniform vec4 place;
layout(location = 0) out vec4 bounds;
void main() {
    vec2 x = place.xx, y = place.yy, z = place.zz;
    enter_list_of_proof(vec2(0.0), x, y, z);
    vec4 f = field_directional_interval(x, y, z, vec2(1.0), vec2(0.0), vec2(0.0));
    bounds = vec4(field_interval(x, y, z), f.zw);
}
)");
    const gpu::Program program(gpu::fullscreen_vertex, text.text(), "lists");
    const gpu::UniformBuffer parameters(std::size_t(16 * storage.vectors()));
    parameters.bind(0);
    program.bind_block("Parameters", 0);
    program.set("place", glm::vec4(p, 0));
    const gpu::Target target(1, 1, 1);
    target.bind();
    program.use();
    gpu::Fullscreen().draw();
    const auto read = target.read(0, 0, 0, 1, 1);
    return {glm::dvec2(read[0], read[1]), glm::dvec2(read[2], read[3])};
}

class Lists : public gpu::EveryBackend {};
ISOMOTION_ON_EVERY_BACKEND(Lists);

// At a root the sum is -R/c. Each of three lists leaves up to 6.25e-7 of that out. What a block
// proved by its own list is taken on by its rays, by another: three times as much.
TEST_P(Lists, TellOfFWithAllThatTheyLeaveOut) {
    const scene::Scene scene = scene_of(
        "[surface]\nformula = '(2 + x)*sum(p, exp(-20*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))) - 3 - y'\n"
        "bounds = { sphere = 2 }\n[arrays.p]\ncount = 12\ncx = 'random(i, 0)'\n"
        "cy = 'random(i, 1)'\ncz = 'random(i, 2)'\n");
    for (const glm::vec3 p :
         {glm::vec3(0), glm::vec3(0.75f, -0.5f, 0.25f), glm::vec3(-1.5f, 1, 0)}) {
        const double rest = -3 - double(p.y), factor = 2 + double(p.x);
        const double most = 9 * 6.25e-7 * std::abs(rest) / factor; // of the sum
        const auto bounds = without_elements(scene, p);
        for (const double sum : {-most, 0.0, most}) {
            const double f = factor * sum + rest;
            EXPECT_LE(bounds[0].x, f);
            EXPECT_GE(bounds[0].y, f);
            EXPECT_LE(bounds[1].x, sum);
            EXPECT_GE(bounds[1].y, sum);
        }
        EXPECT_LT(bounds[0].y - bounds[0].x, 4 * most * factor);
    }
}

} // namespace
} // namespace isomotion::shader
