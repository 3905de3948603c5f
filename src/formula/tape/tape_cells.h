// The tapes of a field's functions for the whole space, and for cells of a box: 1, 8, 64, ... of
// them.
//
// The tape of a cell for boxes holds a quarter of a cell around it, too. So a box half as large as
// a cell lies in that of the cell in which its middle is, and finds its tape by one look. Points
// need less.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "formula/tape/tape_words.h"

namespace isomotion::formula {

// A function of a field to be run as a tape. The first outputs, so many, are F, and those behind
// them slopes of F.
struct TapeRequest {
    Program program;
    TapeNumbers numbers{};
    int values = 1, slopes = 0;
};

// Functions that are shortened together. The first output is F.
class TapeFunctions {
public:
    // None for programs with loops over elements, or with too many values at a time.
    static std::optional<TapeFunctions> of(const std::vector<TapeRequest>& requests);

    struct Function {
        TapeOperations operations;
        int first_output = 0, outputs = 0;
        int values = 0, slopes = 0; // of these
        int inputs = 0;             // 3, or 6 with a direction behind them
        int registers = 0;          // a power of two
        int turns = 0, noises = 0;  // of the whole tape
        bool has_own_order = false; // its steps are put into another order than that of all
    };
    const Function& operator[](std::size_t k) const { return functions_[k]; }
    std::size_t size() const { return functions_.size(); }
    bool on_points() const { return functions_[0].operations.numbers() == TapeNumbers::floats; }

    // Whether anything is decided in cells.
    bool chooses() const { return chooses_; }

    Tape whole(std::span<const float> parameters) const;

private:
    Tape joined_;
    std::vector<Function> functions_;
    bool chooses_ = false;
};

struct TapeCells {
    std::array<double, 3> low{}, size{}; // of the box
    int levels = 0;                      // 2^levels cells along each side are the finest
    // First instruction and number of them, for each function in turn: of the whole space, of the
    // one cell of level 0, the eight of level 1, x first, and so on. Where a cell for points holds
    // no root, `free` is added to the number, `negative` if F is, and the level of the largest such
    // cell around it, times `level_unit`.
    std::vector<std::uint32_t> spans;
    static constexpr std::uint32_t free = 1u << 31, negative = 1u << 30, level_unit = 1u << 24;
    std::vector<std::uint32_t> words;

    int spans_of_a_function() const;
};

struct TapeLimits {
    int threads = 1;
    double steps = 1e8;                  // to be looked at, of each group of functions
    std::size_t instructions = 1u << 24; // of each group
    // For each function of all groups, whether it is run: others have empty spans. Empty for all.
    std::vector<bool> are_run{};
};

// The functions of all groups, in turn.
TapeCells tape_cells(std::span<const TapeFunctions> groups, std::span<const float> parameters,
                     const std::array<Interval, 3>& box, const TapeLimits& limits);

} // namespace isomotion::formula
