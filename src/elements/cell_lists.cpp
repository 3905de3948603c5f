#include "elements/cell_lists.h"

#include <stdexcept>

#include <fmt/format.h>

#include "base/workers.h"

namespace isomotion::elements {

CellLists::CellLists(ElementGrid& grid, const Region& region, std::span<const LevelSet> sets,
                     int each, const GridLimits& limits)
    : grid_(grid)
    , placing_(region, grid.across)
    , sets_(sets)
    , blocks_(sets.size())
    , each_(std::size_t(each))
    , threads_(limits.threads)
    , parts_(std::min(grid.across.z, 4 * limits.threads)) {
    for (std::size_t k = 0; k < sets.size(); ++k) blocks_[k] = placing_.block(sets[k]);
}

int CellLists::first_layer(std::size_t part) const {
    return int(part * std::size_t(grid_.across.z) / std::size_t(parts_));
}

// Calls found(element, cell, set, root) for all sets in ascending order that meet a cell, and with
// `once` for the first set of an element alone.
template<class Found>
void CellLists::for_each_entry(std::size_t part, bool once, Found&& found) const {
    const std::size_t layer = std::size_t(grid_.across.x) * std::size_t(grid_.across.y);
    const int begin = first_layer(part), end = first_layer(part + 1);
    std::vector<std::uint32_t> last(once && each_ > 1 ? layer * std::size_t(end - begin) : 0, ~0u);
    Placing::Meeting meets(placing_);
    for (std::size_t k = 0; k < sets_.size(); ++k) {
        const auto element = std::uint32_t(k / each_);
        const auto& [low, high] = blocks_[k];
        if (high.z < begin || low.z >= end) continue;
        meets.take(sets_[k], blocks_[k]);
        for (int z = std::max(low.z, begin); z <= std::min(high.z, end - 1); ++z) {
            for (int y = low.y; y <= high.y; ++y) {
                const std::size_t row =
                    std::size_t(z * grid_.across.y + y) * std::size_t(grid_.across.x);
                for (int x = low.x; x <= high.x; ++x) {
                    const std::size_t cell = row + std::size_t(x);
                    const double root = meets({x, y, z});
                    if (root > 1) continue;
                    if (!last.empty()) {
                        std::uint32_t& seen = last[cell - std::size_t(begin) * layer];
                        if (seen == element) continue;
                        seen = element;
                    }
                    found(element, cell, int(k % each_), root);
                }
            }
        }
    }
}

void CellLists::fill(CellSums& sums) {
    const base::SharedLoop over_parts{std::size_t(parts_), threads_};
    base::share(over_parts, [&] {
        return [&](std::size_t part) {
            for_each_entry(part, true,
                           [&](std::uint32_t element, std::size_t cell, int set, double root) {
                               ++grid_.cells[cell].packed;
                               if (each_ == 1) sums.add(element, set, root, cell);
                           });
            if (each_ == 1) return;
            for_each_entry(part, false,
                           [&](std::uint32_t element, std::size_t cell, int set, double root) {
                               sums.add(element, set, root, cell);
                           });
        };
    });
    std::uint32_t begin = 0;
    for (Cell& cell : grid_.cells) {
        cell.first = begin;
        begin += cell.packed;
        grid_.longest = std::max(grid_.longest, cell.packed);
    }
    if (grid_.longest > Cell::most_elements) {
        throw std::length_error(
            fmt::format("{} elements of an array matter at one place; a list holds {}",
                        grid_.longest, Cell::most_elements));
    }
    grid_.listed.resize(begin);
    std::vector<std::uint32_t> next;
    for (const Cell& cell : grid_.cells) next.push_back(cell.first);
    base::share(over_parts, [&] {
        return [&](std::size_t part) {
            for_each_entry(part, true, [&](std::uint32_t element, std::size_t cell, int, double) {
                grid_.listed[next[cell]++] = element;
            });
        };
    });
}

} // namespace isomotion::elements
