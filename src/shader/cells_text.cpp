#include "shader/cells_text.h"

#include <stdexcept>

#include <fmt/format.h>

#include "formula/glsl/glsl.h"
#include "shader/shader_code.h"
#include "shader/shader_text.h"

namespace isomotion::shader {
namespace {

// A function over a box, and what it makes: a result, or what it assigns to.
struct OverBox {
    FieldFunction function;
    const char* name;
    const char* result;
    std::vector<std::string> outputs{};
    bool is_directed = false;
};

const std::vector<OverBox>& functions_over_boxes() {
    static const std::vector<OverBox> all{
        {FieldFunction::value_interval, "field_interval", "REAL2"},
        {FieldFunction::directional_interval, "field_directional_interval", "REAL4", {}, true},
        {FieldFunction::gradient_interval, "field_gradient_interval", "", {"gx", "gy", "gz"}},
        {FieldFunction::rough, "field_rough", "REAL4"},
        {FieldFunction::breaks, "field_breaks", "REAL4"},
    };
    return all;
}

const OverBox* over_box(FieldFunction function) {
    for (const OverBox& entry : functions_over_boxes()) {
        if (entry.function == function) return &entry;
    }
    return nullptr;
}

// The hull of what a function makes over the box's parts in its cells.
std::string hull_over_cells(const OverBox& of) {
    const bool returns = of.outputs.empty();
    const std::vector<std::string> made = returns ? std::vector<std::string>{"all"} : of.outputs;
    const std::string type = returns ? of.result : "REAL2";
    std::string more = of.is_directed ? ", REAL2 dx, REAL2 dy, REAL2 dz" : "";
    for (const std::string& output : of.outputs) more += ", out REAL2 " + output;
    std::string text = fmt::format("{} {}(REAL2 x, REAL2 y, REAL2 z{}) {{\n"
                                   "    CellRange range = cells_of_box(x, y, z);\n",
                                   returns ? of.result : "void", of.name, more);
    const auto whole = [&](const std::string& numbers) {
        return type == "REAL4" ? fmt::format("REAL4({0}, {0})", numbers) : numbers;
    };
    for (const std::string& output : made) {
        text += fmt::format("    {}{} = range.too_many ? {} : {};\n", returns ? type + " " : "",
                            output, whole("ALL_NUMBERS"), whole("NO_NUMBERS"));
    }
    text += "    for (ivec3 at = range.first; !range.too_many && at.z <= range.last.z; "
            "at = next_cell(range, at)) {\n"
            "        enter_cell(at);\n"
            "        REAL2 bx = x, by = y, bz = z;\n"
            "        box_in_cell(range, at, bx, by, bz);\n";
    const std::string call =
        fmt::format("{}_in_cell(bx, by, bz{}", of.name, of.is_directed ? ", dx, dy, dz" : "");
    if (returns) {
        text += fmt::format("        all = hull_of(all, {}));\n", call);
    } else {
        std::string there;
        for (const std::string& output : made) there += ", " + output + "_there";
        text += fmt::format("        REAL2 {};\n        {}{});\n", there.substr(2), call, there);
        for (const std::string& output : made)
            text += fmt::format("        {0} = hull_of({0}, {0}_there);\n", output);
    }
    return text + "    }\n" + (returns ? "    return all;\n" : "") + "}\n";
}

} // namespace

void add_cells(ShaderText& text, const FieldStorage& storage, int by_place) {
    text.file("elements/cells.glsl");
    const ArrayStorage& array = storage.arrays[std::size_t(by_place)];
    text.generated("generated: an element of the list entered last",
                   fmt::format("vec4 {0}_texel(int element, int texel) {{ int at = "
                               "listed_element(element) * {1} + texel; return IM_BUFFER_AT({0}, "
                               "at); }}\n",
                               array.name, array.texels));
}

std::string entering_cells(std::string glsl) {
    const auto place = glsl.find("(vec3 p");
    const auto begin = place == glsl.npos ? place : glsl.find("{\n", place);
    if (begin == glsl.npos) throw std::logic_error("no function of a place: " + glsl);
    return glsl.insert(begin + 2, "    enter_cell(cell_of(p));\n");
}

std::string over_all_elements(const FieldStorage& storage, int by_place, const std::string& glsl) {
    const auto a = std::size_t(by_place);
    const ArrayStorage& array = storage.arrays[a];
    // A copy, but in GLSL ES, where globals begin with constants.
    return fmt::format(
               "#ifdef GL_ES\n#define all_count array_counts[{2}].{3}\n#else\n"
               "int all_count = array_counts[{2}].{3};\n#endif\n"
               "vec4 all_texel(int element, int texel) {{ return IM_BUFFER_AT({0}, element * "
               "{1} + texel); }}\n",
               array.name, array.texels, a / 4, "xyzw"[a % 4]) +
           replaced(glsl, {{array.name + "_count", "all_count"},
                           {array.name + "_texel", "all_texel"},
                           {array.name + "_least", formula::glsl_least_of_none()}});
}

std::string in_cells(FieldFunction function, const std::string& glsl) {
    const OverBox* over = over_box(function);
    if (!over) return entering_cells(glsl);
    return replaced(glsl, {{over->name, fmt::format("{}_in_cell", over->name)}});
}

void add_hulls_over_cells(ShaderText& text, const std::vector<FieldFunction>& functions) {
    text.file("elements/cells_of_box.glsl");
    std::string hulls;
    for (const FieldFunction function : functions) {
        if (const OverBox* over = over_box(function)) hulls += hull_over_cells(*over);
    }
    text.generated("generated: over all cells of a box", hulls);
}

} // namespace isomotion::shader
