#include "formula/interval/chebyshev_enclosure.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "formula/graph/lowering.h"

namespace isomotion::formula {
namespace {

constexpr int highest_order = 7;

// c[j] = f^(j)(x) / j!
template<class V, int Order> using Series = std::array<DoubleDouble<V>, Order + 1>;

// 2 a b - c
template<class V, std::size_t Size>
std::array<DoubleDouble<V>, Size> twice_product_minus(const std::array<DoubleDouble<V>, Size>& a,
                                                      const std::array<DoubleDouble<V>, Size>& b,
                                                      const std::array<DoubleDouble<V>, Size>& c) {
    std::array<DoubleDouble<V>, Size> result;
    for (std::size_t m = 0; m < Size; ++m) {
        DoubleDouble<V> sum = a[0] * b[m];
        for (std::size_t i = 1; i <= m; ++i) sum = sum + a[i] * b[m - i];
        result[m] = twice(sum) - c[m];
    }
    return result;
}

// T_n about x, n >= 1.
template<class V, int Order> Series<V, Order> chebyshev_series(int n, V x) {
    Series<V, Order> one{exactly(V{} + 1)}, identity{exactly(x)};
    if constexpr (Order > 0) identity[1] = exactly(V{} + 1);
    int bit = 1;
    while (2 * bit <= n) bit *= 2;
    // T_m and T_m+1, m being the leading bits of n.
    Series<V, Order> now = identity, next{};
    if (n != bit) next = twice_product_minus(identity, identity, one);
    while (bit /= 2) {
        const bool more = n & (bit - 1); // else T_m+1 isn't needed any longer
        if (n & bit) {
            now = twice_product_minus(now, next, identity);
            if (more) next = twice_product_minus(next, next, one);
        } else {
            if (more) next = twice_product_minus(now, next, identity);
            now = twice_product_minus(now, now, one);
        }
    }
    return now;
}

template<class V, int Order> DoubleDouble<V> chebyshev_derivative(int n, V x) {
    double factorial = 1;
    for (int j = 2; j <= Order; ++j) factorial *= j;
    const DoubleDouble<V> coefficient = chebyshev_series<V, Order>(n, x)[Order];
    return Order < 2 ? coefficient : coefficient * exactly(V{} + factorial);
}

// T_n^(k)(x), k up to highest_order.
template<class V> DoubleDouble<V> chebyshev(int n, int k, V x) {
    constexpr std::array derivatives{chebyshev_derivative<V, 0>, chebyshev_derivative<V, 1>,
                                     chebyshev_derivative<V, 2>, chebyshev_derivative<V, 3>,
                                     chebyshev_derivative<V, 4>, chebyshev_derivative<V, 5>,
                                     chebyshev_derivative<V, 6>, chebyshev_derivative<V, 7>};
    static_assert(derivatives.size() == highest_order + 1);
    return derivatives[std::size_t(k)](n, x);
}

// T_n^(k)(1), at least as large as any |T_n^(k)(x)| with x in [-1, 1].
Interval chebyshev_at_one(int n, int k) {
    Interval product = 1;
    for (int j = 0; j < k; ++j) product = product * (double(n) * n - double(j) * j) / (2.0 * j + 1);
    return product;
}

// Where T_n' is 0, ascending. j pi/n is rounded by less than 11 2^-53, its cosine by 2 more.
std::vector<Interval> roots_of_slope(int n) {
    std::vector<Interval> roots;
    for (int j = n - 1; j > 0; --j) {
        const double x = std::cos(j * std::numbers::pi / n);
        roots.emplace_back(x - 0x1p-49, x + 0x1p-49);
    }
    return roots;
}

// A root of T_n^(k), known to lie between those brackets, between doubles next to each other or
// between those where signs are still certain.
Interval isolate(int n, int k, Interval left, Interval right) {
    const auto sign_at = [&](double x) { return sign(chebyshev(n, k, x)); };
    double low = left.hi, high = right.lo;
    const int below = sign_at(low), above = sign_at(high);
    if (below * above >= 0) return hull(left, right);
    for (;;) {
        const double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high) return {low, high};
        const int here = sign_at(middle);
        if (here == below) {
            low = middle;
        } else if (here == above) {
            high = middle;
        } else { // at the root, as far as can be told
            for (double reach = 0x1p-53; reach < high - low; reach *= 2) {
                const double a = std::max(low, middle - reach), b = std::min(high, middle + reach);
                if (sign_at(a) == below && sign_at(b) == above) return {a, b};
            }
            return {low, high};
        }
    }
}

// T_n^(k) at its extremum in `where`: no further from the value at the left end than the slope
// there, and the most by which it may change on the way, allow.
Interval extreme_value(int n, int k, Interval where) {
    const Interval slope = enclosure(chebyshev(n, k + 1, where.lo));
    const double bend = chebyshev_at_one(n, k + 2).hi;
    const Interval way{0, width(where)};
    return enclosure(chebyshev(n, k, where.lo)) + way * (slope + way * Interval(-bend, bend));
}

} // namespace

