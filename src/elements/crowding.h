// Bounds the number of elements near any one place.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace isomotion::elements {

class Crowding {
public:
    explicit Crowding(std::span<const glm::dvec3> middles);

    // An upper bound of the number of elements whose middle is within that distance of any place.
    double most_within(double distance) const;

private:
    static constexpr int across = 32;

    // The number of elements in cells before (x, y, z) in all three directions.
    std::int64_t before(int x, int y, int z) const {
        return sums_[std::size_t((z * (across + 1) + y) * (across + 1) + x)];
    }

    glm::dvec3 cell_{1};
    std::vector<std::int64_t> sums_;
};

} // namespace isomotion::elements
