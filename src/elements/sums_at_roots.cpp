#include "elements/sums_at_roots.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "formula/enclosure.h"
#include "formula/graph/continuity.h"
#include "formula/graph/substitute.h"

namespace isomotion::elements {
namespace {

using formula::Interval;

constexpr int split = 4;                               // parts of the region along each axis
constexpr double smallest = 0x1p-40, largest = 0x1p40; // of sums, in their units
constexpr int halvings = 14;                           // of the logarithm between these

// All but the elements of one array, whose sums are inputs.
formula::Bindings<Interval> values_of(const formula::Bindings<float>& bindings,
                                      std::size_t without) {
    formula::Bindings<float> rest;
    rest.parameters = bindings.parameters;
    rest.seed = bindings.seed;
    rest.arrays.resize(bindings.arrays.size());
    for (std::size_t a = 0; a < rest.arrays.size(); ++a) {
        if (a != without) rest.arrays[a] = bindings.arrays[a];
    }
    return formula::convert<Interval>(rest);
}

} // namespace

// Parts of the region.
class SumsAtRoots::Boxes {
public:
    Boxes(const SumsAtRoots& of, const formula::Bindings<float>& bindings, const Region& region)
        : evaluator_(of.field_)
        , bindings_(values_of(bindings, std::size_t(of.array_)))
        , inputs_(std::size_t(3 + of.sums_), std::vector<Interval>(split * split * split)) {
        for (int part = 0; part < split * split * split; ++part) {
            const glm::ivec3 at(part % split, part / split % split, part / (split * split));
            for (int k = 0; k < 3; ++k) {
                const double low = region.low[k], side = (region.high[k] - low) / split;
                inputs_[std::size_t(k)][std::size_t(part)] =
                    Interval(low + at[k] * side,
                             at[k] + 1 == split ? region.high[k] : low + (at[k] + 1) * side);
            }
        }
    }

    // Whether F is not 0 in any part, with these bounds of the sums.
    bool exclude_0(std::span<const Interval> sums) {
        for (std::size_t k = 0; k < sums.size(); ++k) std::ranges::fill(inputs_[3 + k], sums[k]);
        std::vector<Interval> values(inputs_[0].size()), gaps(values);
        const std::vector<std::span<const Interval>> from(inputs_.begin(), inputs_.end());
        const std::array<std::span<Interval>, 2> to{values, gaps};
        evaluator_.points(bindings_, from, to);
        for (std::size_t part = 0; part < values.size(); ++part) {
            const bool has_no_value = gaps[part].lo > 0;
            if (!has_no_value && contains(values[part], 0.0)) return false;
        }
        return true;
    }

private:
    formula::Evaluator<Interval> evaluator_;
    formula::Bindings<Interval> bindings_;
    std::vector<std::vector<Interval>> inputs_;
};

SumsAtRoots::SumsAtRoots(const formula::Field& field, int array)
    : array_(array) {
    formula::Graph graph = field.graph;
    const auto as_input = [&](formula::Graph& g, const formula::Node& node,
                              formula::NodeId rebuilt) {
        const bool is_sum = node.op == formula::Op::sum && node.index == array;
        return is_sum ? g.input(3 + sums_++) : rebuilt;
    };
    const formula::NodeId root =
        formula::substitute(graph, field.graph, std::array{field.root}, as_input)[0];
    field_ = formula::schedule(graph, std::array{root, formula::without_value(graph, root)});
}

double SumsAtRoots::least(const formula::Bindings<float>& bindings, const Region& region,
                          std::span<const Interval> units) const {
    Boxes boxes(*this, bindings, region);
    const auto count = std::size_t(sums_);
    std::vector<Interval> sums(count);
    const auto excludes = [&](double s) {
        for (std::size_t k = 0; k < sums.size(); ++k) sums[k] = {s * units[k].lo, s * units[k].hi};
        return boxes.exclude_0(sums);
    };
    double low = smallest, high = largest;
    if (!excludes(low)) return 0;
    for (int k = 0; k < halvings; ++k) {
        const double middle = std::sqrt(low * high);
        (excludes(middle) ? low : high) = middle;
    }
    return low;
}

bool SumsAtRoots::are_everything(const formula::Bindings<float>& bindings,
                                 const Region& region) const {
    Boxes boxes(*this, bindings, region);
    return boxes.exclude_0(std::vector<Interval>(std::size_t(sums_), Interval(0)));
}

} // namespace isomotion::elements
