#include "shader/model_text.h"

#include "formula/glsl/glsl_model.h"
#include "shader/march_text.h"

namespace isomotion::shader {

void add_models(ShaderText& text, const formula::Field& field, const std::string& type,
                const std::string& file, formula::Numbers numbers) {
    text.file("models/errors.glsl");
    text.file(file);
    text.file_again("models/operations.glsl");
    text.generated("generated: F on models", formula::glsl_value_model(field, type, numbers));
}

void add_piece_models(ShaderText& text, const formula::Field& field, const std::string& file,
                      formula::Numbers numbers) {
    add_models(text, field, "Model", file, numbers);
}

void add_inside_bounds(ShaderText& text, const scene::OneSurface& one) {
    define_bounds(text, one);
    text.file("models/inside_bounds.glsl");
}

} // namespace isomotion::shader
