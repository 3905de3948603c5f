#include "topology/search/comoving_fit.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "topology/search/krawczyk.h"
#include "topology/search/seeds.h"

namespace isomotion::topology {
namespace {

constexpr int samples = 2048;
// F counts as near 0 within about this part of the domain of its zeros.
constexpr double near = 0.05;
// Less of the change explained isn't worth the longer formula.
constexpr double worth_it = 0.5;
// The space may grow or shrink by this much to either end of the clock's range, so that it never
// turns inside out.
constexpr double most_growth = 0.75;
// Velocities are rounded to such a part of the domain over the whole range, so that what is at rest
// but for rounding rests.
constexpr double step = 0x1p-5;

double rounded(double rate, double unit) { return std::round(rate / unit) * unit; }

} // namespace

ComovingFrame fit_comoving_frame(const MovingField& field) {
    constexpr std::size_t d = 3, n = 4; // by, and growth
    const Box& domain = field.domain();
    const double range = domain[d].hi - domain[d].lo;
    double size = 0;
    for (std::size_t k = 0; k < d; ++k) size = std::max(size, domain[k].hi - domain[k].lo);
    if (!(range > 0) || !(size > 0)) return {};

    const Seeds seeds(field);
    std::vector<Point> points;
    points.reserve(std::size_t(samples));
    for (int number = 0; number < samples; ++number) points.push_back(seeds[number]);
    std::vector<Jet<double>> jets;
    Numbers(field).jets(points, jets);
    // Derivatives move along where dF_i/dt + sum of H_ij (by_j + growth x_j) is 0, for each i.
    Matrix normal{};
    Point right{};
    double change = 0;
    for (std::size_t s = 0; s < points.size(); ++s) {
        const Jet<double>& jet = jets[s];
        double squared_gradient = 0, scale = 0;
        for (std::size_t i = 0; i < d; ++i) {
            squared_gradient += jet.gradient[i] * jet.gradient[i];
            scale += std::pow(jet.hessian[i][d] * range, 2);
            for (std::size_t j = 0; j < d; ++j) scale += std::pow(jet.hessian[i][j] * size, 2);
        }
        const double reach = near * size * near * size * squared_gradient;
        const double weight = reach / (reach + jet.value * jet.value) / scale;
        if (!std::isfinite(weight)) continue;
        for (std::size_t i = 0; i < d; ++i) {
            Point row{};
            for (std::size_t j = 0; j < d; ++j) {
                row[j] = jet.hessian[i][j];
                row[d] += jet.hessian[i][j] * points[s][j];
            }
            for (std::size_t j = 0; j < n; ++j) {
                for (std::size_t k = 0; k < n; ++k) normal[j][k] += weight * row[j] * row[k];
                right[j] -= weight * row[j] * jet.hessian[i][d];
            }
            change += weight * jet.hessian[i][d] * jet.hessian[i][d];
        }
    }
    const auto y = inverse(normal, int(n));
    if (!y || !(change > 0)) return {};
    Point fit{};
    double explained = 0;
    for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t k = 0; k < n; ++k) fit[j] += (*y)[j][k] * right[k];
        explained += fit[j] * right[j];
    }
    if (!(explained >= worth_it * change)) return {};
    ComovingFrame frame;
    frame.from = mid(domain[d]);
    for (std::size_t k = 0; k < d; ++k) frame.by[k] = rounded(fit[k], step * size / range);
    const double most = 2 * most_growth / range;
    frame.growth = std::clamp(rounded(fit[d], step / range), -most, most);
    return frame;
}

MovingField comoving_field(const Motion& motion, const Stratum& stratum) {
    MovingField field(motion, stratum);
    if (field.dimension() < 3) return field;
    const ComovingFrame frame = fit_comoving_frame(field);
    return frame.rests() ? field : MovingField(motion, stratum, frame);
}

} // namespace isomotion::topology
