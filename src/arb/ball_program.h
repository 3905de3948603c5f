// Runs the programs of formulas in Arb's ball arithmetic, as a second opinion.
//
// It shares only the program with Evaluator<Interval>. Values are exact: results that
// Operations<double> cuts off at saturation are not cut off here. An operation without a value
// (x/0, the logarithm of 0, a power of a negative number, the least of no elements) gives a ball
// without bounds. If only a part of a ball has a value under sqrt, asin, acos and real powers, the
// ball represents that part, since rounding extends balls of |x| below 0 and those of cosines
// beyond 1.
#pragma once

#include <span>
#include <vector>

#include "arb/ball.h"
#include "formula/evaluate/evaluate.h"

namespace isomotion::ball {

class BallProgram {
public:
    explicit BallProgram(const formula::Program& program)
        : program_(&program)
        , registers_(std::size_t(program.registers)) {}

    // Each output's ball holds its value for all members of the inputs. Precision is in bits.
    void evaluate(const formula::Bindings<double>& bindings, std::span<const Ball> inputs,
                  std::span<Ball> outputs, slong precision);

private:
    struct Loop {
        std::size_t begin;
        int array, element;
    };
    void begin(const formula::Instruction& now);
    void accumulate(const formula::Instruction& now, int element, slong precision);
    void operation(const formula::Instruction& now, const formula::Bindings<double>& bindings,
                   std::span<const Ball> inputs, const std::vector<Loop>& loops, slong precision);

    const formula::Program* program_;
    std::vector<Ball> registers_;
};

} // namespace isomotion::ball
