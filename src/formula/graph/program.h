// A graph put in order: straight-line instructions with loops for sums.
//
// Both back ends run a Program: the GLSL writer prints one statement an instruction, the CPU
// evaluator interprets it. What doesn't depend on a loop's element is computed before the loop, and
// sums, least elements and picks over one array that don't need each other's results share one
// loop.
#pragma once

#include <span>
#include <vector>

#include "formula/graph/graph.h"

namespace isomotion::formula {

using Register = int;

struct Instruction {
    enum class Kind : std::uint8_t {
        operation,  // result = op(operands)
        begin,      // the result of no elements: 0 of a sum
        loop_begin, // for every element of array `index`, to the matching loop_end
        accumulate, // takes in the element's operands
        loop_end,
    };
    Kind kind = Kind::operation;
    Op op = Op::constant; // of begin and accumulate: what goes through the elements
    std::uint8_t arity = 0;
    int index = 0;
    int second = 0; // of begin: its node in the graph
    double value = 0;
    Register result = -1;
    // operands[2] of pick and which that begin or accumulate: the register of the least key so far.
    std::array<Register, 4> operands{};
};

struct Program {
    std::vector<Instruction> instructions;
    std::vector<Register> outputs; // one per root
    int registers = 0;
};

// `inside` has a bit for each array whose current element the roots may use: one element's part of
// a sum is a program of its own.
Program schedule(const Graph& graph, std::span<const NodeId> roots, std::uint32_t inside = 0);

// What one run of the program takes when array k has counts[k] elements.
struct Cost {
    double operations = 0; // arithmetic operations and functions
    double iterations = 0; // loop iterations, nested ones multiplied out
    double functions = 0;  // operations that aren't built into processors: exp, sin, power, ...
};
Cost cost(const Program& program, std::span<const int> counts);

} // namespace isomotion::formula
