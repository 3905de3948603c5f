#include "shader/paint_text.h"

#include "formula/contours.h"
#include "formula/element_weights.h"
#include "formula/hessian.h"
#include "shader/shader_text.h"

namespace isomotion::shader {

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
    if (painting(one)->hessian) text.define(Feature::curvature);
    text.define(material.paint ? Feature::paint : Feature::color_by_place);
    if (material.paint && material.paint->map == scene::ColorMap::blue_yellow)
        text.define(Feature::blue_yellow);
    if (material.paint) text.file("effects/color_map.glsl");
    text.file("effects/curvature.glsl");
    text.file("effects/paint.glsl");
}

} // namespace isomotion::shader
