#include "elements/least_in_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "base/workers.h"
#include "elements/placing.h"

namespace isomotion::elements {
namespace {

constexpr std::uint32_t longest_kept = 24; // lists up to that are not looked at
// Cells are divided while their lists are longer, and the parts' lists so much shorter.
constexpr int crowded = 32;
constexpr double shorter = 0.9;
constexpr std::size_t most_entries = 1 << 23;
constexpr std::size_t elements_at_a_time = 64; // that a thread takes
constexpr float same_key = 0x1p-14f; // keys that differ by this part may be equal in float32
constexpr float infinite = std::numeric_limits<float>::infinity();

// An element in a cell's list.
struct Entry {
    std::uint32_t cell = 0, at = 0; // place in `listed`
};

struct KeyBounds {
    float low = -infinite, high = infinite;
};

std::array<Interval, 3> box_of(const ElementGrid& grid, const Placing& placing, std::size_t cell) {
    const std::size_t row = cell / std::size_t(grid.across.x);
    const glm::ivec3 place(cell % std::size_t(grid.across.x), row % std::size_t(grid.across.y),
                           row / std::size_t(grid.across.y));
    auto [low, high] = placing.box(place);
    for (int k = 0; k < 3; ++k) {
        if (place[k] == 0) low[k] -= grid.cell[k];
        if (place[k] + 1 == grid.across[k]) high[k] += grid.cell[k];
    }
    return {Interval(low.x, high.x), Interval(low.y, high.y), Interval(low.z, high.z)};
}

// The entries of long lists, those of each element together: element e has those from begins[e] to
// begins[e + 1].
struct EntriesOfElements {
    std::vector<std::size_t> begins;
    std::vector<Entry> entries;

    EntriesOfElements(const ElementGrid& grid, std::size_t elements)
        : begins(elements + 1) {
        for_each_long(grid, [&](std::size_t, std::uint32_t at) { ++begins[grid.listed[at] + 1]; });
        std::partial_sum(begins.begin(), begins.end(), begins.begin());
        entries.resize(begins.back());
        std::vector<std::size_t> next = begins;
        for_each_long(grid, [&](std::size_t cell, std::uint32_t at) {
            entries[next[grid.listed[at]]++] = {std::uint32_t(cell), at};
        });
    }

