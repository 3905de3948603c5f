#include "elements/element_grid.h"

#include <algorithm>
#include <cmath>

#include "base/workers.h"

namespace isomotion::elements {
namespace {

using Kind = LevelSet::Kind;

// More cells than that take more time than shorter lists save.
constexpr double cells_an_element = 8, fewest_cells = 32 * 32 * 32;

// Cells from first to last, both included, on each axis.
struct Block {
    glm::ivec3 first{0}, last{-1};

    double cells() const {
        const glm::dvec3 side(last - first + 1);
        return side.x * side.y * side.z;
    }
};

class Placing {
public:
    Placing(const Region& region, const glm::ivec3& across)
        : low_(region.low)
        , cell_((region.high - region.low) / glm::dvec3(across))
        , across_(across)
        // Shaders compute a place's cell in float32.
        , slack_(0x1p-14 * cell_ + 0x1p-21 * (glm::abs(region.low) + glm::abs(region.high))) {}

    const glm::dvec3& cell() const { return cell_; }

    Block block(const LevelSet& set) const {
        Block cells;
        if (set.kind == Kind::empty) return cells;
        if (set.kind == Kind::unbounded) return {glm::ivec3(0), across_ - 1};
        const glm::dvec3 least = set.centre - set.half - slack_ - low_;
        const glm::dvec3 most = set.centre + set.half + slack_ - low_;
        for (int k = 0; k < 3; ++k) {
            // Places outside of the grid belong to its outermost cells.
            const double end = across_[k] - 1;
            cells.first[k] = int(std::clamp(std::floor(least[k] / cell_[k]), 0.0, end));
            cells.last[k] = int(std::clamp(std::floor(most[k] / cell_[k]), 0.0, end));
        }
        return cells;
    }

    // Whether the set may meet the cell, of those of its block.
    class Meeting {
    public:
        Meeting(const Placing& of, const LevelSet& set)
            : of_(of)
            , set_(set) {
            if (set.kind != Kind::bounded || set.is_round) return;
            const glm::dvec3 corner = 0.5 * of.cell_ + of.slack_;
            for (const glm::dvec3 sign : {glm::dvec3(1, 1, 1), glm::dvec3(1, 1, -1),
                                          glm::dvec3(1, -1, 1), glm::dvec3(-1, 1, 1)}) {
                const glm::dvec3 d = sign * corner;
                half_cell_ = std::max(half_cell_, glm::dot(d, set.form * d));
            }
            half_cell_ = std::sqrt(half_cell_);
        }

        bool operator()(const glm::ivec3& place) const {
            if (set_.kind == Kind::unbounded) return true;
            const glm::dvec3 middle = of_.low_ + (glm::dvec3(place) + 0.5) * of_.cell_;
            const glm::dvec3 off = middle - set_.centre;
            if (set_.is_round) {
                // The nearest place of the cell. Border cells hold all that is beyond them.
                const glm::dvec3 near =
                    glm::max(glm::abs(off) - 0.5 * of_.cell_ - of_.slack_, 0.0) / set_.half;
                return glm::dot(near, near) <= 1 || is_on_border(place);
            }
            // The form's root is a norm: no place of the cell is nearer than its middle by more
            // than half of the cell's diagonal.
            return std::sqrt(glm::dot(off, set_.form * off)) <= 1 + half_cell_ ||
                   is_on_border(place);
        }

    private:
        bool is_on_border(const glm::ivec3& place) const {
            return glm::any(glm::equal(place, glm::ivec3(0))) ||
                   glm::any(glm::equal(place, of_.across_ - 1));
        }

        const Placing& of_;
        const LevelSet& set_;
        double half_cell_ = 0; // in the form's norm
    };

private:
    glm::dvec3 low_, cell_;
    glm::ivec3 across_;
    glm::dvec3 slack_;
};

glm::ivec3 cells_of(const Region& region, double side, int most) {
    const glm::dvec3 wanted = glm::ceil((region.high - region.low) / side);
    return glm::ivec3(glm::clamp(wanted, glm::dvec3(1), glm::dvec3(most)));
}

// A cell's side for elements of these sizes: half of a half axis.
double wanted_side(std::span<const LevelSet> sets, const Region& region) {
    double sum = 0, count = 0;
    for (const LevelSet& set : sets) {
        if (set.kind != Kind::bounded) continue;
        sum += (set.half.x + set.half.y + set.half.z) / 3;
        count += 1;
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

// How many cells around each empty one are empty too: distances on a chessboard, in two passes
// over all cells (Rosenfeld & Pfaltz 1968).
void measure_emptiness(ElementGrid& grid) {
    const auto [nx, ny, nz] = std::array{grid.across.x, grid.across.y, grid.across.z};
    const auto at = [&](int x, int y, int z) -> std::uint32_t& {
        return grid.cells[std::size_t((z * ny + y) * nx + x)].first;
    };
    constexpr std::uint32_t far = 1u << 20; // outside of the grid there is no element
    std::vector<std::uint32_t> steps(grid.cells.size());
    for (std::size_t k = 0; k < steps.size(); ++k) steps[k] = grid.cells[k].elements == 0 ? far : 0;
    const auto step = [&](int x, int y, int z) -> std::uint32_t {
        const bool inside = x >= 0 && y >= 0 && z >= 0 && x < nx && y < ny && z < nz;
        return inside ? steps[std::size_t((z * ny + y) * nx + x)] : far;
    };
    const auto lower = [&](int x, int y, int z, int sign) {
        std::uint32_t& here = steps[std::size_t((z * ny + y) * nx + x)];
        if (here == 0) return;
        std::uint32_t least = far;
        // The 13 neighbours that come before, or after.
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx)
                least = std::min(least, step(x + dx, y + dy, z - sign));
        }
        for (int dx = -1; dx <= 1; ++dx) least = std::min(least, step(x + dx, y - sign, z));
        least = std::min(least, step(x - sign, y, z));
        here = std::min(here, least + 1);
    };
    for (int z = 0; z < nz; ++z)
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) lower(x, y, z, 1);
    for (int z = nz; z-- > 0;)
        for (int y = ny; y-- > 0;)
            for (int x = nx; x-- > 0;) lower(x, y, z, -1);
    for (int z = 0; z < nz; ++z) {
        for (int y = 0; y < ny; ++y) {
            for (int x = 0; x < nx; ++x) {
                const std::uint32_t steps_here = step(x, y, z);
                if (steps_here > 0) at(x, y, z) = std::min(steps_here, far) - 1;
            }
        }
    }
}

} // namespace

