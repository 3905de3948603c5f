// A scheduled graph: straight-line instructions, with loops for sums.
//
// Both back ends run a Program: the GLSL writer prints one statement per instruction, the CPU
// evaluator interprets it. Values that don't depend on a loop's element are computed before the
// loop. Sums, least elements and picks over one array share one loop if they don't need each
// other's results.
#pragma once

#include <span>
#include <vector>

#include "formula/graph/graph.h"

namespace isomotion::formula {

using Register = int;

struct Instruction {
    enum class Kind : std::uint8_t {
        operation,  // result = op(operands)
        begin,      // initialises the result without elements: 0 for a sum
        loop_begin, // loops over the elements of array `index`, to the matching loop_end
        accumulate, // updates the result with the element's operands
        loop_end,
    };
    Kind kind = Kind::operation;
    Op op = Op::constant; // of begin and accumulate: the operation over the elements
    std::uint8_t arity = 0;
    int index = 0;
    int second = 0; // of begin: the operation's node in the graph
    double value = 0;
    Register result = -1;
    // operands[2] of begin and accumulate for pick and which: the register of the least key so far.
    std::array<Register, 4> operands{};
};

struct Program {
    std::vector<Instruction> instructions;
    std::vector<Register> outputs; // one per root
    int registers = 0;
};

// `inside` has a bit for each array whose current element the roots may use, since the term of one
// element is a program of its own.
Program schedule(const Graph& graph, std::span<const NodeId> roots, std::uint32_t inside = 0);

// The cost of one run of the program if array k has counts[k] elements.
inline constexpr double operations_of_noise = 250; // eight corners, and weights along three axes
struct Cost {
    double operations = 0; // arithmetic operations and functions
    double iterations = 0; // loop iterations, nested ones multiplied out
    double functions = 0;  // operations that processors don't have built in: exp, sin, power, ...
    double noises = 0;     // calls of noise, which counts as many operations
};
Cost cost(const Program& program, std::span<const int> counts);

} // namespace isomotion::formula