    template<class At> static void for_each_long(const ElementGrid& grid, At&& at) {
        for (std::size_t cell = 0; cell < grid.cells.size(); ++cell) {
            const Cell& list = grid.cells[cell];
            if (list.elements() <= longest_kept) continue;
            for (std::uint32_t k = 0; k < list.elements(); ++k) at(cell, list.first + k);
        }
    }
};

// Bounds of the keys of all entries of long lists, in the order of `listed`.
std::vector<KeyBounds> bounds_of_keys(const ElementGrid& grid, const Region& region,
                                      const ElementTerms& terms, const EntriesOfElements& of,
                                      int threads) {
    std::vector<KeyBounds> bounds(grid.listed.size());
    const Placing placing(region, grid.across);
    const std::size_t elements = of.begins.size() - 1;
    base::share({(elements + elements_at_a_time - 1) / elements_at_a_time, threads}, [&] {
        return [&, boxes = ElementTerms::Boxes(terms),
                places = std::vector<std::array<Interval, 3>>()](std::size_t turn) mutable {
            const std::size_t end = std::min(elements, (turn + 1) * elements_at_a_time);
            for (std::size_t element = turn * elements_at_a_time; element < end; ++element) {
                const std::span<const Entry> own(&of.entries[0] + of.begins[element],
                                                 of.begins[element + 1] - of.begins[element]);
                if (own.empty()) continue;
                places.clear();
                for (const Entry& entry : own) places.push_back(box_of(grid, placing, entry.cell));
                boxes.look(int(element), places);
                for (std::size_t k = 0; k < own.size(); ++k) {
                    const Interval& key = boxes.term(0, k);
                    bounds[own[k].at] = {std::nextafter(float(key.lo), -infinite),
                                         std::nextafter(float(key.hi), infinite)};
                }
            }
        };
    });
    return bounds;
}

void shorten(ElementGrid& grid, const Region& region, const ElementTerms& terms, int threads) {
    const EntriesOfElements of(grid, std::size_t(terms.count()));
    if (of.entries.empty()) return;
    const std::vector<KeyBounds> keys = bounds_of_keys(grid, region, terms, of, threads);
    grid.longest = 0;
    std::uint32_t kept = 0; // entries so far
    for (Cell& cell : grid.cells) {
        const std::uint32_t count = cell.elements(), first = kept;
        if (count == 0) continue; // `first` says something else
        float enough = infinite;
        for (std::uint32_t k = cell.first; k < cell.first + count; ++k)
            enough = std::fmin(enough, keys[k].high); // unless that is NaN
        enough += same_key * std::abs(enough);
        for (std::uint32_t k = cell.first; k < cell.first + count; ++k) {
            if (!(keys[k].low > enough)) grid.listed[kept++] = grid.listed[k];
        }
        cell.packed = cell.packed - count + (kept - first);
        cell.first = first;
        grid.longest = std::max(grid.longest, kept - first);
    }
    grid.listed.resize(kept);
}

// The grid with cells of half the sides. What was known of a cell holds for its parts.
ElementGrid divided(const ElementGrid& grid, const glm::ivec3& parts) {
    ElementGrid fine;
    fine.array = grid.array;
    fine.low = grid.low;
    fine.across = parts * grid.across;
    fine.cell = grid.cell / glm::dvec3(parts);
    fine.longest = grid.longest;
    fine.left_out = grid.left_out;
    fine.least = grid.least;
    const int least_parts = std::min({parts.x, parts.y, parts.z});
    for (int z = 0; z < fine.across.z; ++z) {
        for (int y = 0; y < fine.across.y; ++y) {
            for (int x = 0; x < fine.across.x; ++x) {
                const Cell& whole = grid.at(glm::ivec3(x, y, z) / parts);
                Cell part = whole;
                if (whole.elements() == 0) {
                    part.first = std::uint32_t(least_parts) * whole.first;
                } else {
                    part.first = std::uint32_t(fine.listed.size());
                    const auto list = grid.list(whole);
                    fine.listed.insert(fine.listed.end(), list.begin(), list.end());
                }
                if (const std::uint32_t free = whole.free(); free > 0) {
                    const auto around = std::uint32_t(least_parts) * (free - 1);
                    part.packed = whole.elements() | std::min(around + 1, Cell::most_free)
                                                         << Cell::count_bits;
                }
                fine.cells.push_back(part);
            }
        }
    }
    return fine;
}

} // namespace

void keep_possible_least(ElementGrid& grid, const Region& region, const ElementTerms& terms,
                         const glm::bvec3& is_flat, const GridLimits& limits) {
    const std::size_t most_listed = std::min(most_entries, limits.listed);
    if (grid.longest <= longest_kept || grid.listed.size() > most_listed) return;
    std::size_t entries = 0;
    for (const Cell& cell : grid.cells) entries += cell.elements();
    if (entries != grid.listed.size()) return; // layers along a flat axis share their lists
    shorten(grid, region, terms, limits.threads);
    const glm::ivec3 parts = glm::mix(glm::ivec3(2), glm::ivec3(1), is_flat);
    const auto times = std::size_t(parts.x * parts.y * parts.z);
    const double most = cells_worth_while(std::size_t(terms.count()));
    while (times > 1 && grid.usual_count() > crowded && double(times * grid.cells.size()) <= most &&
           times * grid.listed.size() <= most_listed &&
           glm::all(glm::lessThanEqual(parts * grid.across, glm::ivec3(limits.across)))) {
        ElementGrid fine = divided(grid, parts);
        shorten(fine, region, terms, limits.threads);
        const bool has_few_cells = fine.cells.size() < 512; // as wide as the outermost ones count
        if (!has_few_cells && fine.usual_count() > shorter * grid.usual_count()) break;
        grid = std::move(fine);
    }
}

} // namespace isomotion::elements
