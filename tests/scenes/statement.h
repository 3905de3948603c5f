// A relation of two formulas: "R = 0.12 + max(0, nz)", "depth <= 5".
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "formula/evaluate/evaluate.h"

namespace isomotion::scenes {

class Statement {
public:
    // The formulas may name `names` and what `let` names: "a = ...; b = ...;". Throws
    // formula::ParseError, and std::invalid_argument for a text without a relation.
    Statement(const std::string& text, const std::string& let,
              const std::vector<std::string>& names);

    // Whether it is true for these values of the names. Equal numbers are `within` of each other,
    // or both the same infinity. Nothing is true of NaN.
    bool holds(std::span<const double> values, double within = 0);

    // The statement with what both sides came to last: "R = 0.5: 0.4 and 0.5".
    std::string told() const;
    double right() const { return right_; } // as it came to last

private:
    std::string text_, relation_;
    std::optional<formula::Evaluator<double>> sides_;
    double left_ = 0, right_ = 0;
};

} // namespace isomotion::scenes
