// Limits of a formula, far beyond anything that people type or programs have reason to write. They
// are so low that reading a formula neither overflows a stack nor fills the memory.
//
// docs/scene-file.md lists them beside those of scenes (scene/limits.h).
#pragma once

#include <cstddef>

namespace isomotion::formula::limits {

inline constexpr std::size_t formula_bytes = 500'000; // of one text; expressions of t included
inline constexpr std::size_t name_bytes = 64;         // of a parameter, array, field, definition
// Depth of parentheses, calls, signs and powers; the parser recurses for each. An open parenthesis
// counts twice, as an expression and as a factor.
inline constexpr int nesting = 400;
inline constexpr std::size_t function_arguments = 32; // of a formula's own function
inline constexpr std::size_t calls_work = 50'000'000; // operations that its calls look at
inline constexpr std::size_t formula_nodes = 100'000; // of the graph as read from the text
// Nodes of one graph with all its derivatives. A formula within the other limits may exceed this
// one, as do second derivatives of high Chebyshev polynomials.
inline constexpr std::size_t graph_nodes = 2'000'000;
inline constexpr int chebyshev_degree = 1000;
inline constexpr int octaves = 12; // of fbm
// Length of a chain of parameters or fields each of which names the next: rules over time are
// evaluated by recursion.
inline constexpr std::size_t chain = 200;
// One bit each in Node::arrays.
inline constexpr int arrays = 32;

} // namespace isomotion::formula::limits
