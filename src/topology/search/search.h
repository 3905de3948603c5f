// All critical points of a moving surface in one stratum: where F = 0 and its derivatives along the
// free coordinates are 0, by branch and prune (Stander and Hart 1997; Kearfott 1996).
//
// A box is left where some sign is certain, or where Krawczyk's operator says that it has no root;
// it is done where, inflated around the limit of Newton's method, it provably holds one root.
// Inflation makes roots on the faces between boxes, those of every symmetric surface, harmless.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "topology/field/moving_field.h"
#include "topology/search/isolation.h"

namespace isomotion::topology {

struct SearchOptions {
    // Boxes with no side longer than this part of the domain's are not divided any more.
    double smallest = 1e-6;
    int threads = 1;                        // the result doesn't depend on it
    std::function<bool()> stopped{};        // asked often, from any thread
    std::function<void(double)> progress{}; // part of the domain that is done; see SharedLoop
};

// The domain in boxes that threads search one by one, at least 64.
std::vector<Box> tasks(const MovingField& field);

// The test that ended a box.
enum class Test {
    known,    // inside the box of a point that was found
    place,    // outside of the bounds
    value,    // F is not 0
    gradient, // a derivative of F is not 0
    hessian,  // the same by values in the middle and second derivatives
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
    std::vector<Box> unresolved;       // outside of these, no other points; each with a gap around
    Work work;
};

SearchResult search(const MovingField& field, const SearchOptions& searching);

// Sorts the points by clock. Of those found twice, each in the box where the other is alone, one
// stays.
void put_together(SearchResult& found);

// The boxes as few, each around some of them that touch or nearly do.
std::vector<Box> merged(std::vector<Box> boxes, const Box& domain, double gap);

} // namespace isomotion::topology