ElementGrid make_grid(const Region& region, std::span<const LevelSet> sets, int each,
                      const GridLimits& limits) {
    ElementGrid grid;
    grid.low = region.low;
    double side = wanted_side(sets, region);
    const double most_cells =
        std::max(fewest_cells, cells_an_element * double(sets.size() / std::size_t(each)));
    for (;; side *= 1.2) {
        grid.across = cells_of(region, side, limits.across);
        if (grid.across == glm::ivec3(1)) break;
        const glm::dvec3 across(grid.across);
        if (across.x * across.y * across.z <= most_cells &&
            entries(sets, Placing(region, grid.across)) <= double(limits.listed)) {
            break;
        }
    }
    const Placing placing(region, grid.across);
    grid.cell = placing.cell();
    std::vector<Block> blocks(sets.size());
    for (std::size_t k = 0; k < sets.size(); ++k) blocks[k] = placing.block(sets[k]);

    const std::size_t layer = std::size_t(grid.across.x) * std::size_t(grid.across.y);
    grid.cells.resize(layer * std::size_t(grid.across.z));
    // Each turn has some layers of cells to itself.
    const int parts = std::min(grid.across.z, 4 * limits.threads);
    const auto first_layer = [&](std::size_t part) {
        return int(part * std::size_t(grid.across.z) / std::size_t(parts));
    };
    // Calls found(element, cell) for all elements in ascending order; an element that is in a cell
    // by several sets counts once.
    const auto for_each_entry = [&](std::size_t part, auto&& found) {
        const int begin = first_layer(part), end = first_layer(part + 1);
        std::vector<std::uint32_t> last(each > 1 ? layer * std::size_t(end - begin) : 0, ~0u);
        for (std::size_t k = 0; k < sets.size(); ++k) {
            const auto element = std::uint32_t(k / std::size_t(each));
            const auto& [low, high] = blocks[k];
            if (high.z < begin || low.z >= end) continue;
            const Placing::Meeting meets(placing, sets[k]);
            for (int z = std::max(low.z, begin); z <= std::min(high.z, end - 1); ++z) {
                for (int y = low.y; y <= high.y; ++y) {
                    const std::size_t row =
                        std::size_t(z * grid.across.y + y) * std::size_t(grid.across.x);
                    for (int x = low.x; x <= high.x; ++x) {
                        const std::size_t cell = row + std::size_t(x);
                        if (each > 1) {
                            std::uint32_t& seen = last[cell - std::size_t(begin) * layer];
                            if (seen == element || !meets({x, y, z})) continue;
                            seen = element;
                        } else if (!meets({x, y, z})) {
                            continue;
                        }
                        found(element, cell);
                    }
                }
            }
        }
    };
    const base::SharedLoop over_parts{std::size_t(parts), limits.threads};
    base::share(over_parts, [&] {
        return [&](std::size_t part) {
            for_each_entry(part,
                           [&](std::uint32_t, std::size_t cell) { ++grid.cells[cell].elements; });
        };
    });
    std::uint32_t begin = 0;
    for (Cell& cell : grid.cells) {
        cell.first = begin;
        begin += cell.elements;
        grid.longest = std::max(grid.longest, cell.elements);
    }
    grid.listed.resize(begin);
    std::vector<std::uint32_t> next(grid.cells.size());
    for (std::size_t k = 0; k < next.size(); ++k) next[k] = grid.cells[k].first;
    base::share(over_parts, [&] {
        return [&](std::size_t part) {
            for_each_entry(part, [&](std::uint32_t element, std::size_t cell) {
                grid.listed[next[cell]++] = element;
            });
        };
    });
    measure_emptiness(grid);
    return grid;
}

} // namespace isomotion::elements
