#include "nodes/singular_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "nodes/homogeneous.h"

namespace isomotion {
namespace {

// |grad G| / |Hess G| of a singular point. Measured: at most 6e-15 at the catalogue's nodes; 7e-9
// at local minima of Sarti's surface with its parameter rounded to float, and more at all others.
constexpr double tolerance = 1e-12;
// Below this fraction of the largest, a curvature is 0. At a cusp it is of the order of the root of
// |grad G|, at most 1e-6; at the catalogue's nodes it is 2e-3 or more.
constexpr double flat = 1e-4;
// The whole Hessian is 0 (a triple point) where it is so much smaller than on the way there.
// Measured: at most 2e-15 at such points, 1e-4 and more at nodes.
constexpr double vanishing = 1e-8;
constexpr double node_distance = 1e-6, degenerate_distance = 1e-2;
// Infinity, as 1/radius: a start is given up beyond the first, an end ignored beyond the second,
// since w G and its derivatives are differences of large numbers there.
constexpr double least_w = 1e-4, least_w_of_end = 1e-3;

// One start's way down |grad G|^2.
struct Descent {
    glm::dvec4 trial{0}; // to be evaluated next
    glm::dvec4 at{0};    // the best so far, and what is known there:
    double residual = std::numeric_limits<double>::infinity(); // |grad G|
    double size = 0;                                           // of Hess G across `at`
    glm::dmat3x4 tangents{0};
    glm::dmat3 hessian{0}; // of G, restricted to the tangents
    glm::dmat3 normal{0};  // of the least squares problem, and its right side
    glm::dvec3 slope{0};

    double damping = 1e-2;
    double largest_size = 0;
    double residual_before = std::numeric_limits<double>::infinity(); // `patience` steps ago
    int steps = 0;
    bool over = false;

    bool singular() const { return residual <= tolerance * size; }
    bool finite() const { return at.w >= least_w_of_end; }
};

constexpr int patience = 12, most_steps = 120;
constexpr double longest_step = 0.5; // radians

void propose(Descent& d) {
    const double trace = d.normal[0][0] + d.normal[1][1] + d.normal[2][2];
    glm::dvec3 step = -(glm::inverse(d.normal + glm::dmat3(d.damping * trace)) * d.slope);
    const double length = glm::length(step);
    if (length > longest_step) step *= longest_step / length;
    d.trial = glm::normalize(d.at + d.tangents * step);
    if (d.trial.w < 0) d.trial = -d.trial;
    if (!(d.trial.w > least_w)) d.over = true; // also for NaN
}

// What was found at the trial point; the next one.
void advance(Descent& d, const Homogeneous& g) {
    const double residual = glm::length(g.gradient);
    if (residual < d.residual) {
        d.at = d.trial;
        d.residual = residual;
        d.tangents = tangent_basis(d.at);
        const glm::dmat3x4 jacobian = g.hessian * d.tangents;
        d.hessian = glm::transpose(d.tangents) * jacobian;
        d.normal = glm::transpose(jacobian) * jacobian;
        d.slope = glm::transpose(jacobian) * g.gradient;
        d.size = std::sqrt(d.normal[0][0] + d.normal[1][1] + d.normal[2][2]);
        d.largest_size = std::max(d.largest_size, d.size);
        d.damping = std::max(d.damping / 10, 1e-18);
        d.over = residual <= 1e-15 * d.size;
    } else {
        d.damping *= 8;
        d.over = d.singular() || d.damping > 1e8;
    }
    if (++d.steps % patience == 0) {
        d.over = d.over || d.residual > 0.8 * d.residual_before || d.steps >= most_steps;
        d.residual_before = d.residual;
    }
    if (!d.over) propose(d);
}

void descend(std::vector<Descent>& descents, SecondOrderField& field, int degree) {
    std::vector<Descent*> active;
    for (Descent& d : descents) active.push_back(&d);
    std::vector<glm::dvec3> points;
    std::vector<SecondOrder> values;
    while (!active.empty()) {
        points.clear();
        for (const Descent* d : active) points.push_back(glm::dvec3(d->trial) / d->trial.w);
        values.resize(points.size());
        field.at(points, values);
        for (std::size_t k = 0; k < active.size(); ++k) {
            advance(*active[k], homogenise(values[k], points[k], degree));
        }
        std::erase_if(active, [](const Descent* d) { return d->over; });
    }
}

// Points evenly spread over the half sphere w > 0: the golden ratio's sequence in three dimensions
// (Roberts 2018), shifted at random, on two circles of random radii (Shoemake 1992).
class Starts {
public:
    explicit Starts(std::uint64_t seed) {
        std::mt19937_64 engine(seed);
        for (int k = 0; k < 3; ++k) at_[k] = double(engine() >> 11) * 0x1p-53;
    }
    glm::dvec4 next() {
        constexpr double ratio = 1.2207440846057596; // its 4th power is 1 + itself
        at_ = glm::fract(at_ +
                         glm::dvec3(1 / ratio, 1 / (ratio * ratio), 1 / (ratio * ratio * ratio)));
        const double a = std::sqrt(1 - at_.x), b = std::sqrt(at_.x);
        const double turn = 2 * std::numbers::pi;
        return {a * std::cos(turn * at_.y), a * std::sin(turn * at_.y), b * std::cos(turn * at_.z),
                std::abs(b * std::sin(turn * at_.z))};
    }

private:
    glm::dvec3 at_{0};
};

SingularPoint classify(const Descent& d) {
    SingularPoint point;
    point.direction = d.at;
    point.curvatures = eigenvalues(d.hessian) / d.size;
    if (d.size < vanishing * d.largest_size) return point;
    const glm::dvec3 sizes = glm::abs(point.curvatures);
    const double largest = std::max({sizes.x, sizes.y, sizes.z});
    for (int k = 0; k < 3; ++k) point.rank += sizes[k] > flat * largest;
    return point;
}

void add(std::vector<SingularPoint>& points, const SingularPoint& found, double distance) {
    const auto known = std::find_if(points.begin(), points.end(), [&](const SingularPoint& p) {
        return glm::length(p.direction - found.direction) < distance;
    });
    if (known == points.end()) {
        points.push_back(found);
    } else {
        ++known->hits;
    }
}

} // namespace

Census singular_points(const formula::Field& field, const formula::Bindings<double>& bindings,
                       const Effort& effort) {
    constexpr int sweep = 1024;
    SecondOrderField second_order(field, bindings);
    Census census;
    census.degree = degree_of(second_order);
    Starts starts(effort.seed);
    while (!census.settled && census.starts < effort.most_starts) {
        std::vector<Descent> descents(sweep);
        for (Descent& d : descents) d.trial = starts.next();
        descend(descents, second_order, census.degree);
        for (const Descent& d : descents) {
            if (!d.finite()) continue;
            if (!d.singular()) {
                census.nearest_miss = std::min(census.nearest_miss, d.residual / d.size);
                continue;
            }
            const SingularPoint point = classify(d);
            if (point.rank == 3) {
                add(census.nodes, point, node_distance);
            } else {
                add(census.degenerate, point, degenerate_distance);
            }
        }
        census.starts += sweep;
        census.settled = census.starts >= effort.fewest_starts &&
                         std::all_of(census.nodes.begin(), census.nodes.end(),
                                     [&](const SingularPoint& p) { return p.hits >= effort.hits; });
    }
    return census;
}

} // namespace isomotion
