// The part of a shader that runs a field's functions as tapes (formula/tape/), for formulas that
// take a driver too long to compile.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "formula/tape/tape_cells.h"
#include "synthesis/field_text.h"

namespace isomotion::synthesis {

struct Passes;

// The functions of a field as an interpreter runs them.
class FieldTapes {
public:
    // Null for a field with arrays, or with more values at a time than the interpreter keeps.
    static std::shared_ptr<const FieldTapes> of(const formula::Field& field);

    const formula::TapeFunction& function(FieldFunction of) const { return functions_.at(of); }
    // The function that has a tape where `of` has none: gradients are slopes along the axes.
    FieldFunction run_for(FieldFunction of) const;

    // The cost of one call of each, with tapes of the whole space.
    formula::Cost cost(const std::vector<FieldFunction>& functions) const;

private:
    std::map<FieldFunction, formula::TapeFunction> functions_;
};

// vec4s of the block Parameters that describe the tapes' cells: their place, and for each function
// of the enumeration where its spans begin.
inline constexpr int tape_vectors_of_place = 2, tape_vectors = 5;

void add_tapes(ShaderText& text, const FieldTapes& tapes,
               const std::vector<FieldFunction>& wanted);

// The functions that these shaders run.
std::vector<FieldFunction> functions_run(const Passes& passes);

} // namespace isomotion::synthesis
