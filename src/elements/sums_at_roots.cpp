#include "elements/sums_at_roots.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "formula/enclosure.h"
#include "formula/graph/continuity.h"
#include "formula/graph/lowering.h"
#include "formula/graph/substitute.h"

namespace isomotion::elements {
namespace {

using formula::Interval;

constexpr int split = 4; // parts of the region along each axis
constexpr double smallest_sum = 0x1p-40, largest_sum = 0x1p40; // of sums, in their units
constexpr int sampled = 96, fewest_sampled = 8;                // places

// All but the elements of one array, whose sums are inputs.
formula::Bindings<float> without(const formula::Bindings<float>& bindings, std::size_t array) {
    formula::Bindings<float> rest;
    rest.parameters = bindings.parameters;
    rest.seed = bindings.seed;
    rest.arrays.resize(bindings.arrays.size());
    for (std::size_t a = 0; a < rest.arrays.size(); ++a) {
        if (a != array) rest.arrays[a] = bindings.arrays[a];
    }
    return rest;
}

// Evaluates F at places, where the sums are given as multiples of their units.
class Sampled {
public:
    Sampled(const formula::Program& field, formula::Bindings<double> bindings,
            std::span<const Interval> units)
        : evaluator_(field)
        , bindings_(std::move(bindings))
        , units_(units) {}

