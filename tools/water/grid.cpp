#include "grid.h"

#include <algorithm>
#include <cmath>

namespace water {

Grid::Grid(const Box& bounds, float cell)
    : low_(bounds.low)
    , per_length_(1 / cell)
    , nx_(int(std::ceil((bounds.high.x - bounds.low.x) / cell)))
    , ny_(int(std::ceil((bounds.high.y - bounds.low.y) / cell)))
    , nz_(int(std::ceil((bounds.high.z - bounds.low.z) / cell))) {
    starts_.resize(index({0, 0, nz_}) + 1);
}

Grid::Cell Grid::cell_of(Vec3 p) const {
    const auto along = [&](float x, float low, int n) {
        return int(std::clamp(std::floor((x - low) * per_length_), 0.0F, float(n - 1)));
    };
    return {along(p.x, low_.x, nx_), along(p.y, low_.y, ny_), along(p.z, low_.z, nz_)};
}

std::vector<std::uint32_t> Grid::sort(std::span<const Vec3> points) {
    std::vector<std::uint32_t> cells(points.size()), order(points.size());
    std::fill(starts_.begin(), starts_.end(), 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        cells[i] = std::uint32_t(index(cell_of(points[i])));
        ++starts_[cells[i] + 1];
    }
    for (std::size_t c = 1; c < starts_.size(); ++c) starts_[c] += starts_[c - 1];
    std::vector<std::uint32_t> next = starts_;
    for (std::size_t i = 0; i < points.size(); ++i) order[next[cells[i]]++] = std::uint32_t(i);
    return order;
}

} // namespace water