ChebyshevEnclosure::ChebyshevEnclosure(int degree, int derivative)
    : degree_(degree)
    , derivative_(derivative)
    , at_one_(chebyshev_at_one(degree, derivative))
    , bound_(-at_one_.hi, at_one_.hi)
    , reach_(degree > highest_whole_degree ? chebyshev_reach(degree) : std::cosh(500.0 / degree)) {
    if (derivative >= degree || derivative >= highest_order) return;
    std::vector<Interval> roots = roots_of_slope(degree);
    for (int k = 1; k <= derivative; ++k) {
        std::vector<Interval> between;
        for (std::size_t j = 1; j < roots.size(); ++j)
            between.push_back(isolate(degree, k + 1, roots[j - 1], roots[j]));
        roots = std::move(between);
    }
    double value = degree % 2 == 0 ? -1 : 1; // of T_n at its leftmost extremum in (-1, 1)
    for (const Interval where : roots) {
        extrema_.push_back(
            {where, derivative == 0 ? value : extreme_value(degree, derivative, where)});
        value = -value;
    }
}

Interval ChebyshevEnclosure::at(double x) const {
    if (std::abs(x) <= reach_) return bounded(x, chebyshev(degree_, derivative_, x));
    // Beyond 1 values grow without end, or, evaluated, stay what they are at the reach.
    const Interval far{enclosure(chebyshev(degree_, derivative_, reach_)).lo, infinity};
    return x > 0 || (degree_ - derivative_) % 2 == 0 ? far : -far;
}

Interval ChebyshevEnclosure::at_ends(Interval a) const {
    if (is_point(a)) return at(a.lo);
    if (magnitude(a) > reach_) return hull(at(a.lo), at(a.hi));
    const DoubleDouble<Ends> values = chebyshev(degree_, derivative_, Ends{a.lo, a.hi});
    return hull(bounded(a.lo, one_of(values, 0)), bounded(a.hi, one_of(values, 1)));
}

Interval ChebyshevEnclosure::bounded(double x, DoubleDouble<double> value) const {
    return std::abs(x) <= 1 ? intersect(enclosure(value), bound_) : enclosure(value);
}

Interval ChebyshevEnclosure::operator()(Interval a) const {
    if (derivative_ >= degree_) return at_one_; // constant
    if (derivative_ >= highest_order) return magnitude(a) <= 1 ? bound_ : Interval::entire();
    Interval range = at_ends(a);
    auto extremum = std::lower_bound(extrema_.begin(), extrema_.end(), a.lo,
                                     [](const Extremum& e, double x) { return e.where.hi < x; });
    for (; extremum != extrema_.end() && extremum->where.lo <= a.hi; ++extremum)
        range = hull(range, extremum->value);
    return range;
}

} // namespace isomotion::formula
