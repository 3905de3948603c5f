// The part of a shader that runs a field's functions as tapes (formula/tape/), for formulas that
// take a driver too long to compile.
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "formula/tape/tape_cells.h"
#include "formula/tape/unrolled.h"
#include "shader/field_text.h"

namespace isomotion::shader {

struct Passes;

// The functions of a field as an interpreter runs them.
class FieldTapes {
public:
    // Null for a field with more values at a time than the interpreter keeps, or with sums over so
    // many elements that a tape for each of them would be too long.
    static std::shared_ptr<const FieldTapes> of(const formula::Field& field, int parameters,
                                                std::vector<formula::ElementRange> ranges);

    // The order of tapes' spans.
    const std::vector<FieldFunction>& functions() const { return functions_; }
    const formula::TapeFunctions::Function& function(FieldFunction of) const;
    // The function that has a tape where `of` has none: gradients are slopes along the axes.
    FieldFunction run_for(FieldFunction of) const;

    // Those on points, then those on boxes.
    std::span<const formula::TapeFunctions> groups() const { return groups_; }

    // What the groups' tapes read as parameters.
    std::vector<float> parameters(const formula::Bindings<float>& bindings) const {
        return elements_.values(bindings);
    }

    // For each of the functions, whether these shaders run it.
    std::vector<bool> are_run(const Passes& passes) const;

    // Whether tapes are shorter in parts of the space.
    bool chooses() const;

    // The cost of one call of each. Iterations are those of the tape of the whole space; operations
    // are what a usual cell takes.
    formula::Cost cost(const std::vector<FieldFunction>& functions) const;

private:
    explicit FieldTapes(formula::ElementParameters elements)
        : elements_(std::move(elements)) {}

    formula::ElementParameters elements_;
    std::vector<FieldFunction> functions_;
    std::vector<formula::TapeFunctions> groups_;
};

// vec4s of the block Parameters that describe the tapes' cells: their place, and for each function
// of the enumeration where its spans begin.
inline constexpr int tape_vectors_of_place = 2, tape_vectors = 5;

void add_tapes(ShaderText& text, const FieldTapes& tapes, const std::vector<FieldFunction>& wanted);

// Lets march/sample.glsl have field_directional_or_sign(), which runs no tape in such cells. It
// tells `tape_is_free` then, and a number of F's sign, which is enough where bounds judge.
void define_signs_in_free_tapes(ShaderText& text, const FieldTapes& tapes);

} // namespace isomotion::shader
