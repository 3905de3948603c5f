#include "render/sample_pattern.h"

#include <array>
#include <cmath>
#include <cstdint>

#include <glm/gtc/constants.hpp>

namespace isomotion::render {
namespace {

// A coordinate of Sobol's sequence, given by its primitive polynomial over GF(2) and the first odd
// integers m of its direction numbers (Joe and Kuo 2008, new-joe-kuo-6).
class SobolCoordinate {
public:
    // The first coordinate: the radical inverse in base 2.
    SobolCoordinate() {
        for (unsigned k = 0; k < bits; ++k) direction_[k] = 1u << (bits - 1 - k);
    }
    // `inner` holds the polynomial's coefficients between the first and the last, which are 1.
    template<std::size_t degree>
    SobolCoordinate(unsigned inner, const std::array<std::uint32_t, degree>& m) {
        for (unsigned k = 0; k < bits; ++k) {
            if (k < degree) {
                direction_[k] = m[k] << (bits - 1 - k);
                continue;
            }
            std::uint32_t v = direction_[k - degree];
            v ^= v >> degree;
            for (unsigned j = 1; j < degree; ++j) {
                if (inner >> (degree - 1 - j) & 1u) v ^= direction_[k - j];
            }
            direction_[k] = v;
        }
    }

    // The number about 0 instead of in [0, 1): the sequence begins with 0 and is periodic for all
    // that matters.
    double centred(std::uint32_t index) const {
        std::uint32_t sum = 0;
        for (unsigned k = 0; index >> k; ++k) {
            if (index >> k & 1u) sum ^= direction_[k];
        }
        const double x = std::ldexp(double(sum), -int(bits));
        return x < 0.5 ? x : x - 1;
    }

private:
    static constexpr unsigned bits = 32;
    std::array<std::uint32_t, bits> direction_{};
};

// Shirley and Chiu 1997: [-1, 1]^2 to the unit disc, areas to proportional areas, squares about the
// middle to circles.
glm::dvec2 on_disc(const glm::dvec2& square) {
    if (square == glm::dvec2(0)) return square;
    const bool flat = std::abs(square.x) > std::abs(square.y);
    const double radius = flat ? square.x : square.y;
    const double turn = glm::quarter_pi<double>() * (flat ? square.y : square.x) / radius;
    return radius * (flat ? glm::dvec2(std::cos(turn), std::sin(turn))
                          : glm::dvec2(std::sin(turn), std::cos(turn)));
}

} // namespace

std::vector<Sample> sample_pattern(int count) {
    const std::array<SobolCoordinate, 4> coordinates{
        SobolCoordinate(), SobolCoordinate(0, std::array<std::uint32_t, 1>{1}),
        SobolCoordinate(1, std::array<std::uint32_t, 2>{1, 3}),
        SobolCoordinate(1, std::array<std::uint32_t, 3>{1, 3, 1})};
    std::vector<Sample> samples;
    for (int k = 0; k < count; ++k) {
        const auto at = [&](std::size_t c) { return coordinates[c].centred(std::uint32_t(k)); };
        samples.push_back(
            {{{at(0), at(1)}, on_disc({2 * at(2), 2 * at(3)})}, double(k) / double(count)});
    }
    return samples;
}

} // namespace isomotion::render
