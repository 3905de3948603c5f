#include <set>

#include <fmt/format.h>

#include "api/scene/errors.h"
#include "api/scene/formula_parts.h"
#include "isomotion/drawing.h"
#include "shader/shader_files.h"

namespace isomotion {

std::string glsl_of(const Formula& formula) {
    return api::with_errors([&] {
        const formula::Field& field = *formula.parts().field;
        std::string text = shader::read_shader("prelude.glsl");
        if (const std::size_t count = formula.parameters().size(); count > 0)
            text += fmt::format("uniform vec4 parameters[{}];\n", (count + 3) / 4);
        std::set<std::string> kernels = formula::kernels_used(field.value);
        kernels.merge(formula::kernels_used(field.gradient));
        for (const std::string& file : shader::kernel_files(kernels))
            text += shader::read_shader(file);
        return text + formula::glsl_value(field) + formula::glsl_gradient(field);
    });
}

} // namespace isomotion
