// A grid over the bounds. Each cell has the list of the elements that matter in it.
//
// It is made for each frame, from that frame's values alone. Rays of any kind, and boxes around
// pieces of them, find their elements by place. They also find cells in which F has no root,
// because no element matters there or those that do add up to too little.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "elements/quadric.h"
#include "elements/sums_at_roots.h"
#include "formula/graph/operations.h"

namespace isomotion::elements {

using formula::Interval;

// In the layout that shaders read.
struct Cell {
    static constexpr int count_bits = 20;
    static constexpr std::uint32_t most_elements = (1u << count_bits) - 1;
    static constexpr std::uint32_t most_free = (1u << (32 - count_bits)) - 1;

    // Number of elements that matter; in the upper bits, the free distance.
    std::uint32_t packed = 0;
    // Where its list begins. For an empty cell: the number of cells on each side of it, in all
    // directions, that are empty as well.
    std::uint32_t first = 0;

    std::uint32_t elements() const { return packed & most_elements; }
    // 0 if F may have a root; k if F has none in the cell and in the k - 1 cells on each side of
    // it, in all directions, or these are outside of the grid.
    std::uint32_t free() const { return packed >> count_bits; }

    bool operator==(const Cell&) const = default;
};

struct ElementGrid {
    int array = 0;              // index among the field's
    glm::dvec3 low{0}, cell{1}; // the corner and the sides of a cell
    glm::ivec3 across{1};       // cells
    std::vector<Cell> cells;    // x fastest, then y
    std::vector<std::uint32_t> listed;
    std::uint32_t longest = 0; // length of the longest list
    // Bounds of what lists leave out of each sum; 0 if the terms left out are 0.
    std::vector<double> left_out;
    // If F asks for the least element: one left out of a list has no smaller key, or one of the
    // list is less all over the cell. The roots stay the same if this value replaces any larger
    // key.
    float least = formula::Operations<float>::least_of_none();

    const Cell& at(const glm::ivec3& place) const {
        return cells[std::size_t((place.z * across.y + place.y) * across.x + place.x)];
    }
    // The cell of a place, or the nearest cell of the grid.
    glm::ivec3 place(const glm::dvec3& p) const {
        return glm::clamp(glm::ivec3(glm::floor((p - low) / cell)), glm::ivec3(0), across - 1);
    }
    std::span<const std::uint32_t> list(const Cell& of) const {
        if (of.elements() == 0) return {};
        return std::span(listed).subspan(of.first, of.elements());
    }
    // The usual length of a list where there are elements: the mean over the entries of all lists,
    // as most rays may be where elements are crowded.
    int usual_count() const;
};

struct GridLimits {
    std::size_t listed = 1 << 24; // entries of all lists
    static constexpr int most_across = 256;
    int across = 160; // cells, at most most_across
    int threads = 1;
};

// The axes along which all sets that have bounds are flat.
glm::bvec3 flat_axes(std::span<const LevelSet> sets);
// More cells take more time than shorter lists save.
double cells_worth_while(std::size_t elements);

class ElementTerms;

// The data that show cells without roots: sums there are too small, or the least key is too large.
struct RootFree {
    std::span<const int> quadric_of; // for each sum
    std::span<const float> sizes{};  // ElementTerms::sizes() of all elements
    std::vector<double> at_most{};   // F has no root where each sum is at most this; 0: unknown
    // For a `least`: F has no root where it is at least this; infinite: unknown.
    std::optional<double> at_least{};
    float least = 0;           // as in the grid
    bool is_emptiness = false; // F has no root where there is no element
    // Otherwise: finds roots cell by cell, with bounds of the sums there.
    const SumsAtRoots* roots = nullptr;
    const formula::Bindings<float>* bindings = nullptr;
    // If some sets are boxes: the terms, which decide the cells of these that they meet, and the
    // tolerance of each sum's.
    const ElementTerms* terms = nullptr;
    std::span<const double> tolerance{};
    // For each sum: the part that lists leave out, and the signs of its terms, in [-1, 1].
    std::vector<Interval> left_out{}, signs{};
};

// `sets`: `each` level sets of the first element, then of the next. Lists hold elements in
// ascending order. The grid is as fine as half of the sets' mean size, and coarser if limits
// require it. The result is the same for any number of threads. Throws std::length_error if more
// than Cell::most_elements matter in one cell.
ElementGrid make_grid(const Region& region, std::span<const LevelSet> sets, int each,
                      const RootFree& root_free, const GridLimits& limits);

} // namespace isomotion::elements
