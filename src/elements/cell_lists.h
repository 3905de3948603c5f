// Computes the lists of a grid's cells, and bounds of the sums in them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "elements/element_grid.h"
#include "elements/element_terms.h"
#include "elements/placing.h"

namespace isomotion::elements {

// Bounds of the sums over the elements that matter in a cell, including the elements left out.
class CellSums {
public:
    CellSums(const RootFree& root_free, std::size_t cells)
        : root_free_(root_free)
        , sums_(root_free.at_most.size())
        , has_levels_(std::ranges::all_of(root_free.at_most, [](double s) { return s > 0; }))
        , bounds_(cells * sums_, is_least() ? root_free.least : 0.0f) {}

    bool is_least() const { return root_free_.at_least.has_value(); }

    // Adds an element's level set of quadric k. `roots` are lower bounds of its form's root in a
    // run of cells.
    void add(std::uint32_t element, int k, std::span<const double> roots, std::size_t first) {
        constexpr int shells = ElementTerms::shells;
        for (std::size_t sum = 0; sum < sums_; ++sum) {
            if (root_free_.quadric_of[sum] != k) continue;
            const std::span<const float> sizes =
                root_free_.sizes.subspan((element * sums_ + sum) * shells, shells);
            float* bound = &bounds_[first * sums_ + sum];
            for (const double root : roots) {
                const float size = sizes[std::size_t(std::min(int(root * shells), shells - 1))];
                *bound = is_least() ? std::min(*bound, size) : *bound + size;
                bound += sums_;
            }
        }
    }
    // Adds an element whose size in a cell is known, as ElementTerms::sizes() gives it.
    void add(std::size_t sum, float size, std::size_t cell) {
        float& bound = bounds_[cell * sums_ + sum];
        bound = is_least() ? std::min(bound, size) : bound + size;
    }
    const RootFree& root_free() const { return root_free_; }
    bool are_free(std::size_t cell, std::uint32_t elements) const {
        if (elements == 0 && root_free_.is_emptiness) return true;
        if (const auto& at_least = root_free_.at_least) return double(bounds_[cell]) >= *at_least;
        if (sums_ == 0 || !has_levels_) return false;
        for (std::size_t sum = 0; sum < sums_; ++sum) {
            if (!(bound(cell, sum, elements) <= root_free_.at_most[sum])) return false;
        }
        return true;
    }
    // Bounds of a sum in a cell, without the elements that lists leave out.
    Interval sum(std::size_t cell, std::size_t sum, std::uint32_t elements) const {
        if (is_least()) return {double(bounds_[cell]), formula::infinity};
        return root_free_.signs[sum] * Interval(0.0, bound(cell, sum, elements));
    }
    // An upper bound of the size of a sum over the listed elements.
    double bound(std::size_t cell, std::size_t sum, std::uint32_t elements) const {
        // The additions are in floats and each is rounded.
        return (1 + 0x1p-23 * (elements + 1.0)) * double(bounds_[cell * sums_ + sum]);
    }
    std::size_t sums() const { return sums_; }

private:
    const RootFree& root_free_;
    std::size_t sums_;
    bool has_levels_;
    std::vector<float> bounds_;
};

// Fills the lists of a grid whose size is set, and the sums of its cells.
class CellLists {
public:
    // `sets`: `each` level sets of the first element, then of the next. All arguments must outlive
    // this object.
    CellLists(ElementGrid& grid, const Region& region, std::span<const LevelSet> sets, int each,
              const GridLimits& limits);

    // Throws std::length_error if more than Cell::most_elements matter in one cell.
    void fill(CellSums& sums);

private:
    class Seen;
    class RowInBox;
    // The cells of a row that a set meets, both ends included.
    struct Run {
        std::uint8_t first = 1, last = 0;
        bool is_empty() const { return first > last; }
        std::size_t cells() const { return std::size_t(last - first + 1); }
    };
    static_assert(GridLimits::most_across <= 256);

    template<class At> void for_each_row(std::size_t part, At&& at) const;
    template<class Found>
    void for_each_run(std::size_t part, std::span<const Run> runs, Found&& found) const;
    std::vector<Run> meet(std::size_t part, CellSums& sums) const;
    int first_layer(std::size_t part) const;

    ElementGrid& grid_;
    Placing placing_;
    std::span<const LevelSet> sets_;
    std::vector<Block> blocks_;
    std::size_t each_;
    int threads_;
    int parts_; // tasks, each with some layers of cells of its own
};

} // namespace isomotion::elements
