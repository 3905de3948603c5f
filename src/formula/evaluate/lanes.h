// One register of an evaluator: its values at all points of a block, as stored in memory.
//
// Numbers are stored side by side. For intervals all lower ends come first, then all upper ends, so
// that loops over the lanes vectorise for both.
#pragma once

#include "formula/interval/interval.h"

namespace isomotion::formula {

template<class T> struct Lanes {
    using Part = T;
    static constexpr int parts = 1; // Parts per value

    Part* first;

    Lanes(Part* memory, int)
        : first(memory) {}
    T operator[](int lane) const { return first[lane]; }
    void set(int lane, T value) const { first[lane] = value; }
};

template<> struct Lanes<Interval> {
    using Part = double;
    static constexpr int parts = 2;

    Part *low, *high;

    Lanes(Part* memory, int lanes)
        : low(memory)
        , high(memory + lanes) {}
    Interval operator[](int lane) const { return {low[lane], high[lane]}; }
    void set(int lane, Interval value) const {
        low[lane] = value.lo;
        high[lane] = value.hi;
    }
};

} // namespace isomotion::formula
