#include "elements/crowding.h"

#include <algorithm>
#include <limits>

namespace isomotion::elements {

Crowding::Crowding(std::span<const glm::dvec3> middles) {
    constexpr int stride = across + 1;
    sums_.assign(std::size_t(stride * stride * stride), 0);
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const glm::dvec3& at : middles) {
        low = glm::min(low, at);
        high = glm::max(high, at);
    }
    if (middles.empty()) return;
    cell_ = (high - low) / double(across);
    const auto place = [&](const glm::dvec3& at, int k) {
        return cell_[k] > 0 ? std::clamp(int((at[k] - low[k]) / cell_[k]), 0, across - 1) : 0;
    };
    const auto sum = [&](int x, int y, int z) -> std::int64_t& {
        return sums_[std::size_t((z * stride + y) * stride + x)];
    };
    for (const glm::dvec3& at : middles)
        ++sum(place(at, 0) + 1, place(at, 1) + 1, place(at, 2) + 1);
    for (int z = 1; z <= across; ++z) {
        for (int y = 1; y <= across; ++y) {
            for (int x = 1; x <= across; ++x) {
                sum(x, y, z) += sum(x - 1, y, z) + sum(x, y - 1, z) + sum(x, y, z - 1) -
                                sum(x - 1, y - 1, z) - sum(x - 1, y, z - 1) - sum(x, y - 1, z - 1) +
                                sum(x - 1, y - 1, z - 1);
            }
        }
    }
}

double Crowding::most_within(double distance) const {
    // A box around the ball meets so many cells, wherever it lies.
    glm::ivec3 window;
    for (int k = 0; k < 3; ++k) {
        const double cells = cell_[k] > 0 ? 2 * distance / cell_[k] + 2 : 1;
        window[k] = int(std::min(cells, double(across)));
    }
    std::int64_t most = 0;
    for (int z = 0; z + window.z <= across; ++z) {
        for (int y = 0; y + window.y <= across; ++y) {
            for (int x = 0; x + window.x <= across; ++x) {
                const int right = x + window.x, back = y + window.y, top = z + window.z;
                const std::int64_t inside = before(right, back, top) - before(x, back, top) -
                                            before(right, y, top) - before(right, back, z) +
                                            before(x, y, top) + before(x, back, z) +
                                            before(right, y, z) - before(x, y, z);
                most = std::max(most, inside);
            }
        }
    }
    return double(most);
}

} // namespace isomotion::elements
