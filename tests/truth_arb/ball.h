// A real number known to lie in a ball, in Arb's arithmetic: midpoint and radius (Johansson 2017).
#pragma once

#include <arb.h>

namespace isomotion::truth_arb {

class Ball {
public:
    Ball() { arb_init(value_); }
    explicit Ball(double exact)
        : Ball() {
        arb_set_d(value_, exact);
    }
    // All of [low, high], which are finite.
    Ball(double low, double high)
        : Ball(low) {
        const Ball other(high);
        arb_union(value_, value_, other.value_, 128);
    }
    Ball(const Ball& other)
        : Ball() {
        arb_set(value_, other.value_);
    }
    Ball(Ball&& other) noexcept
        : Ball() {
        arb_swap(value_, other.value_);
    }
    Ball& operator=(const Ball& other) {
        arb_set(value_, other.value_);
        return *this;
    }
    Ball& operator=(Ball&& other) noexcept {
        arb_swap(value_, other.value_);
        return *this;
    }
    ~Ball() { arb_clear(value_); }

    arb_ptr get() { return value_; }
    arb_srcptr get() const { return value_; }

    bool is_finite() const { return arb_is_finite(value_); }
    // 1 or -1 if all members have that sign, 0 if that isn't known.
    int sign() const { return arb_is_positive(value_) ? 1 : arb_is_negative(value_) ? -1 : 0; }

private:
    arb_t value_;
};

} // namespace isomotion::truth_arb
