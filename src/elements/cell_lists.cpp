#include "elements/cell_lists.h"

#include <optional>
#include <stdexcept>
#include <utility>

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

// Calls at(set, y, z) for all sets in ascending order and all rows of their blocks in the part.
template<class At> void CellLists::for_each_row(std::size_t part, At&& at) const {
    const int begin = first_layer(part), end = first_layer(part + 1);
    for (std::size_t k = 0; k < blocks_.size(); ++k) {
        const auto& [low, high] = blocks_[k];
        for (int z = std::max(low.z, begin); z <= std::min(high.z, end - 1); ++z)
            for (int y = low.y; y <= high.y; ++y) at(k, y, z);
    }
}

// Calls found(set, run, cell) for all rows in which a set meets cells, of which the run's first is
// that cell of the grid.
template<class Found>
void CellLists::for_each_run(std::size_t part, std::span<const Run> runs, Found&& found) const {
    auto next = runs.begin();
    for_each_row(part, [&](std::size_t k, int y, int z) {
        const Run run = *next++;
        if (run.is_empty()) return;
        const int cell = (z * grid_.across.y + y) * grid_.across.x + run.first;
        found(k, run, std::size_t(cell));
    });
}

// Looks at the cells of rows for terms that matter there, of sets that are boxes.
class CellLists::RowInBox {
public:
    RowInBox(const Placing& placing, const CellSums& sums)
        : placing_(placing)
        , root_free_(sums.root_free())
        , terms_(*root_free_.terms) {}

    // The cells of a row where the element's terms matter, within these; adds their sizes.
    Run look(int element, int k, const glm::ivec3& first, int last, std::size_t cell,
             CellSums& sums) {
        boxes_.assign(1, box(first, {last, first.y, first.z}));
        terms_.look(element, boxes_);
        if (!terms_.matters(k, root_free_.tolerance, 0)) return {};
        boxes_.clear();
        for (glm::ivec3 at = first; at.x <= last; ++at.x) boxes_.push_back(box(at, at));
        terms_.look(element, boxes_);
        std::size_t begin = 0, end = boxes_.size();
        const auto matters = [&](std::size_t at) {
            return terms_.matters(k, root_free_.tolerance, at);
        };
        while (begin < end && !matters(begin)) ++begin;
        while (begin < end && !matters(end - 1)) --end;
        if (begin == end) return {};
        for (std::size_t sum = 0; sum < sums.sums(); ++sum) {
            if (root_free_.quadric_of[sum] != k) continue;
            for (std::size_t at = begin; at < end; ++at)
                sums.add(sum, terms_.size(int(sum), at), cell + at);
        }
        return {std::uint8_t(first.x + int(begin)), std::uint8_t(first.x + int(end) - 1)};
    }

private:
    std::array<Interval, 3> box(const glm::ivec3& from, const glm::ivec3& to) const {
        const glm::dvec3 low = placing_.box(from).first, high = placing_.box(to).second;
        return {Interval(low.x, high.x), Interval(low.y, high.y), Interval(low.z, high.z)};
    }

    const Placing& placing_;
    const RootFree& root_free_;
    ElementTerms::Boxes terms_;
    std::vector<std::array<Interval, 3>> boxes_;
};

// The runs of all rows of the part, in their order; and the sums.
std::vector<CellLists::Run> CellLists::meet(std::size_t part, CellSums& sums) const {
    std::vector<Run> runs;
    Placing::Meeting meets(placing_);
    std::optional<RowInBox> in_box;
    if (sums.root_free().terms) in_box.emplace(placing_, sums);
    std::size_t taken = sets_.size();
    for_each_row(part, [&](std::size_t k, int y, int z) {
        const int row = (z * grid_.across.y + y) * grid_.across.x;
        if (in_box && sets_[k].is_box) {
            const int first = blocks_[k].first.x;
            runs.push_back(in_box->look(int(k / each_), int(k % each_), {first, y, z},
                                        blocks_[k].last.x, std::size_t(row + first), sums));
            return;
        }
        if (k != taken) meets.take(sets_[k], blocks_[k]);
        taken = k;
        const auto [first, last] = meets.row(y, z);
        runs.push_back(first <= last ? Run{std::uint8_t(first), std::uint8_t(last)} : Run{});
        if (first > last) return;
        sums.add(std::uint32_t(k / each_), int(k % each_), meets.roots(first, last),
                 std::size_t(row + first));
    });
    return runs;
}

// The cells, in a part of the grid, in which an element was found by one of its sets.
class CellLists::Seen {
public:
    Seen(const CellLists& of, std::size_t part) {
        if (of.each_ == 1) return;
        const std::size_t layer = std::size_t(of.grid_.across.x) * std::size_t(of.grid_.across.y);
        begin_ = std::size_t(of.first_layer(part)) * layer;
        last_.assign(std::size_t(of.first_layer(part + 1)) * layer - begin_, ~0u);
    }
    bool is_first(std::uint32_t element, std::size_t cell) {
        if (last_.empty()) return true;
        return std::exchange(last_[cell - begin_], element) != element;
    }

private:
    std::size_t begin_ = 0;
    std::vector<std::uint32_t> last_; // element of each cell; empty where elements have one set
};

void CellLists::fill(CellSums& sums) {
    const base::SharedLoop over_parts{std::size_t(parts_), threads_};
    std::vector<std::vector<Run>> runs(over_parts.count);
    base::share(over_parts, [&] {
        return [&](std::size_t part) {
            runs[part] = meet(part, sums);
            Seen seen(*this, part);
            for_each_run(part, runs[part], [&](std::size_t k, Run run, std::size_t cell) {
                const auto element = std::uint32_t(k / each_);
                for (const std::size_t end = cell + run.cells(); cell < end; ++cell)
                    grid_.cells[cell].packed += seen.is_first(element, cell) ? 1 : 0;
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
            Seen seen(*this, part);
            for_each_run(part, runs[part], [&](std::size_t k, Run run, std::size_t cell) {
                const auto element = std::uint32_t(k / each_);
                for (const std::size_t end = cell + run.cells(); cell < end; ++cell) {
                    if (seen.is_first(element, cell)) grid_.listed[next[cell]++] = element;
                }
            });
        };
    });
}

} // namespace isomotion::elements
