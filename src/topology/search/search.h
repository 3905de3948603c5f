// Finds all critical points of a moving surface in one stratum, where F = 0 and its derivatives
// along the free coordinates are 0, by branch and prune (Stander and Hart 1997; Kearfott 1996).
//
// A box is discarded if some sign is certain, or if Krawczyk's operator shows that it has no root.
// It is finished if, inflated around the limit of Newton's method, it provably holds one root.
// Inflation handles roots on the faces between boxes, which every symmetric surface has.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "topology/field/moving_field.h"
#include "topology/search/isolation.h"

namespace isomotion::topology {

struct SearchOptions {
    // Boxes whose longest side is at most this fraction of the domain's are not divided any more.
    double smallest = 1e-6;
    int threads = 1;                        // the result doesn't depend on it
    std::function<bool()> stopped{};        // called often, from any thread
    std::function<void(double)> progress{}; // finished part of the domain; see SharedLoop
};

// The domain divided into boxes, at least 64, that threads search one by one.
std::vector<Box> tasks(const MovingField& field);

// The test that finished a box.
enum class Test {
    known,    // the box is inside the box of a known point
    place,    // it is outside of the bounds
    value,    // F is not 0 in it
    gradient, // a derivative of F is not 0 in it
    hessian,  // the same, by values in the middle and second derivatives
    krawczyk, // no root
    isolated, // one root
    narrowed, // the roots are in a smaller box
    divided,
    smallest, // unresolved
    count,
};
const char* name_of(Test test);

struct Work {
    std::int64_t boxes = 0;
    std::array<std::int64_t, std::size_t(Test::count)> removed{};

    void count(Test test) { ++removed[std::size_t(test)]; }
    Work& operator+=(const Work& other);
};

struct SearchResult {
    std::vector<CriticalPoint> points; // by clock
    // There are no other points outside of these; each has a gap around it.
    std::vector<Box> unresolved;
    // For each of these one of the smallest boxes that it was put together from; empty if not kept.
    std::vector<Box> smallest{};
    Work work;
};

SearchResult search(const MovingField& field, const SearchOptions& searching);

// By clock, then by place.
void put_in_order(std::vector<CriticalPoint>& points);
// Puts the points in order. Two points are one if either is in the box where the other is alone:
// one of them remains.
void put_together(SearchResult& found);

// Merges boxes that touch or nearly do into few boxes around them.
std::vector<Box> merged(std::vector<Box> boxes, const Box& domain, double gap);

} // namespace isomotion::topology
