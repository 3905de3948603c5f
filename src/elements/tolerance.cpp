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

std::vector<glm::dvec3> middles_of(const ElementTerms& terms, int quadric) {
    std::vector<glm::dvec3> middles;
    middles.reserve(std::size_t(terms.count()));
    for (int e = 0; e < terms.count(); ++e) middles.push_back(terms.quadric(e, quadric).centre);
    return middles;
}

// For each distance but the first, the most middles that are nearer than it to any place; at last
// the number of all middles.
std::vector<double> counts_within(std::span<const glm::dvec3> middles,
                                  std::span<const double> distances) {
    const Crowding crowding(middles);
    std::vector<double> counts;
    for (const double distance : distances.subspan(1))
        counts.push_back(crowding.most_within(distance));
    counts.push_back(double(middles.size()));
    return counts;
}

} // namespace

Tolerances tolerances(const ElementTerms& terms, std::span<const double> allowed, double widest) {
    std::vector<double> distances{0};
    for (int k = shells - 1; k >= 0; --k) {
        double d = widest;
        for (int turn = 0; turn < k; ++turn) d *= narrower;
        distances.push_back(d);
    }
    // For each quadric, counts of elements about whose middles its sums' terms are known.
    std::vector<std::vector<double>> counts_of;
    for (int k = 0; k < terms.quadrics(); ++k)
        counts_of.push_back(counts_within(middles_of(terms, k), distances));

    Tolerances found;
    for (int sum = 0; sum < terms.sums(); ++sum) {
        const double wanted = allowed[std::size_t(sum)];
        const std::vector<double>& counts = counts_of[std::size_t(terms.quadric_of(sum))];
        std::vector<Shell> outwards;
        double before = magnitude(terms.bounds(sum, 0));
        for (std::size_t k = 0; k < distances.size(); ++k) {
            before = std::min(before, magnitude(terms.bounds(sum, distances[k])));
            outwards.push_back({counts[k], before});
        }
        const double safe = wanted / std::max(1, terms.count());
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
