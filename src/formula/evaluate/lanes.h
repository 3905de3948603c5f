// One register of an evaluator: its values at all points of a block, as stored in memory.
//
// Numbers are stored side by side. For intervals all lower ends come first, then all upper ends, so
// that loops over the lanes vectorise for both.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

#include "formula/interval/interval.h"

namespace isomotion::formula {

// Memory for registers, where the widest loads of processors cross no line of their caches.
template<class Part> struct InLines {
    using value_type = Part;
    static constexpr std::align_val_t line{64};

    InLines() = default;
    template<class Other> InLines(const InLines<Other>&) {}

    Part* allocate(std::size_t count) {
        return static_cast<Part*>(::operator new(count * sizeof(Part), line));
    }
    void deallocate(Part* memory, std::size_t) { ::operator delete(memory, line); }
    bool operator==(const InLines&) const = default;
};
template<class Part> using Registers = std::vector<Part, InLines<Part>>;

template<class T> struct Lanes {
    using Part = T;
    static constexpr int parts = 1; // Parts per value

    Part* first;

    Lanes(Part* memory, int)
        : first(memory) {}
    T operator[](int lane) const { return first[lane]; }
    void set(int lane, T value) const { first[lane] = value; }
};

// Both ends of Enclosure, in the order of its members.
template<class Enclosure> struct LanesOfEnds {
    using Part = double;
    static constexpr int parts = 2;

    Part *low, *high;

    LanesOfEnds(Part* memory, int lanes)
        : low(memory)
        , high(memory + lanes) {}
    Enclosure operator[](int lane) const { return {low[lane], high[lane]}; }
    void set(int lane, Enclosure value) const {
        const auto [a, b] = value;
        low[lane] = a;
        high[lane] = b;
    }
};
template<> struct Lanes<Interval> : LanesOfEnds<Interval> { using LanesOfEnds::LanesOfEnds; };

} // namespace isomotion::formula
