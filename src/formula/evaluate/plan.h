// What an evaluator runs: a program whose registers serve again once nobody asks for their value,
// so that all of them stay near the processor, and what is known of values before they are.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "formula/graph/program.h"

namespace isomotion::formula {

// How two intervals are multiplied: the fewest comparisons that what is known of them leaves.
enum class Product : std::uint8_t {
    any,
    square,          // of one value
    by_uniform,      // the second factor is the same at all points: its sign is told once
    by_not_negative, // the second factor has no member below 0
    of_not_negative, // neither factor has one
};

struct Step : Instruction {
    bool is_uniform = false; // the same at all points
    Product product = Product::any;
};

struct Plan {
    std::vector<Step> steps; // without those that read inputs
    int registers = 0;
    std::vector<Register> inputs; // that inputs are put into; -1 for one that nobody asks for
    std::vector<Register> outputs;
    std::size_t deepest = 0; // loops within each other
};

// `enclosures`: of intervals, not of numbers, whose products are all alike.
Plan plan(const Program& program, bool enclosures);

} // namespace isomotion::formula
