// Gradient noise on the integer lattice, and its derivatives.
//
// Perlin's "Improving Noise" (2002): each lattice point has one of twelve gradients, by a hash of
// its coordinates, and a linear function that is 0 there and rises along it. Within a cell, noise
// is the mean of its eight corners' functions, weighted by the quintic 6t^5 - 15t^4 + 10t^3 along
// each axis. So it has two continuous derivatives, is 0 at the lattice points and lies within
// +-1.04. The hash takes integers alone, so all number types, shaders and pages have the same
// gradients. The lattice repeats after 2^20 cells, where floats have eight places within a cell.
//
// The weights are products over the axes: with A0 = 1 - fade(t), A1 = fade(t), B0 = t A0 and
// B1 = (t - 1) A1, a corner with the gradient (g, h, l) adds
//     g B(x) A(y) A(z) + h A(x) B(y) A(z) + l A(x) A(y) B(z).
// Derivatives of any order follow from those of A and B, which are polynomials.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace isomotion::formula {

// How often noise is differentiated along each axis.
struct NoiseOrder {
    std::array<int, 3> along{};

    // All higher derivatives are 0, and so is this one but for the jumps of the sixth.
    static constexpr int most = 7;
    // As a node's index.
    constexpr int packed() const { return along[0] + 8 * (along[1] + 8 * along[2]); }
    static constexpr NoiseOrder unpacked(int index) {
        return {{index % 8, index / 8 % 8, index / 64}};
    }
};

// Derivatives along one axis have jumps between cells.
constexpr bool jumps_between_cells(int order) { return order > 2; }

namespace lattice {

inline constexpr double period = 1 << 20;

// The lattice point of the period that a whole number stands for; 0 for what is no number.
inline std::uint32_t point(double whole) {
    const double within = whole - period * std::floor(whole / period);
    return within >= 0 && within < period ? std::uint32_t(within) : 0;
}

// Each component is -1, 0 or 1; one is 0.
inline std::array<int, 3> gradient(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    constexpr std::uint32_t wrap = (1u << 20) - 1;
    std::uint32_t h =
        (x & wrap) * 0x9E3779B1u ^ (y & wrap) * 0x85EBCA77u ^ (z & wrap) * 0xC2B2AE3Du;
    h = (h ^ h >> 15) * 0x2C1B3C6Du;
    h = (h ^ h >> 12) * 0x297A2D39u;
    h ^= h >> 15;
    const std::uint32_t across = (h >> 16) * 3 >> 16;
    const int s = h & 1 ? -1 : 1, t = h & 2 ? -1 : 1;
    return across == 0   ? std::array{0, s, t}
           : across == 1 ? std::array{s, 0, t}
                         : std::array{s, t, 0};
}

// t (1 - t), for t from 0 to 1.
template<class T> T bump(const T& t) { return t * (T(1) - t); }

// 6t^5 - 15t^4 + 10t^3, each half in the form that keeps its digits.
template<class T> T fade(const T& t) {
    const auto half = [](const T& a) { return a * a * a * (T(10) - a * (T(15) - T(6) * a)); };
    return t > T(0.5) ? T(1) - half(T(1) - t) : half(t);
}

template<class T> T fade(const T& t, int order) {
    switch (order) {
    case 0:
        return fade(t);
    case 1: {
        const T s = bump(t);
        return T(30) * (s * s);
    }
    case 2:
        return T(60) * bump(t) * (T(1) - T(2) * t);
    case 3:
        return T(60) * (T(1) - T(6) * bump(t));
    case 4:
        return T(-360) * (T(1) - T(2) * t);
    case 5:
        return T(720);
    default:
        return T(0);
    }
}

// The derivatives of A and of B, for both corners along an axis.
template<class T> struct Weights {
    std::array<T, 2> a, b;

    Weights(const T& t, int order)
        : a{of_near(order, t), fade(t, order)} {
        b[0] = t * a[0];
        b[1] = (t - T(1)) * a[1];
        if (order == 0) return;
        b[0] = b[0] + T(order) * of_near(order - 1, t);
        b[1] = b[1] + T(order) * fade(t, order - 1);
    }

private:
    static T of_near(int order, const T& t) {
        return order == 0 ? T(1) - fade(t) : T(0) - fade(t, order);
    }
};

// The cells that a box meets.
struct Cells {
    std::array<double, 3> first{}, last{}; // their lower ends

    // Whether they are two or fewer along each axis. Farther from the origin doubles have no
    // fractions, and not each cell has a number.
    bool are_few() const {
        constexpr double farthest = 0x1p52;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const bool is_near = first[axis] > -farthest && last[axis] < farthest;
            if (!is_near || last[axis] - first[axis] > 1) return false;
        }
        return true;
    }
    // each(cell), of few cells.
    template<class Each> void visit(const Each& each) const {
        for (double z = first[2]; z <= last[2]; ++z) {
            for (double y = first[1]; y <= last[1]; ++y) {
                for (double x = first[0]; x <= last[0]; ++x) each(std::array{x, y, z});
            }
        }
    }
};

// Visits the corners of the cell that begins at `low`: each(which, gradient), where `which` has 0
// or 1 for each axis.
template<class Each> void corners(const std::array<double, 3>& low, const Each& each) {
    const std::array cell{point(low[0]), point(low[1]), point(low[2])};
    for (std::uint32_t c = 0; c < 8; ++c) {
        const std::array<std::size_t, 3> which{c & 1, c >> 1 & 1, c >> 2};
        each(which, gradient(cell[0] + (c & 1), cell[1] + (c >> 1 & 1), cell[2] + (c >> 2)));
    }
}

// A derivative of noise in a cell, at `place` from 0 to 1 along each axis.
template<class T>
T in_cell(const std::array<double, 3>& low, const std::array<T, 3>& place,
          const NoiseOrder& order) {
    const std::array<Weights<T>, 3> weights{Weights<T>(place[0], order.along[0]),
                                            Weights<T>(place[1], order.along[1]),
                                            Weights<T>(place[2], order.along[2])};
    T sum(0);
    corners(low, [&](const auto& which, const std::array<int, 3>& gradient) {
        for (std::size_t rise = 0; rise < 3; ++rise) {
            if (gradient[rise] == 0) continue;
            const auto weight = [&](std::size_t axis) -> const T& {
                return (axis == rise ? weights[axis].b : weights[axis].a)[which[axis]];
            };
            const T part = weight(0) * weight(1) * weight(2);
            sum = gradient[rise] > 0 ? sum + part : sum - part;
        }
    });
    return sum;
}

} // namespace lattice

template<class T> T noise(T x, T y, T z, const NoiseOrder& order) {
    const std::array<T, 3> whole{std::floor(x), std::floor(y), std::floor(z)};
    return lattice::in_cell<T>({double(whole[0]), double(whole[1]), double(whole[2])},
                               {x - whole[0], y - whole[1], z - whole[2]}, order);
}

} // namespace isomotion::formula
