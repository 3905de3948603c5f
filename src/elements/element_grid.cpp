#include "elements/element_grid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "base/workers.h"
#include "elements/element_terms.h"

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

    // All places that belong to a cell, and what rounding takes for them.
    std::pair<glm::dvec3, glm::dvec3> box(const glm::ivec3& place) const {
        const glm::dvec3 low = low_ + glm::dvec3(place) * cell_;
        return {low - slack_, low + cell_ + slack_};
    }

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

        // The least root of the form in the cell; above 1 if the set does not meet the cell.
        double operator()(const glm::ivec3& place) const {
            if (set_.kind == Kind::unbounded) return 0;
            const glm::dvec3 middle = of_.low_ + (glm::dvec3(place) + 0.5) * of_.cell_;
            const glm::dvec3 off = middle - set_.centre;
            double root;
            if (set_.is_round) {
                // The nearest place of the cell.
                const glm::dvec3 near =
                    glm::max(glm::abs(off) - 0.5 * of_.cell_ - of_.slack_, 0.0) / set_.half;
                root = glm::length(near);
            } else {
                // The form's root is a norm: no place of the cell is nearer than its middle by
                // more than half of the cell's diagonal.
                root = std::max(std::sqrt(glm::dot(off, set_.form * off)) - half_cell_, 0.0);
            }
            // The outermost cells hold all that is beyond them.
            return is_on_border(place) ? std::min(root, 1.0) : root;
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

// The distances of cells on a chessboard to the nearest one where `is` is false, 0 there, in two
// passes over all cells (Rosenfeld & Pfaltz 1968). Outside of the grid all is as it should be.
std::vector<std::uint32_t> distances(const glm::ivec3& across, const std::vector<bool>& is) {
    const auto [nx, ny, nz] = std::array{across.x, across.y, across.z};
    constexpr std::uint32_t far = Cell::most_free;
    std::vector<std::uint32_t> steps(is.size());
    for (std::size_t k = 0; k < steps.size(); ++k) steps[k] = is[k] ? far : 0;
    const auto index = [&](int x, int y, int z) { return std::size_t((z * ny + y) * nx + x); };
    const auto step = [&](int x, int y, int z) -> std::uint32_t {
        const bool inside = x >= 0 && y >= 0 && z >= 0 && x < nx && y < ny && z < nz;
        return inside ? steps[index(x, y, z)] : far;
    };
    const auto lower = [&](int x, int y, int z, int sign) {
        std::uint32_t& here = steps[index(x, y, z)];
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
    return steps;
}

// Tells each cell how far around it there is no root, and each empty one how far it is empty.
void measure(ElementGrid& grid, const std::vector<bool>& is_free) {
    std::vector<bool> is_empty(grid.cells.size());
    for (std::size_t k = 0; k < is_empty.size(); ++k) is_empty[k] = grid.cells[k].packed == 0;
    const std::vector<std::uint32_t> empty = distances(grid.across, is_empty);
    const std::vector<std::uint32_t> free =
        is_free == is_empty ? empty : distances(grid.across, is_free);
    for (std::size_t k = 0; k < grid.cells.size(); ++k) {
        if (is_empty[k]) grid.cells[k].first = empty[k] - 1;
        grid.cells[k].packed |= free[k] << Cell::count_bits;
    }
}

// Sums over the elements that matter in a cell, bounded; what is left out of them included.
class CellSums {
public:
    CellSums(const RootFree& root_free, std::size_t cells)
        : root_free_(root_free)
        , sums_(root_free.at_most.size())
        , has_levels_(std::ranges::all_of(root_free.at_most, [](double s) { return s > 0; }))
        , bounds_(cells * sums_, 0.0f) {}

    // An element's set of quadric k, whose form's root is at least that in the cell.
    void add(std::uint32_t element, int k, double root, std::size_t cell) {
        constexpr int shells = ElementTerms::shells;
        for (std::size_t sum = 0; sum < sums_; ++sum) {
            if (root_free_.quadric_of[sum] != k) continue;
            const int shell = std::min(int(root * shells), shells - 1);
            bounds_[cell * sums_ + sum] +=
                root_free_.sizes[(element * sums_ + sum) * shells + std::size_t(shell)];
        }
    }
    bool are_free(std::size_t cell, std::uint32_t elements) const {
        if (elements == 0 && root_free_.is_emptiness) return true;
        if (sums_ == 0 || !has_levels_) return false;
        for (std::size_t sum = 0; sum < sums_; ++sum) {
            if (!(bound(cell, sum, elements) <= root_free_.at_most[sum])) return false;
        }
        return true;
    }
    // At least what is listed of a sum is in size.
    double bound(std::size_t cell, std::size_t sum, std::uint32_t elements) const {
        // Additions in floats, each rounded.
        return (1 + 0x1p-23 * (elements + 1.0)) * double(bounds_[cell * sums_ + sum]);
    }
    std::size_t sums() const { return sums_; }

private:
    const RootFree& root_free_;
    std::size_t sums_;
    bool has_levels_;
    std::vector<float> bounds_;
};

// Looks for roots in a row of cells that are not known to be free.
class Rows {
public:
    Rows(const ElementGrid& grid, const CellSums& sums, const RootFree& root_free,
         const Placing& placing)
        : grid_(grid)
        , sums_(sums)
        , root_free_(root_free)
        , placing_(placing)
        , boxes_(*root_free.roots, *root_free.bindings)
        , inputs_(3 + sums.sums()) {}

    // `cell` is the row's first one.
    void look(int y, int z, std::size_t cell, std::span<std::uint8_t> is_free) {
        for (auto& input : inputs_) input.clear();
        cells_.clear();
        for (int x = 0; x < grid_.across.x; ++x) {
            if (is_free[std::size_t(x)] != 0) continue;
            cells_.push_back(std::size_t(x));
            const auto [low, high] = placing_.box({x, y, z});
            for (int k = 0; k < 3; ++k) inputs_[std::size_t(k)].emplace_back(low[k], high[k]);
            const std::uint32_t elements = grid_.cells[cell + std::size_t(x)].packed;
            for (std::size_t sum = 0; sum < sums_.sums(); ++sum) {
                const double most = sums_.bound(cell + std::size_t(x), sum, elements);
                const Interval& signs = root_free_.signs[sum];
                inputs_[3 + sum].push_back(Interval(signs.lo * most, signs.hi * most) +
                                           root_free_.left_out[sum]);
            }
        }
        if (cells_.empty()) return;
        boxes_.exclude(inputs_, excluded_);
        for (std::size_t k = 0; k < cells_.size(); ++k)
            is_free[cells_[k]] = std::uint8_t(excluded_[k]);
    }

private:
    const ElementGrid& grid_;
    const CellSums& sums_;
    const RootFree& root_free_;
    const Placing& placing_;
    SumsAtRoots::Boxes boxes_;
    std::vector<std::vector<Interval>> inputs_;
    std::vector<std::size_t> cells_;
    std::vector<bool> excluded_;
};

} // namespace

ElementGrid make_grid(const Region& region, std::span<const LevelSet> sets, int each,
                      const RootFree& root_free, const GridLimits& limits) {
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
    // Calls found(element, cell, set, root) for all sets in ascending order that meet the cell, and
    // with `once` for the first set of an element alone.
    const auto for_each_entry = [&](std::size_t part, bool once, auto&& found) {
        const int begin = first_layer(part), end = first_layer(part + 1);
        std::vector<std::uint32_t> last(once && each > 1 ? layer * std::size_t(end - begin) : 0,
                                        ~0u);
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
                        const double root = meets({x, y, z});
                        if (root > 1) continue;
                        if (!last.empty()) {
                            std::uint32_t& seen = last[cell - std::size_t(begin) * layer];
                            if (seen == element) continue;
                            seen = element;
                        }
                        found(element, cell, int(k % std::size_t(each)), root);
                    }
                }
            }
        }
    };
    const base::SharedLoop over_parts{std::size_t(parts), limits.threads};
    CellSums sums(root_free, grid.cells.size());
    base::share(over_parts, [&] {
        return [&](std::size_t part) {
            for_each_entry(part, true,
                           [&](std::uint32_t element, std::size_t cell, int set, double root) {
                               ++grid.cells[cell].packed;
                               if (each == 1) sums.add(element, set, root, cell);
                           });
            if (each == 1) return;
            for_each_entry(part, false,
                           [&](std::uint32_t element, std::size_t cell, int set, double root) {
                               sums.add(element, set, root, cell);
                           });
        };
    });
    std::uint32_t begin = 0;
    std::vector<std::uint8_t> is_free(grid.cells.size());
    for (std::size_t k = 0; k < grid.cells.size(); ++k) {
        Cell& cell = grid.cells[k];
        cell.first = begin;
        begin += cell.packed;
        is_free[k] = sums.are_free(k, cell.packed);
        grid.longest = std::max(grid.longest, cell.packed);
    }
    if (grid.longest > Cell::most_elements) {
        throw std::length_error(
            fmt::format("{} elements of an array matter at one place; a list holds {}",
                        grid.longest, Cell::most_elements));
    }
    grid.listed.resize(begin);
    std::vector<std::uint32_t> next(grid.cells.size());
    for (std::size_t k = 0; k < next.size(); ++k) next[k] = grid.cells[k].first;
    base::share(over_parts, [&] {
        return [&](std::size_t part) {
            for_each_entry(part, true, [&](std::uint32_t element, std::size_t cell, int, double) {
                grid.listed[next[cell]++] = element;
            });
        };
    });
    if (root_free.roots) {
        base::share(over_parts, [&] {
            return [&, rows = Rows(grid, sums, root_free, placing)](std::size_t part) mutable {
                for (int z = first_layer(part); z < first_layer(part + 1); ++z) {
                    for (int y = 0; y < grid.across.y; ++y) {
                        const std::size_t cell =
                            std::size_t(z * grid.across.y + y) * std::size_t(grid.across.x);
                        rows.look(y, z, cell,
                                  std::span(is_free).subspan(cell, std::size_t(grid.across.x)));
                    }
                }
            };
        });
    }
    measure(grid, {is_free.begin(), is_free.end()});
    return grid;
}

} // namespace isomotion::elements
