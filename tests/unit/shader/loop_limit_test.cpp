// Loops within a call of the field count against the driver's limit for a shader: the iterations
// that cost() tells are enough for a whole march of boxes over many cells of noise.
#include "shader/loop_limit.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "gpu/buffer.h"
#include "shader/field_text.h"
#include "shader/shader_text.h"
#include "unit/gpu/every_backend.h"

namespace isomotion::shader {
namespace {

class LoopLimit : public gpu::EveryBackend {};
ISOMOTION_ON_EVERY_BACKEND(LoopLimit);

TEST_P(LoopLimit, HoldsTheTurnsOfNoiseBounds) {
    for (const char* formula : {"noise(x, y, z)", "noise(x, y, z)*noise(y + 0.5, z, x)"}) {
        const formula::Field field = formula::make_field(formula, {});
        const FieldStorage storage = field_storage(field, 0, {});
        const std::vector functions{FieldFunction::value_interval,
                                    FieldFunction::directional_interval};
        const formula::Cost cost = shader::cost(field, storage, functions, {});
        const int planned = int(loop_iterations_per_pass / (1 + cost.iterations));
        ASSERT_GT(planned, 50) << formula;

        ShaderText text;
        add_field(text, field, storage, functions);
        text.generated("each evaluation over two cells along each axis", R"(
uniform int planned;
layout(location = 0) out vec4 result;

void main() {
    int turns = 0;
    vec2 all = vec2(0.0);
    vec2 d = vec2(0.5, 1.0);
    for (; turns < planned; ++turns) {
        vec2 x = float(turns) + vec2(0.75, 1.25);
        all += field_interval(x, vec2(0.75, 1.25), vec2(0.75, 1.25));
        all += field_directional_interval(x, vec2(0.75, 1.25), vec2(0.75, 1.25), d, d, d).xy;
    }
    result = vec4(float(turns), all, 1.0);
}
)");
        const gpu::Program program(gpu::fullscreen_vertex, text.text(), "turns");
        const gpu::UniformBuffer parameters(std::size_t(storage.vectors()) * 16);
        parameters.bind(0);
        program.bind_block("Parameters", 0);
        program.set("planned", planned);
        const gpu::Target target(1, 1);
        target.bind();
        program.use();
        gpu::Fullscreen().draw();
        EXPECT_EQ(target.read(0, 0, 0, 1, 1)[0], float(planned)) << formula;
    }
}

} // namespace
} // namespace isomotion::shader
