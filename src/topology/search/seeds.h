// Points spread evenly over the domain of a field, deterministic: a low-discrepancy sequence
// (Roberts 2018).
#pragma once

#include <cmath>

#include "topology/field/moving_field.h"

namespace isomotion::topology {

// Multiples of the powers of 1/g modulo 1, where g^(n+1) = g + 1: the generalized golden ratio
// sequence in n dimensions.
class Seeds {
public:
    explicit Seeds(const MovingField& field)
        : field_(field)
        , n_(std::size_t(field.variables())) {
        double g = 1.5;
        for (int k = 0; k < 60; ++k) g = std::pow(1 + g, 1.0 / (double(n_) + 1));
        double power = 1;
        for (std::size_t k = 0; k < n_; ++k) powers_[k] = power /= g;
    }

    Point operator[](int number) const {
        Point p{};
        for (std::size_t k = 0; k < n_; ++k) {
            const double at = 0.5 + powers_[k] * (number + 1);
            const formula::Interval domain = field_.domain()[k];
            p[k] = domain.lo + (at - std::floor(at)) * (domain.hi - domain.lo);
        }
        return p;
    }

private:
    const MovingField& field_;
    std::size_t n_;
    Point powers_{};
};

} // namespace isomotion::topology
