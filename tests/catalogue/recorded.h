// What is recorded of the catalogue's surfaces: recorded.toml, read.
#pragma once

#include <array>
#include <ostream>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace isomotion::catalogue {

struct Recorded {
    std::string name;
    double radius = 0; // of the bounds, or 0 where they are a box
    glm::dvec3 min{0}, max{0};
    double least = 0, greatest = 0;    // value
    std::array<double, 5> quantiles{}; // of |F|
    int sign = 0;
    std::vector<std::string> symmetry, antisymmetry;

    double span() const { return greatest - least; }
};

inline constexpr std::array<double, 5> quantile_shares{0.05, 0.25, 0.5, 0.75, 0.95};

inline void PrintTo(const Recorded& surface, std::ostream* out) { *out << surface.name; }

// Sorted by name.
const std::vector<Recorded>& recorded();

} // namespace isomotion::catalogue
