// The grid's vertices in a leaf on which G is monotone along an axis: each column along it changes
// its sign once at most. Which vertices are in the solid is asked vertex by vertex, so that those
// of many leaves can be evaluated together.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "topology/betti/column.h"
#include "topology/betti/sign_grid.h"

namespace isomotion::topology {

class LeafColumns {
public:
    using Vertex = std::array<int, 3>;
    using At = std::array<int, 2>; // of a column

    // `range`: numbers of the first and the last vertex along each axis.
    LeafColumns(const std::array<std::array<int, 2>, 3>& range, std::size_t axis, bool rises);

    std::size_t count() const { return columns_.size(); }
    // Columns are asked coarse to fine, by strides that halve from here to 1: each is guessed from
    // those about it, which must be known.
    int coarsest() const { return coarsest_; }
    template<class Take> void begin(int stride, Take&& take) {
        for (int j = 0; j <= high_; j += stride) {
            for (int i = 0; i <= wide_; i += stride) {
                if (column({i, j}).is_known()) continue;
                guess({i, j}, stride);
                take(At{i, j});
            }
        }
    }

    Vertex asked(const At& at) const { return vertex(at, column(at).next(last_)); }
    // Whether the column is known now.
    bool learn(const At& at, formula::Interval value) {
        column(at).learn(value, last_);
        return column(at).is_known();
    }

    // Once all are known: how far G may be below 0 at vertices that are not taken for the solid's.
    double lost() const;
    void draw(SignGrid& grid) const;

private:
    Column& column(const At& at) {
        return columns_[std::size_t(at[1]) * std::size_t(wide_ + 1) + std::size_t(at[0])];
    }
    const Column& column(const At& at) const {
        return columns_[std::size_t(at[1]) * std::size_t(wide_ + 1) + std::size_t(at[0])];
    }
    void guess(const At& at, int stride);
    // With this number in a column.
    Vertex vertex(const At& at, int number) const {
        Vertex vertex{};
        vertex[axis_] = rises_ ? range_[axis_][0] + number : range_[axis_][1] - number;
        vertex[u_] = range_[u_][0] + at[0];
        vertex[v_] = range_[v_][0] + at[1];
        return vertex;
    }
    int steps(std::size_t along) const { return range_[along][1] - range_[along][0]; }

    std::array<std::array<int, 2>, 3> range_;
    std::size_t axis_, u_, v_;
    bool rises_;
    int last_, wide_, high_, coarsest_;
    std::vector<Column> columns_;
};

} // namespace isomotion::topology
