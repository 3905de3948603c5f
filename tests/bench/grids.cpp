// How long Betti numbers of signs on a grid take: grids_bench [SIDE], 128 if not given.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include <fmt/format.h>

#include "topology/betti/sign_grid.h"

namespace {

using namespace isomotion::topology;

// `field` over [-1, 1]^3 is negative in the solid.
template<class Field> void measure(const char* name, int side, const Field& field) {
    SignGrid grid(side);
    const auto at = [&](int k) { return 2.0 * k / (side - 1) - 1; };
    for (int z = 0; z < side; ++z) {
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                if (field(at(x), at(y), at(z)) < 0) grid.set(x, y, z);
            }
        }
    }
    std::vector<double> times;
    Betti found{};
    for (int k = 0; k < 101; ++k) {
        const auto start = std::chrono::steady_clock::now();
        found = betti(grid);
        times.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
                .count());
    }
    std::ranges::sort(times);
    fmt::print("{:8} {}^3: {:6.2f} ms, at least {:6.2f}; ({}, {}, {})\n", name, side,
               times[times.size() / 2], times.front(), found.components, found.tunnels,
               found.voids);
}

} // namespace

int main(int count, char** words) {
    const int side = count > 1 ? std::atoi(words[1]) : 128;
    measure("ball", side, [](double x, double y, double z) { return x * x + y * y + z * z - 0.7; });
    measure("gyroid", side, [](double x, double y, double z) {
        const double k = 5 * std::numbers::pi;
        return std::sin(k * x) * std::cos(k * y) + std::sin(k * y) * std::cos(k * z) +
               std::sin(k * z) * std::cos(k * x) - 0.1;
    });
}
