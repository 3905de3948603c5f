// A formula as a list of instructions that an interpreter runs, and the shorter list that does the
// same within a box.
//
// Keeter, "Massively Parallel Rendering of Complex Closed-Form Implicit Surfaces" (2020): an
// interval decides which side of min(a, b) can matter in a box, and what feeds the other side alone
// is dropped. Here all that jumps or chooses is decided so: min, max, abs, select, sign and floor.
// What comes out constant goes on being simplified.
//
// Two sides that overlap can both be beaten by a third. So values that are wanted are known too: of
// min(a, b), an `a` above the least upper bound of all that is compared with it is never taken.
// Alternatives of a minimum of thousands then leave in one pass, in whatever order they are
// written.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "formula/evaluate/evaluate.h"
#include "formula/graph/program.h"

namespace isomotion::formula {

struct TapeStep {
    Op op = Op::constant; // constant, input, parameter or an operation
    std::uint8_t arity = 0;
    bool is_exact = false; // on intervals, where it can be: glsl/exact_results.h
    // Of an input or parameter; the degree of chebyshev; noise's order; Graph::select's slope_of.
    int index = 0;
    int second = 0;                // the derivative of chebyshev
    int follows = -1;              // the min or max that a select is the slope of, an earlier step
    std::array<int, 4> operands{}; // earlier steps
    Interval value{};              // holds a constant
};

struct Tape {
    std::vector<TapeStep> steps;
    std::vector<int> outputs; // steps
};

// A program, and which of its outputs are slopes of F: `slopes` behind the first `values`.
struct TapeSource {
    const Program& program;
    int values = 1, slopes = 0;
};

// Joins several programs: the outputs of the first come before those of the next. Steps that they
// share are done once. None for programs with loops over elements. Parameters are steps yet.
std::optional<Tape> tape_of(std::span<const TapeSource> sources);

// The tape with parameters for constants.
Tape with_parameters(Tape tape, std::span<const Interval> parameters);

// The steps that outputs `first` to `first + count - 1` need, in their order.
Tape part_of(const Tape& tape, int first, int count);

// Shortens tapes. It keeps what it allocates for the next one.
class Specialiser {
public:
    // `shortened` becomes the steps that decide the outputs for all inputs within these bounds.
    // Values there are those of `tape`, but for rounding.
    void operator()(const Tape& tape, std::span<const Interval> inputs, Tape& shortened);

    // Bounds of an output over the last box.
    Interval bounds_of(int output) const {
        return values_[std::size_t(outputs_[std::size_t(output)])];
    }

private:
    int next(TapeStep step, std::span<const Interval> inputs);
    std::optional<int> chosen(const TapeStep& step, const std::array<Interval, 4>& of);
    int negated(int of);
    bool is_constant(int step) const;
    int constant(Interval value);
    int add(const TapeStep& step, Interval value);
    void find_wanted();
    void want(int step, Interval range);
    int stand_in(int step) const;

    std::vector<TapeStep> made_;
    std::vector<Interval> values_; // of the steps made
    std::vector<Interval> wanted_; // values of these that make a difference to an output
    std::vector<int> stands_for_;  // the step made for each of the tape's
    std::vector<int> outputs_, place_;
};

} // namespace isomotion::formula
