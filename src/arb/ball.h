// A real number known to lie in a ball, in Arb's arithmetic: midpoint and radius (Johansson 2017).
#pragma once

#include <arb.h>

namespace isomotion::ball {

class Ball {
public:
    Ball() { arb_init(value_); }
    explicit Ball(double exact)
        : Ball() {
        arb_set_d(value_, exact);
    }
    // All of [low, high]; both must be finite.
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
    // 1 or -1 if all members have that sign, 0 if the sign isn't known.
    int sign() const { return arb_is_positive(value_) ? 1 : arb_is_negative(value_) ? -1 : 0; }

    // Whether it has bounds and all members are in [low, high]; whether no member is.
    bool is_in(double low, double high) const {
        return is_finite() && compare_low(low) >= 0 && compare_high(high) <= 0;
    }
    bool is_apart_from(double low, double high) const {
        return compare_low(high) > 0 || compare_high(low) < 0;
    }

private:
    // Compare the least and the greatest member with a number: negative, 0 or positive.
    int compare_low(double number) const { return compare_end(number, arb_get_lbound_arf); }
    int compare_high(double number) const { return compare_end(number, arb_get_ubound_arf); }
    int compare_end(double number, void (*end)(arf_t, const arb_t, slong)) const {
        // Rounded outwards with enough bits that two different ends don't become equal.
        constexpr slong precision = 4096;
        arf_t bound;
        arf_init(bound);
        end(bound, value_, precision);
        const int order = arf_cmp_d(bound, number);
        arf_clear(bound);
        return order;
    }

    arb_t value_;
};

} // namespace isomotion::ball
