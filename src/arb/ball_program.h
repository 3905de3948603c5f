// A second opinion on formulas: their programs run in Arb's ball arithmetic.
//
// It has nothing in common with Evaluator<Interval> but the program. Values are those on paper:
// what Operations<double> cuts off at saturation is not cut off here, and what has no value (x/0,
// the logarithm of 0, a power of a negative number, the least of no elements) is a ball without
// bounds. A ball of which only
// a part has a value stands for that part under sqrt, asin, acos and real powers, as rounding
// carries balls of |x| below 0 and those of cosines beyond 1.
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

    // Each output's ball holds its value for all members of the inputs. Precision in bits.
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
