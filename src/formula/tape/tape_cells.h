// The tapes of a function for the whole space, and for cells of a box: 1, 8, 64, ... of them.
//
// The tape of a cell for boxes holds half a cell around it, too. So a box as large as a cell lies in
// that of the cell in which its middle is, and finds its tape by one look. Points need less.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "formula/tape/tape_words.h"

namespace isomotion::formula {

// A function that an interpreter runs, with parameters that are not known yet.
class TapeFunction {
public:
    // None for programs with loops over elements, or too many values at a time.
    static std::optional<TapeFunction> of(Program program, TapeNumbers numbers);

    const TapeOperations& operations() const { return operations_; }
    int inputs() const { return inputs_; } // 3, or 6 with a direction behind them
    int outputs() const { return int(program_.outputs.size()); }
    int registers() const { return registers_; }
    int turns() const { return turns_; } // of the whole tape
    Tape whole(std::span<const float> parameters) const;

private:
    TapeFunction(Program program, TapeNumbers numbers, int inputs, const Tape& tape);

    Program program_;
    int inputs_ = 0, registers_ = 0, turns_ = 0;
    TapeOperations operations_;
};

struct TapeCells {
    std::array<double, 3> low{}, size{}; // of the box
    int levels = 0;                      // 2^levels cells along each side are the finest
    // First instruction and number of them, of each function in turn: of the whole space, of the
    // one cell of level 0, the eight of level 1, x first, and so on.
    std::vector<std::uint32_t> spans;
    std::vector<std::uint32_t> words;

    int spans_of_a_function() const;
};

struct TapeLimits {
    int threads = 1;
    double steps = 3e7;                   // to be looked at
    std::size_t instructions = 1u << 23;  // of all tapes
};

TapeCells tape_cells(std::span<const std::reference_wrapper<const TapeFunction>> functions,
                     std::span<const float> parameters,
                     const std::array<Interval, 3>& box, const TapeLimits& limits);

} // namespace isomotion::formula
