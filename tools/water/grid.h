#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tank.h"

namespace water {

/// Finds the points near a point: cubic cells, whose points follow one another. Points beyond the
/// bounds belong to the cells at their edge.
class Grid {
public:
    Grid(const Box& bounds, float cell);

    /// The order of the points by cell, those of a cell as they came. The cells are then those of
    /// the points in that order.
    std::vector<std::uint32_t> sort(std::span<const Vec3> points);

    /// Calls visit(first, last) for ranges that together have all points within `reach` of p, once
    /// and always in the same order, and others.
    template<class Visit> void visit_near(Vec3 p, float reach, const Visit& visit) const {
        const Vec3 r{reach, reach, reach};
        const Cell low = cell_of(p - r), high = cell_of(p + r);
        for (int z = low.z; z <= high.z; ++z) {
            for (int y = low.y; y <= high.y; ++y) {
                const std::size_t row = index({0, y, z});
                visit(starts_[row + std::size_t(low.x)], starts_[row + std::size_t(high.x) + 1]);
            }
        }
    }

private:
    struct Cell {
        int x, y, z;
    };

    Cell cell_of(Vec3 p) const;
    std::size_t index(Cell c) const {
        return (std::size_t(c.z) * std::size_t(ny_) + std::size_t(c.y)) * std::size_t(nx_) +
               std::size_t(c.x);
    }

    Vec3 low_;
    float per_length_;
    int nx_, ny_, nz_;
    std::vector<std::uint32_t> starts_; // of each cell's points, and behind the last
};

} // namespace water
