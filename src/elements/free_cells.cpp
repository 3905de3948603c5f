#include "elements/free_cells.h"

#include <cmath>

#include "base/workers.h"

namespace isomotion::elements {
namespace {

// Cells that share lists are cheaper than others.
constexpr double most_layered = 1 << 20;

// The distances of cells on a chessboard to the nearest one where `is` is false, 0 there, in two
// passes over all cells (Rosenfeld & Pfaltz 1968). Outside of the grid all is as it should be.
std::vector<std::uint32_t> distances(const glm::ivec3& across, const std::vector<bool>& is) {
    const int nx = across.x, ny = across.y, nz = across.z;
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
        // Nothing is lower beside a neighbour that is 0.
        if (here <= 1) return;
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
void measure(ElementGrid& grid, const std::vector<bool>& is_free, int threads) {
    std::vector<bool> is_empty(grid.cells.size());
    for (std::size_t k = 0; k < is_empty.size(); ++k) is_empty[k] = grid.cells[k].packed == 0;
    std::vector<std::uint32_t> empty, free;
    const bool is_same = is_free == is_empty;
    base::share({is_same ? 1u : 2u, threads}, [&] {
        return [&](std::size_t turn) {
            if (turn == 0)
                empty = distances(grid.across, is_empty);
            else
                free = distances(grid.across, is_free);
        };
    });
    if (is_same) free = empty;
    for (std::size_t k = 0; k < grid.cells.size(); ++k) {
        if (is_empty[k]) grid.cells[k].first = empty[k] - 1;
        grid.cells[k].packed |= free[k] << Cell::count_bits;
    }
}

// The cells that had lists of their own, of which others are copies.
struct Columns {
    glm::ivec3 across{1};
    glm::bvec3 is_flat{false};

    std::size_t index(const glm::ivec3& place) const {
        const glm::ivec3 at = glm::mix(place, glm::ivec3(0), is_flat);
        return std::size_t((at.z * across.y + at.y) * across.x + at.x);
    }
};

// Copies of the cells along flat axes, about as long as they are wide.
void add_layers(ElementGrid& grid, const Columns& columns, const Region& region, int most) {
    double side = 0;
    for (int k = 0; k < 3; ++k) {
        if (!columns.is_flat[k]) side = std::max(side, grid.cell[k]);
    }
    double cells = double(grid.cells.size());
    for (int k = 0; k < 3; ++k) {
        if (!columns.is_flat[k]) continue;
        const double wanted = std::ceil((region.high[k] - region.low[k]) / side);
        grid.across[k] =
            int(std::clamp(std::floor(most_layered / cells), 1.0, std::min(wanted, double(most))));
        cells *= grid.across[k];
    }
    grid.cell = Placing(region, grid.across).cell();
    const std::vector<Cell> of_columns = std::move(grid.cells);
    grid.cells.clear();
    for (int z = 0; z < grid.across.z; ++z)
        for (int y = 0; y < grid.across.y; ++y)
            for (int x = 0; x < grid.across.x; ++x)
                grid.cells.push_back(of_columns[columns.index({x, y, z})]);
}

// Looks for roots in a row of cells that are not known to be free.
class Rows {
public:
    Rows(const ElementGrid& grid, const CellSums& sums, const RootFree& root_free,
         const Placing& placing, const Columns& columns)
        : grid_(grid)
        , columns_(columns)
        , sums_(sums)
        , root_free_(root_free)
        , placing_(placing)
        , boxes_(*root_free.roots, *root_free.bindings)
        , inputs_(3 + sums.sums()) {}

    // is_free has a number for each cell of the row.
    void look(int y, int z, std::span<std::uint8_t> is_free) {
        for (auto& input : inputs_) input.clear();
        cells_.clear();
        for (int x = 0; x < grid_.across.x; ++x) {
            if (is_free[std::size_t(x)] != 0) continue;
            cells_.push_back(std::size_t(x));
            const auto [low, high] = placing_.box({x, y, z});
            for (int k = 0; k < 3; ++k) inputs_[std::size_t(k)].emplace_back(low[k], high[k]);
            const glm::ivec3 place(x, y, z);
            const std::uint32_t elements = grid_.at(place).packed;
            const std::size_t cell = columns_.index(place);
            for (std::size_t sum = 0; sum < sums_.sums(); ++sum) {
                inputs_[3 + sum].push_back(sums_.sum(cell, sum, elements) +
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
    const Columns& columns_;
    const CellSums& sums_;
    const RootFree& root_free_;
    const Placing& placing_;
    SumsAtRoots::Boxes boxes_;
    std::vector<std::vector<Interval>> inputs_;
    std::vector<std::size_t> cells_;
    std::vector<bool> excluded_;
};

} // namespace

void find_free_cells(ElementGrid& grid, const Region& region, const CellSums& sums,
                     const RootFree& root_free, const glm::bvec3& is_flat,
                     const GridLimits& limits) {
    const Columns columns{grid.across, is_flat};
    constexpr double most_terms = 3e6; // to sum; drawing a frame takes as many for a few rays
    const bool looks = root_free.roots && root_free.roots->terms_of_others(*root_free.bindings) *
                                                  double(grid.cells.size()) <=
                                              most_terms;
    if (looks && glm::any(is_flat)) add_layers(grid, columns, region, limits.across);
    std::vector<std::uint8_t> is_free;
    const auto across = std::size_t(grid.across.x);
    for (int z = 0; z < grid.across.z; ++z)
        for (int y = 0; y < grid.across.y; ++y)
            for (int x = 0; x < grid.across.x; ++x)
                is_free.push_back(std::uint8_t(
                    sums.are_free(columns.index({x, y, z}), grid.at({x, y, z}).packed)));
    if (looks) {
        const Placing placing(region, grid.across);
        const std::size_t rows = grid.cells.size() / across;
        base::share({rows, limits.threads}, [&] {
            return
                [&, in = Rows(grid, sums, root_free, placing, columns)](std::size_t row) mutable {
                    in.look(int(row % std::size_t(grid.across.y)),
                            int(row / std::size_t(grid.across.y)),
                            std::span(is_free).subspan(row * across, across));
                };
        });
    }
    measure(grid, {is_free.begin(), is_free.end()}, limits.threads);
}

} // namespace isomotion::elements
