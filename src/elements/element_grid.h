// A grid over the bounds: each cell has the list of the elements that matter in it.
//
// Made anew for each frame, from that frame's values alone. Rays of any kind, and boxes around
// pieces of them, find their elements by place; where a cell has none, they learn how far around
// it there are none.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "elements/quadric.h"

namespace isomotion::elements {

struct Cell {
    std::uint32_t elements = 0; // that matter in it
    // Where its list begins; of an empty cell, how many cells on each side of it, in all
    // directions, are empty as well or lie outside.
    std::uint32_t first = 0;

    bool operator==(const Cell&) const = default;
};

struct ElementGrid {
    glm::dvec3 low{0}, cell{1}; // the corner and a cell's sides
    glm::ivec3 across{1};       // cells
    std::vector<Cell> cells;    // x fastest, then y
    std::vector<std::uint32_t> listed;
    std::uint32_t longest = 0; // list
    // Bounds of what lists leave out of each sum; 0: nothing, terms are 0 there.
    std::vector<double> left_out;
    // F has no root where no element matters.
    bool is_empty_free_of_roots = false;

    const Cell& at(const glm::ivec3& place) const {
        return cells[std::size_t((place.z * across.y + place.y) * across.x + place.x)];
    }
    // The cell of a place; of the nearest one in the grid.
    glm::ivec3 place(const glm::dvec3& p) const {
        return glm::clamp(glm::ivec3(glm::floor((p - low) / cell)), glm::ivec3(0), across - 1);
    }
    std::span<const std::uint32_t> list(const Cell& of) const {
        return std::span(listed).subspan(of.first, of.elements);
    }
};

struct GridLimits {
    std::size_t listed = 1 << 24; // entries of all lists
    int across = 160;             // cells
    int threads = 1;
};

// `sets`: `each` level sets of the first element, then of the next. Lists hold elements in
// ascending order. The grid is as fine as half of the sets' mean size, and coarser where limits
// ask for it. Equal for any number of threads.
ElementGrid make_grid(const Region& region, std::span<const LevelSet> sets, int each,
                      const GridLimits& limits);

} // namespace isomotion::elements
