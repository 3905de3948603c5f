#include "elements/tolerance.h"

#include <algorithm>

#include "elements/crowding.h"

namespace isomotion::elements {
namespace {

// Distances at which elements are counted, from the widest one down: each a part of the one before.
constexpr int shells = 40;
constexpr double narrower = 0.84;
constexpr int turns = 6;

struct Shell {
    double elements; // at most so many are nearer than the next shell
    double term;     // of one at this distance or farther
};

// What elements whose terms are at most `tolerance` add up to: each is in a shell, and counts with
// the smaller of the two.
double sum_of(std::span<const Shell> shells_outwards, double tolerance) {
    double sum = 0;
    for (std::size_t k = 0; k < shells_outwards.size(); ++k) {
        const double here = std::min(shells_outwards[k].term, tolerance);
        const double next =
            k + 1 < shells_outwards.size() ? std::min(shells_outwards[k + 1].term, tolerance) : 0.0;
        sum += shells_outwards[k].elements * (here - next);
    }
    return sum;
}

} // namespace

Tolerances tolerances(const ElementTerms& terms, std::span<const glm::dvec3> middles,
                      std::span<const double> allowed, double widest) {
    const Crowding crowding(middles);
    std::vector<double> distances{0}, counts;
    for (int k = shells - 1; k >= 0; --k) {
        double d = widest;
        for (int turn = 0; turn < k; ++turn) d *= narrower;
        distances.push_back(d);
    }
    for (std::size_t k = 1; k < distances.size(); ++k)
        counts.push_back(crowding.most_within(distances[k]));
    counts.push_back(double(middles.size()));

    Tolerances found;
    for (int sum = 0; sum < terms.sums(); ++sum) {
        const double wanted = allowed[std::size_t(sum)];
        std::vector<Shell> outwards;
        double before = magnitude(terms.bounds(sum, 0));
        for (std::size_t k = 0; k < distances.size(); ++k) {
            before = std::min(before, magnitude(terms.bounds(sum, distances[k])));
            outwards.push_back({counts[k], before});
        }
        const double safe = wanted / std::max(1.0, double(middles.size()));
        double tolerance = wanted / 8;
        for (int turn = 0; turn < turns && sum_of(outwards, tolerance) > wanted; ++turn)
            tolerance *= 0.9 * wanted / sum_of(outwards, tolerance);
        if (!(sum_of(outwards, tolerance) <= wanted)) tolerance = safe;
        found.of_term.push_back(std::max(tolerance, safe));
        found.of_sum.push_back(std::min(wanted, sum_of(outwards, found.of_term.back())));
    }
    return found;
}

} // namespace isomotion::elements
