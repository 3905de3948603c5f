#include "shader/field_text.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "formula/linear_sum.h"
#include "shader/cells_text.h"
#include "shader/loop_limit.h"
#include "shader/shader_files.h"
#include "shader/shader_text.h"
#include "shader/tape_text.h"

namespace isomotion::shader {
namespace {

// Globals of GLSL ES begin with constants: there the name is the value's other name.
std::string by_name_in_es(std::string_view name, std::string_view value,
                          std::string_view declaration) {
    return fmt::format("#ifdef GL_ES\n#define {} {}\n#else\n{}#endif\n", name, value, declaration);
}

// Reads elements of the list entered last: shaders/march/copies.glsl. They are sampled:
// texelFetch() takes a level for each pixel, and Mesa's processor renderer then looks up rows and
// offsets for each, which takes twice the time.
std::string declared_copies(const ArrayStorage& array) {
    const std::string row = array.texels == 1
                                ? "element >> 4"
                                : fmt::format("(element >> 4) * {} + texel", array.texels);
    return fmt::format("uniform sampler2D {0}_lists;\n"
                       "uniform vec2 list_texel; // of that texture, of size 1 x 1\n"
                       "#define LIST vec3\nint {0}_count = 0;\nvec2 {0}_first = vec2(0.0);\n"
                       "LIST entered_list() {{ return LIST({0}_count, {0}_first); }}\n"
                       "void enter_list(LIST list) {{ {0}_count = int(list.x); "
                       "{0}_first = list.yz; }}\n"
                       "vec4 {0}_texel(int element, int texel) {{ return textureLod({0}_lists, "
                       "{0}_first + list_texel * vec2(element & 15, {1}), 0.0); }}\n",
                       array.name, row);
}

std::string declarations(const FieldStorage& storage) {
    std::string text = "layout(std140) uniform Parameters {\n";
    text += fmt::format("    vec4 parameter_block[{}];\n", storage.parameter_vectors);
    if (storage.count_vectors > 0) {
        text += fmt::format("    ivec4 array_counts[{}];\n", storage.count_vectors);
    }
    const std::optional<int> by_place = array_with_grid(storage);
    if (by_place) text += fmt::format("    vec4 grid_block[{}];\n", grid_vectors(storage));
    if (storage.tapes) text += fmt::format("    vec4 tape_block[{}];\n", tape_vectors);
    text += "};\n";
    // Copies: software renderers read a block again at every use, in every turn of a loop.
    std::string copies;
    for (int k = 0; k < storage.parameter_vectors; ++k) {
        copies += fmt::format("{}parameter_block[{}]", k > 0 ? ", " : "", k);
    }
    text += by_name_in_es(
        "parameters", "parameter_block",
        fmt::format("vec4 parameters[{0}] = vec4[{0}]({1});\n", storage.parameter_vectors, copies));
    for (std::size_t a = 0; a < storage.arrays.size(); ++a) {
        const ArrayStorage& array = storage.arrays[a];
        if (array.has_grid) {
            text += fmt::format("uniform IM_BUFFER {0};\n#define GRID_COUNT {0}_count\n"
                                "#define {0}_least GRID_LEAST\n",
                                array.name);
            text += by_name_in_es(
                "array_grid", "grid_block",
                fmt::format("vec4 array_grid[{0}] = vec4[{0}](grid_block[0], grid_block[1], "
                            "grid_block[2]);\n",
                            grid_vectors_of_place));
            continue;
        }
        const std::string count = fmt::format("array_counts[{}].{}", a / 4, "xyzw"[a % 4]);
        text += fmt::format("#define {}_least {}\n", array.name, formula::glsl_least_of_none());
        if (array.reads_copies) {
            text += declared_copies(array);
            continue;
        }
        text += by_name_in_es(array.name + "_count", count,
                              fmt::format("int {}_count = {};\n", array.name, count));
        std::string element = "element";
        if (array.has_copies) {
            text += fmt::format("#define LIST vec3\n"
                                "LIST entered_list() {{ return LIST({}_count, ivec2(0)); }}\n"
                                "void enter_list(LIST list) {{}}\n",
                                array.name);
        }
        if (array.has_lists && !array.has_copies) {
            // Another list than all elements, once entered.
            text += fmt::format(
                "#define LIST vec2\nint {0}_first = 0;\n"
                "LIST entered_list() {{ return LIST(float({0}_count), float({0}_first)); }}\n"
                "void enter_list(LIST list) {{ {0}_count = int(list.x); {0}_first = int(list.y); "
                "}}\n",
                array.name);
            element = fmt::format("({}_first + element)", array.name);
        }
        const std::string at =
            array.texels == 1 ? element : fmt::format("{} * {} + texel", element, array.texels);
        std::string texel;
        switch (array.kind) {
        case ArrayStorage::Kind::uniform_block:
            text += fmt::format("layout(std140) uniform {0}_block {{ vec4 {0}[{1}]; }};\n",
                                array.name, array.capacity * array.texels);
            texel = fmt::format("{}[{}]", array.name, at);
            break;
        case ArrayStorage::Kind::texture_buffer:
            text += fmt::format("uniform IM_BUFFER {};\n", array.name);
            texel = fmt::format("IM_BUFFER_AT({}, {})", array.name, at);
            break;
        }
        text += fmt::format("vec4 {}_texel(int element, int texel) {{ return {}; }}\n", array.name,
                            texel);
    }
    return text;
}

// The user's text as a comment, where a line end or backslash could not end the comment.
std::string as_comment(std::string formula) {
    std::replace_if(
        formula.begin(), formula.end(), [](char c) { return c < ' ' || c == '\\' || c > '~'; },
        ' ');
    return formula;
}

const formula::Program& program_of(const formula::Field& field, FieldFunction function) {
    switch (function) {
    case FieldFunction::value:
        return field.value;
    case FieldFunction::directional:
        return field.directional;
    case FieldFunction::gradient:
        return field.gradient;
    case FieldFunction::value_interval:
        return formula::enclosure_programs(field).value;
    case FieldFunction::directional_interval:
        return formula::enclosure_programs(field).directional;
    case FieldFunction::rough:
        return formula::enclosure_programs(field).rough;
    case FieldFunction::breaks:
        return formula::enclosure_programs(field).breaks;
    case FieldFunction::hessian_interval:
        if (const auto& program = formula::hessian_program(field)) return *program;
        throw std::logic_error("second derivatives of a field without");
    default:
        return formula::enclosure_programs(field).gradient;
    }
}

struct FunctionParts {
    std::set<std::string> kernels;
    std::string glsl;
    bool on_intervals = false;
};

std::string glsl_of(const formula::Field& field, FieldFunction function,
                    const formula::IntervalNumbers& numbers) {
    const auto& packing = field.packing;
    switch (function) {
    case FieldFunction::value:
        return formula::glsl_value(field);
    case FieldFunction::directional:
        return formula::glsl_directional(field);
    case FieldFunction::gradient:
        return formula::glsl_gradient(field);
    case FieldFunction::hessian_interval:
        return formula::glsl_hessian_interval(program_of(field, function), packing, numbers);
    default:
        break;
    }
    const formula::EnclosurePrograms& programs = formula::enclosure_programs(field);
    switch (function) {
    case FieldFunction::value_interval:
        return formula::glsl_value_interval(programs, packing, numbers);
    case FieldFunction::directional_interval:
        return formula::glsl_directional_interval(programs, packing, numbers);
    case FieldFunction::rough:
        return formula::glsl_rough(programs, packing, numbers);
    case FieldFunction::breaks:
        return formula::glsl_breaks(programs, packing, numbers);
    default:
        return formula::glsl_gradient_interval(programs, packing, numbers);
    }
}

FunctionParts parts_of(const formula::Field& field, FieldFunction function,
                       const formula::IntervalNumbers& numbers = {}) {
    const formula::Program& program = program_of(field, function);
    const bool on_intervals = is_on_intervals(function);
    return {on_intervals ? formula::interval_kernels_used(program) : formula::kernels_used(program),
            glsl_of(field, function, numbers), on_intervals};
}

// What cells count by: loops of a shader end, unasked, after some 65,000 turns in all. One
// evaluation in a cell takes its elements and GRID_OTHERS turns more. No box has more than
// MOST_ELEMENTS: with the functions of a piece (four) that is a third of the turns there are. Nor
// does a pass go on after as many: eight neighbours, each in cells of its own, share its loops.
void define_grid_limits(ShaderText& text, const formula::Field& field, const FieldStorage& storage,
                        const std::vector<FieldFunction>& functions) {
    const auto array = array_with_grid(storage);
    if (!array) return;
    std::vector<int> others, once(storage.arrays.size(), 0);
    for (const ArrayStorage& each : storage.arrays) others.push_back(each.capacity);
    others[std::size_t(*array)] = 0;
    once[std::size_t(*array)] = 1;
    double turns = 1, loops = 1;
    for (const FieldFunction function : functions) {
        turns = std::max(turns, 1 + cost(field, storage, {function}, others).iterations);
        loops = std::max(loops, cost(field, storage, {function}, once).iterations);
    }
    text.define(Feature::most_cells, most_cells_of_box);
    text.define(Feature::grid_others, int(std::min(turns, 1e6)));
    text.define(Feature::most_elements, int(0.075 * loop_iterations_per_pass / loops));
}

// What lists leave out of each own sum: so many times the grid's bound, as intervals.
std::string declared_rest(const FieldStorage& storage) {
    const auto a = array_with_grid(storage);
    if (!a) return "";
    const ArrayStorage& array = storage.arrays[std::size_t(*a)];
    std::string list;
    for (int k = 0; k < array.sums; ++k) {
        list += fmt::format("{}bounds_of_rest(grid_block[{}].{})", k > 0 ? ", " : "",
                            grid_vectors_of_place + k / 4, "xyzw"[k % 4]);
    }
    if (array.sums == 0) return "";
    return fmt::format("vec2 {0}_rest[{1}] = vec2[{1}]({2});\n", array.name, array.sums, list);
}

} // namespace

std::optional<int> array_with_grid(const FieldStorage& storage) {
    for (std::size_t a = 0; a < storage.arrays.size(); ++a) {
        if (storage.arrays[a].has_grid) return int(a);
    }
    return std::nullopt;
}

int grid_vectors(const FieldStorage& storage) {
    const auto array = array_with_grid(storage);
    return array ? grid_vectors_of_place + (storage.arrays[std::size_t(*array)].sums + 3) / 4 : 0;
}

int FieldStorage::vectors() const {
    return parameter_vectors + count_vectors + grid_vectors(*this) + (tapes ? tape_vectors : 0);
}

bool has_lists(const FieldStorage& storage) {
    return !storage.arrays.empty() && storage.arrays[0].has_lists;
}

bool has_copies(const FieldStorage& storage) {
    return has_lists(storage) && storage.arrays[0].has_copies;
}

FieldStorage field_storage(const formula::Field& field, int parameters, std::span<const int> counts,
                           const Finding& finding) {
    FieldStorage storage;
    storage.parameter_vectors = std::max(1, (parameters + 3) / 4);
    for (std::size_t a = 0; a < field.packing.size(); ++a) {
        ArrayStorage array;
        array.name = fmt::format("array{}", a);
        array.texels = std::max<int>(1, (int(field.packing[a].size()) + 3) / 4);
        array.capacity = std::max(1, counts[a]);
        const std::size_t bytes = std::size_t(array.capacity) * std::size_t(array.texels) * 16;
        array.has_lists = finding.by_lists;
        array.has_copies = array.has_lists && finding.by_copies;
        array.has_grid = finding.by_place == int(a);
        if (array.has_grid) array.sums = int(formula::own_sums(field, int(a)).size());
        array.kind = (!array.has_lists || array.has_copies) && !array.has_grid &&
                             bytes <= ArrayStorage::uniform_block_bytes
                         ? ArrayStorage::Kind::uniform_block
                         : ArrayStorage::Kind::texture_buffer;
        storage.arrays.push_back(array);
    }
    storage.count_vectors = (int(storage.arrays.size()) + 3) / 4;
    return storage;
}

formula::Cost cost(const formula::Field& field, const FieldStorage& storage,
                   const std::vector<FieldFunction>& functions, std::span<const int> counts) {
    if (storage.tapes) return storage.tapes->cost(functions);
    formula::Cost total;
    for (const FieldFunction function : functions) {
        const formula::Cost one = formula::cost(program_of(field, function), counts);
        total.operations += (is_on_intervals(function) ? interval_operations : 1) * one.operations;
        total.iterations += one.iterations;
        total.noises += one.noises;
        if (is_on_intervals(function)) total.iterations += turns_of_noise_bounds * one.noises;
    }
    return total;
}

void add_field(ShaderText& text, const formula::Field& field, const FieldStorage& storage,
               const std::vector<FieldFunction>& functions,
               const std::vector<GeneratedFunction>& beside, bool beside_on_intervals) {
    std::set<std::string> kernels, interval_kernels;
    bool on_intervals = false;
    std::string generated;
    const std::optional<int> by_place = array_with_grid(storage);
    const std::vector<FieldFunction> compiled =
        storage.tapes ? std::vector<FieldFunction>{} : functions;
    for (const FieldFunction function : compiled) {
        FunctionParts parts = parts_of(field, function);
        (parts.on_intervals ? interval_kernels : kernels).merge(parts.kernels);
        on_intervals |= parts.on_intervals;
        generated += by_place ? in_cells(function, parts.glsl) : parts.glsl;
    }
    for (const GeneratedFunction& function : beside) {
        std::set<std::string>& used = beside_on_intervals ? interval_kernels : kernels;
        used.insert(function.kernels.begin(), function.kernels.end());
        on_intervals |= beside_on_intervals;
    }
    for (const auto& kernel : kernel_files(kernels)) text.file(kernel);
    if (on_intervals) {
        for (const auto& kernel : interval_files(interval_kernels)) text.file(kernel);
    }
    text.generated("generated: parameters of the surface", declarations(storage));
    define_grid_limits(text, field, storage, functions);
    if (by_place) add_cells(text, storage, *by_place);
    if (storage.tapes) add_tapes(text, *storage.tapes, functions);
    if (!compiled.empty()) {
        text.generated("generated from: " + as_comment(field.text), generated);
    }
    for (const GeneratedFunction& function : beside) {
        text.generated("generated from: " + as_comment(function.from),
                       !by_place           ? function.glsl
                       : function.sums_all ? over_all_elements(storage, *by_place, function.glsl)
                                           : entering_cells(function.glsl));
    }
    if (by_place && on_intervals) add_hulls_over_cells(text, functions);
}

void add_enclosures(ShaderText& text, const formula::Field& field, const FieldStorage& storage,
                    const std::vector<FieldFunction>& functions, formula::Numbers numbers) {
    if (storage.tapes) return add_field(text, field, storage, functions);
    const std::optional<int> by_place = array_with_grid(storage);
    std::optional<formula::LinearSum> sum;
    if (has_lists(storage)) sum = formula::known_linear_sum(field);
    formula::ListedArray listed;
    if (by_place) listed = {*by_place, formula::own_sums(field, *by_place)};
    if (sum) listed = {sum->array, formula::own_sums(field, sum->array)};
    const formula::IntervalNumbers on{numbers, by_place || sum ? &listed : nullptr};
    std::set<std::string> kernels;
    if (sum) kernels = formula::interval_kernels_used(sum->rest_and_factor);
    std::string generated;
    for (const FieldFunction function : functions) {
        FunctionParts parts = parts_of(field, function, on);
        kernels.merge(parts.kernels);
        generated += by_place ? in_cells(function, parts.glsl) : parts.glsl;
    }
    if (numbers == formula::Numbers::floats) {
        for (const auto& file : interval_files(kernels)) text.file(file);
    } else {
        const DoubleIntervalFiles files = double_interval_files(kernels);
        for (const auto& file : files.for_floats) text.file(file);
        for (const auto& file : files.for_doubles) text.file_again(file);
    }
    text.generated("generated: parameters of the surface", declarations(storage));
    define_grid_limits(text, field, storage, functions);
    if (by_place) {
        add_cells(text, storage, *by_place);
        text.generated("generated: what lists leave out", declared_rest(storage));
    }
    if (sum) {
        text.define(Feature::left_out, parts_left_out);
        text.generated("generated: F = factor * sum + rest",
                       formula::glsl_rest_and_factor_interval(*sum, field.packing, numbers));
        text.file("elements/lists.glsl");
    }
    text.generated("generated from: " + as_comment(field.text), generated);
    if (by_place) add_hulls_over_cells(text, functions);
}

} // namespace isomotion::shader
