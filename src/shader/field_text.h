// The part of a shader that evaluates a surface's field: kernels, the storage of parameters and
// arrays, the generated functions.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formula/field.h"
#include "formula/glsl/glsl_interval.h"

namespace isomotion::shader {

class FieldTapes; // tape_text.h
class ShaderText;

// How a shader reads an array's elements, `texels` vec4s each.
struct ArrayStorage {
    // Every OpenGL 3.3 has uniform blocks of 16 kB. They are faster than texture buffers, which
    // hold longer arrays.
    enum class Kind { uniform_block, texture_buffer };
    static constexpr std::size_t uniform_block_bytes = 16384;

    Kind kind = Kind::uniform_block;
    std::string name; // of the block or the sampler
    int texels = 1;
    int capacity = 0; // elements
    // Lists of elements that matter in a beam follow the elements in their texture buffer.
    bool has_lists = false;
    // Lists are copies in a texture of their own, of at most most_in_copies elements, for shaders
    // that can write no lists (beam_copies_text.h); and whether this shader goes through them.
    bool has_copies = false;
    bool reads_copies = false;
    // A grid over the bounds tells which of them matter where (elements/element_grid.h). F has so
    // many sums over the array.
    bool has_grid = false;
    int sums = 0;
};

// The functions of a field that a shader can use; see glsl_value(), glsl_value_interval() and their
// siblings for the signatures. Programs for intervals are made when they are needed.
enum class FieldFunction {
    value,
    directional,
    gradient,
    value_interval,
    directional_interval,
    gradient_interval,
    hessian_interval, // for fields that have a hessian_program()
    rough,
    breaks
};

// Whether its arguments are boxes.
constexpr bool is_on_intervals(FieldFunction function) {
    return function >= FieldFunction::value_interval;
}

// How a shader reads the values of a field's names.
struct FieldStorage {
    int parameter_vectors = 1; // vec4s of the block Parameters, before the arrays' counts
    int count_vectors = 0;     // ivec4s of counts
    std::vector<ArrayStorage> arrays;
    // If F's functions are no code of their own but tapes that an interpreter runs.
    std::shared_ptr<const FieldTapes> tapes;

    // Length of the block.
    int vectors() const;
};

bool has_lists(const FieldStorage& storage);
// Where they are copies in a texture.
bool has_copies(const FieldStorage& storage);
// Browsers draw into 8 textures at once: a beam, and three each for the bits of two lists.
inline constexpr int most_in_copies = 3 * 128;
// The array whose elements are found by place, if there is one.
std::optional<int> array_with_grid(const FieldStorage& storage);
// vec4s of the block Parameters that describe the grid, after the counts; includes the parts that
// its lists leave out of each sum, four to a vector.
int grid_vectors(const FieldStorage& storage);
inline constexpr int grid_vectors_of_place = 3;

// The part of a sum, relative to its value at roots, that the lists of one level of beams may leave
// out: see shaders/march/beam_list.glsl.
inline constexpr std::string_view parts_left_out = "6.25e-7";

// How the elements of a field's arrays are found.
struct Finding {
    bool by_lists = false;       // of the first array, in beams
    std::optional<int> by_place; // of this array
    bool by_copies = false;      // lists are copies in a texture
};

FieldStorage field_storage(const formula::Field& field, int parameters, std::span<const int> counts,
                           const Finding& finding = {});

// The cost of one call of each function. An operation on intervals counts as so many on numbers.
inline constexpr double interval_operations = 12;
formula::Cost cost(const formula::Field& field, const FieldStorage& storage,
                   const std::vector<FieldFunction>& functions, std::span<const int> counts);

// A function that reads the field's parameters and arrays but is not one of the field's own.
struct GeneratedFunction {
    std::string from; // the user's text
    std::set<std::string> kernels;
    std::string glsl;
    // It sums over all elements, even of an array whose elements are found by place.
    bool sums_all = false;
};

void add_field(ShaderText& text, const formula::Field& field, const FieldStorage& storage,
               const std::vector<FieldFunction>& functions,
               const std::vector<GeneratedFunction>& beside = {}, bool beside_on_intervals = false);

// Adds the field's functions on intervals, over all elements even if lists leave some out: a
// statement on F holds for each value within the bounds of what is left out
// (elements/field_by_place.h). Functions on doubles need GLSL 4.00; after them REAL is double in
// shaders/interval/.
void add_enclosures(ShaderText& text, const formula::Field& field, const FieldStorage& storage,
                    const std::vector<FieldFunction>& functions,
                    formula::Numbers numbers = formula::Numbers::floats);

} // namespace isomotion::shader
