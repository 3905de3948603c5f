#include "elements/element_grid.h"

#include <algorithm>
#include <cmath>

#include "elements/cell_lists.h"
#include "elements/free_cells.h"
#include "elements/placing.h"

namespace isomotion::elements {
namespace {

using Kind = LevelSet::Kind;

// Along an axis on which nothing depends one cell is enough.
glm::ivec3 cells_of(const Region& region, double side, int most, const glm::bvec3& is_flat) {
    const glm::dvec3 wanted = glm::ceil((region.high - region.low) / side);
    const glm::ivec3 cells(
        glm::clamp(wanted, glm::dvec3(1), glm::dvec3(std::min(most, GridLimits::most_across))));
    return glm::mix(cells, glm::ivec3(1), is_flat);
}

// A cell's side for elements of these sizes: half of a half axis.
double wanted_side(std::span<const LevelSet> sets, const Region& region) {
    double sum = 0, count = 0;
    for (const LevelSet& set : sets) {
        if (set.kind != Kind::bounded) continue;
        for (int k = 0; k < 3; ++k) {
            if (set.is_flat[k]) continue;
            sum += set.half[k];
            count += 1;
        }
    }
    const double widest = glm::length(region.high - region.low);
    if (count == 0) return widest;
    return std::clamp(0.5 * sum / count, 1e-4 * widest, widest);
}

double entries(std::span<const LevelSet> sets, const Placing& placing) {
    double all = 0;
    for (const LevelSet& set : sets) all += placing.block(set).cells();
    return all;
}

// A grid whose cells are as fine as half of the sets' mean size, or coarser where limits ask for
// it.
glm::ivec3 fitting(const Region& region, std::span<const LevelSet> sets, double most_cells,
                   const glm::bvec3& is_flat, const GridLimits& limits) {
    for (double side = wanted_side(sets, region);; side *= 1.2) {
        const glm::ivec3 across = cells_of(region, side, limits.across, is_flat);
        const glm::dvec3 cells(across);
        const bool is_small = cells.x * cells.y * cells.z <= most_cells &&
                              entries(sets, Placing(region, across)) <= double(limits.listed);
        if (is_small || across == glm::ivec3(1)) return across;
    }
}

} // namespace

glm::bvec3 flat_axes(std::span<const LevelSet> sets) {
    glm::bvec3 flat(false);
    bool is_first = true;
    for (const LevelSet& set : sets) {
        if (set.kind != Kind::bounded) continue;
        for (int k = 0; k < 3; ++k) flat[k] = (is_first || flat[k]) && set.is_flat[k];
        is_first = false;
    }
    return flat;
}

double cells_worth_while(std::size_t elements) {
    constexpr double of_an_element = 8, at_least = 32 * 32 * 32;
    return std::max(at_least, of_an_element * double(elements));
}

int ElementGrid::usual_count() const {
    double entries = 0, squares = 0;
    for (const Cell& cell : cells) {
        entries += cell.elements();
        squares += double(cell.elements()) * cell.elements();
    }
    return entries > 0 ? int(squares / entries) : 0;
}

ElementGrid make_grid(const Region& region, std::span<const LevelSet> sets, int each,
                      const RootFree& root_free, const GridLimits& limits) {
    const std::size_t elements = sets.size() / std::size_t(each);
    const glm::bvec3 is_flat = flat_axes(sets);
    ElementGrid grid;
    grid.low = region.low;
    grid.across = fitting(region, sets, cells_worth_while(elements), is_flat, limits);
    grid.cell = Placing(region, grid.across).cell();
    const glm::dvec3 across(grid.across);
    grid.cells.resize(std::size_t(across.x * across.y * across.z));
    CellSums sums(root_free, grid.cells.size());
    CellLists(grid, region, sets, each, limits).fill(sums);
    find_free_cells(grid, region, sums, root_free, is_flat, limits);
    return grid;
}

} // namespace isomotion::elements
