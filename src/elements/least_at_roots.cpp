#include "elements/least_at_roots.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "formula/evaluate/evaluate.h"
#include "formula/graph/derivative.h"
#include "formula/graph/substitute.h"

namespace isomotion::elements {
namespace {

using formula::Interval;

constexpr int least_input = 3;
constexpr std::size_t most = 4096; // boxes for one number
constexpr std::size_t most_parts = 16;

formula::Bindings<Interval> without_array(const formula::Bindings<float>& bindings,
                                          std::size_t array) {
    formula::Bindings<float> others = bindings;
    others.arrays[array] = {};
    return formula::convert<Interval>(others);
}

// F, then the parts whose signs are all that its sign depends on, if they are few.
std::vector<formula::NodeId> with_parts(const formula::Graph& graph, formula::NodeId root) {
    std::vector<formula::NodeId> open{root}, found{root};
    while (!open.empty()) {
        const formula::Node& node = graph[open.back()];
        const formula::NodeId id = open.back();
        open.pop_back();
        switch (node.op) {
        case formula::Op::min:
        case formula::Op::max:
        case formula::Op::multiply:
        case formula::Op::negate:
        case formula::Op::abs:
            open.insert(open.end(), node.children.begin(), node.children.begin() + node.arity);
            break;
        default:
            if (std::ranges::find(found, id) == found.end()) found.push_back(id);
        }
        if (found.size() + open.size() > most_parts) return {root};
    }
    return found;
}

} // namespace

LeastAtRoots::LeastAtRoots(const formula::Field& field, int array)
    : array_(std::size_t(array)) {
    formula::Graph graph;
    graph.fold_exactly();
    const auto as_input = [&](formula::Graph& g, const formula::Node& node,
                              formula::NodeId rebuilt) {
        const bool is_least = formula::is_over_elements(node.op) && node.index == array;
        return is_least ? g.input(least_input) : rebuilt;
    };
    const formula::NodeId root =
        formula::substitute(graph, field.graph, std::array{field.root}, as_input)[0];
    for (const formula::NodeId id : formula::nodes_below(graph, std::array{root})) {
        const formula::Node& node = graph[id];
        if (node.op == formula::Op::input && node.index < least_input)
            depends_on_[std::size_t(node.index)] = true;
    }
    const formula::NodeId zero = graph.constant(0), one = graph.constant(1);
    std::vector<formula::NodeId> outputs;
    for (const formula::NodeId part : with_parts(graph, root)) {
        outputs.push_back(part);
        outputs.push_back(formula::differentiate_inputs(graph, part, {zero, zero, zero, one},
                                                        formula::Slopes::generalized));
    }
    program_ = formula::schedule(graph, outputs);
}

// Divides the region until each box tells.
class LeastAtRoots::Search {
public:
    Search(const LeastAtRoots& of, const formula::Bindings<float>& bindings, const Region& region)
        : bindings_(without_array(bindings, of.array_))
        , program_(of.program_)
        , outputs_(of.program_.outputs.size())
        , depends_on_(of.depends_on_) {
        for (int k = 0; k < 3; ++k) region_[std::size_t(k)] = {region.low[k], region.high[k]};
    }

    // Whether no root in the region changes with L above `from`.
    bool is_enough(double from) {
        std::vector<Box> open{region_};
        std::size_t asked = 0;
        while (!open.empty()) {
            asked += open.size();
            if (asked > most) return false;
            std::vector<Box> rest;
            for (const Box& box : undecided(open, from)) {
                if (!halve(box, rest)) return false;
            }
            open = std::move(rest);
        }
        return true;
    }

private:
    using Box = std::array<Interval, 3>;

    // Those where F may be 0 and may change with L, and so may one of the parts.
    std::vector<Box> undecided(const std::vector<Box>& boxes, double from) {
        std::array<std::vector<Interval>, 4> inputs;
        for (const Box& box : boxes) {
            for (std::size_t k = 0; k < 3; ++k) inputs[k].push_back(box[k]);
            inputs[least_input].emplace_back(from, formula::infinity);
        }
        std::vector<std::vector<Interval>> told(outputs_, std::vector<Interval>(boxes.size()));
        const std::vector<std::span<const Interval>> in(inputs.begin(), inputs.end());
        program_.points(bindings_, in, std::vector<std::span<Interval>>(told.begin(), told.end()));
        std::vector<Box> left;
        for (std::size_t k = 0; k < boxes.size(); ++k) {
            const auto changes = [&](std::size_t output) {
                return formula::contains(told[output][k], 0.0) &&
                       told[output + 1][k] != Interval(0, 0);
            };
            bool may_change = outputs_ == 2;
            for (std::size_t output = 2; output < outputs_; output += 2)
                may_change = may_change || changes(output);
            if (may_change && changes(0)) left.push_back(boxes[k]);
        }
        return left;
    }

    // Along the widest side of those that tell; false without any.
    bool halve(const Box& box, std::vector<Box>& to) const {
        std::optional<std::size_t> widest;
        for (std::size_t k = 0; k < 3; ++k) {
            const bool is_wider = !widest || formula::width(box[k]) > formula::width(box[*widest]);
            if (depends_on_[k] && is_wider) widest = k;
        }
        if (!widest) return false;
        const std::size_t axis = *widest;
        Box low = box, high = box;
        low[axis].hi = high[axis].lo = formula::mid(box[axis]);
        to.push_back(low);
        to.push_back(high);
        return true;
    }

    formula::Bindings<Interval> bindings_;
    formula::Evaluator<Interval> program_;
    std::size_t outputs_;
    Box region_;
    std::array<bool, 3> depends_on_;
};

std::optional<double> LeastAtRoots::enough(const formula::Bindings<float>& bindings,
                                           const Region& region, const Interval& range) const {
    Search search(*this, bindings, region);
    const double span = range.hi - range.lo;
    if (!(span < formula::infinity) || !search.is_enough(range.hi)) return std::nullopt;
    constexpr int halvings = 14; // of the logarithm of a part of the range
    double low = 0x1p-40, high = 1;
    for (int k = 0; k < halvings; ++k) {
        const double middle = std::sqrt(low * high);
        (search.is_enough(range.lo + middle * span) ? high : low) = middle;
    }
    return range.lo + high * span;
}

} // namespace isomotion::elements
