#include "formula/contours.h"

#include <array>

#include <fmt/format.h>

#include "formula/graph/derivative.h"
#include "formula/graph/lowering.h"
#include "formula/graph/parser.h"

namespace isomotion::formula {

Paint make_contours(std::string_view text, const Vocabulary& surface, const Field& field) {
    Paint contours = make_paint(text, surface, field);
    for (const char* name :
         {"nx", "ny", "nz", "mean_curvature", "gaussian_curvature", "evaluations"}) {
        if (!contours.uses(name)) continue;
        throw ParseError(text, text.find(name),
                         fmt::format("lines are of a number of the place, of x, y, z, t and "
                                     "parameters; '{}' is none",
                                     name));
    }
    Graph& g = contours.graph;
    const NodeId number = contours.roots.front();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::vector<NodeId> directions(paint_names.size(), g.constant(0));
        directions[axis] = g.constant(1);
        contours.roots.push_back(differentiate_inputs(g, number, directions));
    }
    Graph working = g;
    contours.value = schedule(working, lower(working, contours.roots));
    return contours;
}

std::string glsl_contour_value(const Paint& contours, const ArrayPacking& packing) {
    // The names that are refused are never read.
    GlslSignature signature{"vec4 contour_value(vec3 p)", "vec4", {"p.x", "p.y", "p.z"}};
    signature.inputs.resize(paint_names.size(), "0.0");
    signature.inputs.back() = "contour_time";
    return "uniform float contour_time;\n" + emit_glsl(contours.value, signature, packing);
}

} // namespace isomotion::formula
