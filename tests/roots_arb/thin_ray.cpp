#include "thin_ray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace isomotion::roots_arb {
namespace {

// The precision of balls over pieces: their radius, not rounding, is what makes them wide.
constexpr slong of_pieces = 64;

Ball coordinate(const Ray& ray, const Ball& t, int axis, slong precision) {
    Ball p(ray.anchor[axis]);
    arb_addmul(p.get(), Ball(ray.direction[axis]).get(), t.get(), precision);
    return p;
}

} // namespace

struct ThinRays::Piece {
    double a = 0, b = 0;
    Ball at_a, at_b;
};

Ball ThinRays::at(const Ray& ray, double t) {
    const Ball exact(t);
    const std::array<Ball, 3> p{coordinate(ray, exact, 0, precision),
                                coordinate(ray, exact, 1, precision),
                                coordinate(ray, exact, 2, precision)};
    Ball f;
    value_.evaluate(bindings_, p, {&f, 1}, precision);
    return f;
}

bool ThinRays::is_free(const Ray& ray, const Piece& piece) {
    const Ball t(piece.a, piece.b);
    std::array<Ball, 6> inputs;
    for (int k = 0; k < 3; ++k) {
        inputs[std::size_t(k)] = coordinate(ray, t, k, of_pieces);
        inputs[std::size_t(k) + 3] = Ball(ray.direction[k]);
    }
    std::array<Ball, 2> f; // F, dF/dt
    along_.evaluate(bindings_, inputs, f, of_pieces);
    if (f[0].sign() != 0) return true;
    if (piece.at_a.sign() == 0 || piece.at_a.sign() != piece.at_b.sign()) return false;
    if (f[1].sign() != 0) return true;
    if (!f[1].is_finite()) return false;
    // |F(a)| + |F(b)| > max |dF/dt| (b - a)
    Ball ends, reach(piece.b);
    arb_add(ends.get(), piece.at_a.get(), piece.at_b.get(), precision);
    arb_abs(ends.get(), ends.get());
    arb_sub(reach.get(), reach.get(), Ball(piece.a).get(), precision);
    arb_mul(reach.get(), reach.get(), f[1].get(), precision);
    arb_abs(reach.get(), reach.get());
    return arb_gt(ends.get(), reach.get());
}

Search ThinRays::search(const Ray& ray, double from, double to, int budget) {
    Search result;
    // Some doubles apart: narrower pieces have no middle worth asking for.
    const double narrow = 0x1p-49 * std::max({std::abs(from), std::abs(to), to - from});
    std::vector<Piece> ahead; // the nearest last
    ahead.push_back({from, to, at(ray, from), at(ray, to)});
    int known = 0; // the last certain sign, and where
    double known_at = from;
    const auto crossed_before = [&](double t, int sign) {
        result.crosses = known * sign < 0;
        result.low = known_at;
        result.high = t;
        if (sign != 0) {
            known = sign;
            known_at = t;
        }
        return result.crosses;
    };
    const auto leave_unproven = [&](double low, double high) {
        if (result.unproven++ == 0) result.unproven_low = low;
        result.unproven_high = high;
    };
    for (int pieces = 0; !ahead.empty(); ++pieces) {
        Piece piece = std::move(ahead.back());
        ahead.pop_back();
        if (crossed_before(piece.a, piece.at_a.sign())) break;
        if (pieces == budget) {
            leave_unproven(piece.a, to);
            result.budget_ended = true;
            break;
        }
        const bool crosses = piece.at_a.sign() * piece.at_b.sign() < 0;
        const bool free = !crosses && is_free(ray, piece);
        if (!free && piece.b - piece.a > narrow) {
            // Not in the middle, where symmetric surfaces have their roots.
            const double middle = piece.a + 0.489 * (piece.b - piece.a);
            const Ball at_middle = at(ray, middle);
            ahead.push_back({middle, piece.b, at_middle, std::move(piece.at_b)});
            ahead.push_back({piece.a, middle, std::move(piece.at_a), at_middle});
            continue;
        }
        if (!free && !crosses) leave_unproven(piece.a, piece.b);
        if (crossed_before(piece.b, piece.at_b.sign())) break;
    }
    return result;
}

} // namespace isomotion::roots_arb