    // The values of F at a place where the sums, all together, are each of these multiples of their
    // units.
    std::vector<double> values(const glm::dvec3& p, std::span<const double> sums) {
        std::vector<std::vector<double>> inputs;
        inputs.reserve(3 + units_.size());
        for (int k = 0; k < 3; ++k) inputs.emplace_back(sums.size(), p[k]);
        for (const Interval& unit : units_) {
            inputs.emplace_back();
            for (const double s : sums) inputs.back().push_back(s * unit.hi);
        }
        std::vector<double> f(sums.size());
        const std::vector<std::span<const double>> from(inputs.begin(), inputs.end());
        const std::array<std::span<double>, 1> to{f};
        evaluator_.points(bindings_, from, to);
        return f;
    }
    double value(const glm::dvec3& p, double sums) {
        std::vector<double> inputs{p.x, p.y, p.z};
        for (const Interval& unit : units_) inputs.push_back(sums * unit.hi);
        double f = 0;
        evaluator_.point(bindings_, inputs, {&f, 1});
        return f;
    }
    // The least multiple at which F is 0, where its sign changes between powers of two.
    std::optional<double> root(const glm::dvec3& p) {
        std::vector<double> sums{0};
        for (double s = smallest_sum; s <= largest_sum; s *= 2) sums.push_back(s);
        const std::vector<double> f = values(p, sums);
        for (std::size_t k = 1; k < sums.size(); ++k) {
            if (!(f[k - 1] * f[k] < 0)) continue;
            double low = sums[k - 1], high = sums[k];
            for (int turn = 0; turn < 40; ++turn) {
                const double middle = 0.5 * (low + high);
                (value(p, middle) * f[k] > 0 ? high : low) = middle;
            }
            return high;
        }
        return std::nullopt;
    }

private:
    formula::Evaluator<double> evaluator_;
    formula::Bindings<double> bindings_;
    std::span<const Interval> units_;
};

} // namespace

SumsAtRoots::SumsAtRoots(const formula::Field& field, int array)
    : array_(array) {
    formula::Graph graph;
    graph.fold_exactly();
    const auto as_input = [&](formula::Graph& g, const formula::Node& node,
                              formula::NodeId rebuilt) {
        const bool is_sum = formula::is_over_elements(node.op) && node.index == array;
        return is_sum ? g.input(3 + sums_++) : rebuilt;
    };
    const formula::NodeId root =
        formula::substitute(graph, field.graph, std::array{field.root}, as_input)[0];
    for (const formula::NodeId id : formula::nodes_below(graph, std::array{root})) {
        const formula::Node& node = graph[id];
        depend_on_place_ = depend_on_place_ || (node.op == formula::Op::input && node.index < 3);
    }
    field_ = formula::schedule(graph, std::array{root, formula::without_value(graph, root)});
    numbers_ = formula::schedule_lowered(graph, root);
}

SumsAtRoots::Boxes::Boxes(const SumsAtRoots& of, const formula::Bindings<float>& bindings)
    : evaluator_(of.field_)
    , bindings_(formula::convert<Interval>(without(bindings, std::size_t(of.array_)))) {}

void SumsAtRoots::Boxes::exclude(std::span<const std::vector<Interval>> places_and_sums,
                                 std::vector<bool>& excluded) {
    const std::size_t count = places_and_sums[0].size();
    values_.resize(count);
    gaps_.resize(count);
    const std::vector<std::span<const Interval>> from(places_and_sums.begin(),
                                                      places_and_sums.end());
    evaluator_.points(bindings_, from, std::array{std::span(values_), std::span(gaps_)});
    excluded.resize(count);
    for (std::size_t k = 0; k < count; ++k)
        excluded[k] = gaps_[k].lo > 0 || !contains(values_[k], 0.0);
}

// Whether F is not 0 in any part of the region, with these bounds of the sums.
bool SumsAtRoots::exclude(Boxes& boxes, const Region& region,
                          std::span<const Interval> sums) const {
    std::vector<std::vector<Interval>> inputs(std::size_t(3 + sums_));
    for (int part = 0; part < split * split * split; ++part) {
        const glm::ivec3 at(part % split, part / split % split, part / (split * split));
        for (int k = 0; k < 3; ++k) {
            const double low = region.low[k], side = (region.high[k] - low) / split;
            inputs[std::size_t(k)].emplace_back(
                low + at[k] * side, at[k] + 1 == split ? region.high[k] : low + (at[k] + 1) * side);
        }
        for (std::size_t k = 0; k < sums.size(); ++k) inputs[3 + k].push_back(sums[k]);
    }
    std::vector<bool> excluded;
    boxes.exclude(inputs, excluded);
    return std::ranges::all_of(excluded, [](bool is) { return is; });
}

double SumsAtRoots::least(const formula::Bindings<float>& bindings, const Region& region,
                          std::span<const Interval> units) const {
    Boxes boxes(*this, bindings);
    std::vector<Interval> sums(std::size_t(sums_), Interval(0.0));
    const auto excludes = [&](double s) {
        for (std::size_t k = 0; k < sums.size(); ++k) sums[k] = {s * units[k].lo, s * units[k].hi};
        return exclude(boxes, region, sums);
    };
    constexpr int halvings = 14; // of the logarithm between these
    double low = smallest_sum, high = largest_sum;
    if (!excludes(low)) return 0;
    for (int k = 0; k < halvings; ++k) {
        const double middle = std::sqrt(low * high);
        (excludes(middle) ? low : high) = middle;
    }
    return low;
}

bool SumsAtRoots::exclude(const formula::Bindings<float>& bindings, const Region& region,
                          std::span<const Interval> sums) const {
    Boxes boxes(*this, bindings);
    return exclude(boxes, region, sums);
}

double SumsAtRoots::terms_of_others(const formula::Bindings<float>& bindings) const {
    const std::vector<int> counts = bindings.counts();
    return formula::cost(field_, counts).iterations;
}

double SumsAtRoots::sensitivity(const formula::Bindings<float>& bindings, const Region& region,
                                std::span<const Interval> units) const {
    Sampled field(numbers_, formula::convert<double>(without(bindings, std::size_t(array_))),
                  units);
    const glm::dvec3 sides = region.high - region.low;
    constexpr double near = 0x1p-10; // of the sides
    double least = std::numeric_limits<double>::infinity();
    constexpr double most_terms = 1e5; // of other arrays, at all places together
    const int places = int(std::clamp(most_terms / (1 + terms_of_others(bindings)),
                                      double(fewest_sampled), double(sampled)));
    for (int k = 0; k < places; ++k) {
        // Places that fill the region evenly: Roberts's sequence (2018).
        const glm::dvec3 part =
            glm::fract(0.5 + double(k) * glm::dvec3(0.8191725134, 0.6710436067, 0.5497004779));
        const glm::dvec3 p = region.low + part * sides;
        const std::optional<double> here = field.root(p);
        if (!here) continue;
        double slope = 0; // over a side
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 q = p;
            q[axis] += near * sides[axis];
            if (const auto beside = field.root(q))
                slope = std::max(slope, std::abs(*beside - *here) / near);
        }
        least = std::min(least, *here + slope);
    }
    return std::isfinite(least) ? least : 0;
}

} // namespace isomotion::elements
