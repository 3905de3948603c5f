// The vertices of a grid that lie in the solid, one bit each, and the Betti numbers of that solid.
//
// The solid is the union of the simplices of Kuhn's triangulation whose vertices are all in it
// (each cube is cut into six tetrahedra along its diagonal from (0, 0, 0) to (1, 1, 1)). It has the
// homotopy type of {P < 0} for the piecewise linear P with these signs. The complement has the
// homotopy type of the same construction on the other vertices. Two vertices are neighbours if they
// differ by a vector of 0s and 1s or its negative, so each has 14, in the solid and in its
// complement alike. There is no solid outside of the grid.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "topology/timeline/betti.h"

namespace isomotion::topology {

class SignGrid {
public:
    using Word = std::uint64_t;

    // Empty; `side` vertices in each direction, at least one.
    explicit SignGrid(int side);

    int side() const { return side_; }
    bool at(int x, int y, int z) const { return row(y, z)[std::size_t(x) / 64] >> (x % 64) & 1; }
    void set(int x, int y, int z) { row(y, z)[std::size_t(x) / 64] |= Word(1) << (x % 64); }
    void set_run(int first, int last, int y, int z); // both ends included; empty if first > last

    // Bit k of word w is vertex 64 w + k; bits beyond the side are 0.
    std::span<const Word> row(int y, int z) const { return {&bits_[start(y, z)], words_}; }
    std::span<Word> row(int y, int z) { return {&bits_[start(y, z)], words_}; }

    bool operator==(const SignGrid&) const = default;

private:
    std::size_t start(int y, int z) const {
        return (std::size_t(z) * std::size_t(side_) + std::size_t(y)) * words_;
    }

    int side_;
    std::size_t words_; // per row
    std::vector<Word> bits_;
};

Betti betti(const SignGrid& solid);

} // namespace isomotion::topology
