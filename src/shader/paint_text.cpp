#include "shader/paint_text.h"

#include "formula/contours.h"
#include "formula/element_weights.h"
#include "formula/hessian.h"
#include "shader/shader_text.h"

namespace isomotion::shader {
namespace {

const char* file_of(scene::ColorMap map) {
    return map == scene::ColorMap::blue_yellow ? "effects/blue_yellow.glsl"
                                               : "effects/blue_orange.glsl";
}

} // namespace

const formula::Paint* painting(const scene::OneSurface& one) {
    const scene::Material& material = one.surface.material;
    return material.paint ? material.paint->value.get() : material.color_by_place.get();
}

bool sums_all_elements(const formula::Paint& paint, const FieldStorage& storage) {
    const auto array = array_with_grid(storage);
    return array && !formula::weigh_like_field(paint.graph, paint.field, paint.roots, *array);
}

std::vector<GeneratedFunction> painting_functions(const scene::OneSurface& one,
                                                  const FieldStorage& storage) {
    const formula::Paint* paint = painting(one);
    const formula::ArrayPacking& packing = one.surface.field->packing;
    std::vector<GeneratedFunction> functions;
    if (const auto& contours = one.surface.material.contours) {
        const formula::Paint& value = *contours->value;
        functions.push_back({value.text, formula::kernels_used(value.value),
                             formula::glsl_contour_value(value, packing),
                             sums_all_elements(value, storage)});
    }
    if (!paint) return functions;
    if (paint->hessian) {
        functions.push_back({"second derivatives", formula::kernels_used(*paint->hessian),
                             formula::glsl_hessian(*paint->hessian, packing)});
    }
    functions.push_back({paint->text, formula::kernels_used(paint->value),
                         one.surface.material.paint ? formula::glsl_paint_value(*paint, packing)
                                                    : formula::glsl_color_value(*paint, packing),
                         sums_all_elements(*paint, storage)});
    return functions;
}

void add_painting(ShaderText& text, const scene::OneSurface& one) {
    const scene::Material& material = one.surface.material;
    text.file(painting(one)->hessian ? "effects/curvature.glsl" : "effects/no_curvature.glsl");
    if (material.paint) {
        text.file("effects/oklab.glsl");
        text.file(file_of(material.paint->map));
        text.file("effects/paint.glsl");
    } else {
        text.file("effects/color_by_place.glsl");
        text.file(material.inside ? "effects/front_by_place.glsl" : "effects/sides_by_place.glsl");
    }
}

} // namespace isomotion::shader
