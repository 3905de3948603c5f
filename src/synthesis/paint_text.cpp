#include "synthesis/paint_text.h"

#include "formula/hessian.h"
#include "synthesis/shader_text.h"

namespace isomotion::synthesis {
namespace {

const char* file_of(scene::ColorMap map) {
    return map == scene::ColorMap::blue_yellow ? "effects/blue_yellow.glsl"
                                               : "effects/blue_orange.glsl";
}

} // namespace

std::vector<GeneratedFunction> paint_functions(const formula::Paint& paint,
                                               const formula::Field& field) {
    std::vector<GeneratedFunction> functions;
    if (paint.hessian) {
        functions.push_back({"second derivatives", formula::kernels_used(*paint.hessian),
                             formula::glsl_hessian(*paint.hessian, field.packing)});
    }
    functions.push_back({paint.text, formula::kernels_used(paint.value),
                         formula::glsl_paint_value(paint, field.packing)});
    return functions;
}

void add_paint(ShaderText& text, const scene::Paint& paint) {
    text.file(paint.value->hessian ? "effects/curvature.glsl" : "effects/no_curvature.glsl");
    text.file("effects/oklab.glsl");
    text.file(file_of(paint.map));
    text.file("effects/paint.glsl");
}

} // namespace isomotion::synthesis
