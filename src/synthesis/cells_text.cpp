#include "synthesis/cells_text.h"

#include <stdexcept>

#include <fmt/format.h>

#include "formula/glsl/glsl.h"
#include "synthesis/shader_text.h"

namespace isomotion::synthesis {
namespace {

// What each function over a box is called; its file makes the hull.
struct OverCells {
    FieldFunction function;
    const char* name;
    const char* file;
};

constexpr OverCells over_cells[] = {
    {FieldFunction::value_interval, "field_interval", "elements/value_interval.glsl"},
    {FieldFunction::directional_interval, "field_directional_interval",
     "elements/directional_interval.glsl"},
    {FieldFunction::rough, "field_rough", "elements/rough.glsl"},
    {FieldFunction::breaks, "field_breaks", "elements/breaks.glsl"},
};

const OverCells* of_boxes(FieldFunction function) {
    for (const OverCells& entry : over_cells) {
        if (entry.function == function) return &entry;
    }
    return nullptr;
}

} // namespace

void add_cells(ShaderText& text, const FieldStorage& storage) {
    text.file("elements/cells.glsl");
    const ArrayStorage& array = storage.arrays[std::size_t(*array_with_grid(storage))];
    text.generated("generated: an element of the list entered last",
                   fmt::format("vec4 {0}_texel(int element, int texel) {{ return texelFetch({0}, "
                               "listed_element(element) * {1} + texel); }}\n",
                               array.name, array.texels));
}

std::string entering_cells(std::string glsl) {
    const auto place = glsl.find("(vec3 p");
    const auto begin = place == glsl.npos ? place : glsl.find("{\n", place);
    if (begin == glsl.npos) throw std::logic_error("no function of a place: " + glsl);
    return glsl.insert(begin + 2, "    enter_cell(cell_of(p));\n");
}

std::string over_all_elements(const FieldStorage& storage, const std::string& glsl) {
    const auto a = std::size_t(*array_with_grid(storage));
    const ArrayStorage& array = storage.arrays[a];
    return fmt::format("int all_count = array_counts[{2}].{3};\n"
                       "vec4 all_texel(int element, int texel) {{ return texelFetch({0}, element * "
                       "{1} + texel); }}\n"
                       "#define {0}_count all_count\n#define {0}_texel all_texel\n"
                       "#undef {0}_least\n#define {0}_least {5}\n{4}"
                       "#undef {0}_count\n#undef {0}_texel\n#undef {0}_least\n"
                       "#define {0}_least GRID_LEAST\n",
                       array.name, array.texels, a / 4, "xyzw"[a % 4], glsl,
                       formula::glsl_least_of_none());
}

std::string in_cells(FieldFunction function, const std::string& glsl) {
    const OverCells* over = of_boxes(function);
    if (!over) return entering_cells(glsl);
    return fmt::format("#define {0} {0}_in_cell\n{1}#undef {0}\n", over->name, glsl);
}

void add_hull_over_cells(ShaderText& text, FieldFunction function) {
    if (const OverCells* over = of_boxes(function)) text.file(over->file);
}

void add_way_past_free_cells(ShaderText& text) {
    text.define("PASSES_FREE", 1);
    text.file("elements/pass_free.glsl");
}

} // namespace isomotion::synthesis
