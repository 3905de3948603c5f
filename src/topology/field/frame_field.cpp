#include "topology/field/frame_field.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <set>

#include "formula/graph/derivative.h"
#include "formula/graph/substitute.h"

namespace isomotion::topology {
namespace {

using formula::Graph;
using formula::Interval;
using formula::Node;
using formula::NodeId;
using formula::Op;

// Elements are left out of a sum where their terms' widths are this part of the terms' size, and
// their slopes' likewise.
constexpr double negligible = 0x1p-20;

// Nodes below the root that `is` holds for; not below those.
std::vector<NodeId> below(const Graph& graph, NodeId root,
                          const std::function<bool(const Node&)>& is) {
    std::vector<NodeId> stack{root}, found;
    std::set<NodeId> seen;
    while (!stack.empty()) {
        const NodeId id = stack.back();
        stack.pop_back();
        if (!seen.insert(id).second) continue;
        const Node& node = graph[id];
        if (is(node)) {
            found.push_back(id);
            continue;
        }
        for (std::size_t k = 0; k < node.arity; ++k) stack.push_back(node.children[k]);
    }
    std::ranges::sort(found);
    return found;
}

bool is_kink(const Node& node) {
    switch (node.op) {
    case Op::abs:
    case Op::sign:
    case Op::sqrt:
    case Op::log:
    case Op::asin:
    case Op::acos:
    case Op::floor:
    case Op::min:
    case Op::max:
    case Op::power:
    case Op::random:
    case Op::select:
        return true;
    default:
        return false;
    }
}

bool is_sum(const Node& node) { return node.op == Op::sum; }

// Sums whose terms are functions of the place and of one element.
std::vector<NodeId> plain_sums(const Graph& graph, NodeId root) {
    std::vector<NodeId> sums = below(graph, root, is_sum);
    std::erase_if(sums, [&](NodeId id) {
        return graph[id].arrays != 0 || !below(graph, graph[id].children[0], is_sum).empty();
    });
    return sums;
}

// Derivatives up to second order in the order they are stored: the value, x y z, xx xy xz yy yz zz.
constexpr std::size_t orders[] = {1, 4, 10}; // outputs up to an order
constexpr std::size_t second[3][3] = {{4, 5, 6}, {5, 7, 8}, {6, 8, 9}};

constexpr int first_input = 3; // after x, y, z
constexpr int sum_input(std::size_t sum) { return first_input + 10 * int(sum); }

// Slopes along an axis. `inputs_move`: inputs after x, y, z come in tens, a function of the place
// and its derivatives; else they are at rest.
NodeId slope(Graph& graph, NodeId root, std::size_t axis, bool inputs_move) {
    const auto leaf = [&](Graph& g, NodeId id) {
        const Node node = g[id];
        if (node.op != Op::input) return g.constant(0);
        if (node.index < first_input) return g.constant(node.index == int(axis) ? 1 : 0);
        const auto part = std::size_t(node.index - first_input) % 10;
        if (!inputs_move || part > 3) return g.constant(0);
        const std::size_t to = part == 0 ? 1 + axis : second[part - 1][axis];
        return g.input(node.index + int(to - part));
    };
    return formula::differentiate(graph, root, leaf, formula::Slopes::generalized);
}

// What must not be 0 in a box, so that the formula has second derivatives there: slopes of slopes
// do not enclose what happens across a kink. Empty if that can't be told.
std::optional<std::vector<NodeId>> kinks(Graph& g, NodeId root) {
    std::vector<NodeId> found;
    for (NodeId id : below(g, root, is_kink)) {
        const Node node = g[id]; // a copy: the graph grows
        if (node.arrays != 0) return std::nullopt;
        const NodeId a = node.children[0], b = node.children[1];
        switch (node.op) {
        case Op::abs:
        case Op::sqrt:
        case Op::log:
        case Op::power:
            found.push_back(a);
            break;
        case Op::min:
        case Op::max:
        case Op::select:
            found.push_back(g.subtract(a, b));
            break;
        default:
            return std::nullopt;
        }
        for (std::size_t k = 0; k < node.arity; ++k) {
            const auto deeper = kinks(g, node.children[k]);
            if (!deeper) return std::nullopt;
            found.insert(found.end(), deeper->begin(), deeper->end());
        }
    }
    return found;
}

ValueAndGradient at(const std::vector<std::vector<Interval>>& outputs, std::size_t k) {
    return {outputs[0][k], {outputs[1][k], outputs[2][k], outputs[3][k]}};
}

} // namespace

FrameField::ByOrder FrameField::by_order(Graph& graph, NodeId root, bool inputs_move) {
    std::vector<NodeId> outputs{root};
    ByOrder made;
    made[0] = std::make_unique<Runner>(formula::schedule(graph, outputs));
    for (std::size_t i = 0; i < 3; ++i) outputs.push_back(slope(graph, root, i, inputs_move));
    made[1] = std::make_unique<Runner>(formula::schedule(graph, outputs));
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = i; j < 3; ++j)
            outputs.push_back(slope(graph, outputs[1 + i], j, inputs_move));
    }
    const auto sharp = kinks(graph, root);
    if (sharp) outputs.insert(outputs.end(), sharp->begin(), sharp->end());
    made[2] = std::make_unique<Runner>(formula::schedule(graph, outputs));
    return made;
}

FrameField::FrameField(const SpaceFormula& formula)
    : bindings_(formula.bindings)
    , solid_(formula.solid) {
    Graph graph = formula.graph;
    const std::vector<NodeId> sums = plain_sums(graph, formula.root);
    for (NodeId sum : sums) {
        const int array = graph[sum].index;
        const NodeId body = graph[sum].children[0];
        std::set<int> fields;
        for (NodeId id : below(graph, body, [](const Node& n) { return n.op == Op::element; }))
            fields.insert(graph[id].second);
        sums_.push_back({array, std::vector(fields.begin(), fields.end()), {}});
        Sum& made = sums_.back();
        const auto to_input = [&](Graph& g, const Node& node, NodeId rebuilt) {
            if (node.op != Op::element) return rebuilt;
            const auto which = std::ranges::find(made.fields, node.second) - made.fields.begin();
            return g.input(first_input + int(which));
        };
        const NodeId term = formula::substitute(graph, graph, std::array{body}, to_input).front();
        made.term = by_order(graph, term, false);
        is_bent_ &= below(graph, term, is_kink).empty();
    }
    // What is below a plain sum stays as it is, so the sum is rebuilt as itself.
    const auto sum_to_input = [&](Graph& g, const Node&, NodeId rebuilt) {
        const auto which = std::ranges::find(sums, rebuilt);
        if (which == sums.end()) return rebuilt;
        return g.input(sum_input(std::size_t(which - sums.begin())));
    };
    const NodeId whole =
        formula::substitute(graph, graph, std::array{formula.root}, sum_to_input).front();
    whole_ = by_order(graph, whole, true);
    is_bent_ &= kinks(graph, whole).has_value();
    inputs_.resize(std::size_t(sum_input(sums_.size())));
}

FrameField::Near FrameField::everything() const {
    Near near;
    for (const Sum& sum : sums_) {
        const auto& array = bindings_.arrays[std::size_t(sum.array)];
        Elements elements;
        elements.count = array.count;
        for (int field : sum.fields) elements.columns.push_back(array.fields[std::size_t(field)]);
        near.push_back(std::move(elements));
    }
    return near;
}

void FrameField::Runner::run(const formula::Bindings<Interval>& bindings,
                             std::span<const std::vector<Interval>> inputs) {
    const std::vector<std::span<const Interval>> in(inputs.begin(), inputs.end());
    std::vector<std::span<Interval>> out;
    for (auto& output : outputs) {
        output.resize(inputs[0].size());
        out.emplace_back(output);
    }
    evaluator.points(bindings, in, out);
}

void FrameField::run(const Near& near, std::span<const SpaceBox> boxes, int order) {
    const std::size_t n = boxes.size();
    for (auto& input : inputs_) input.resize(n);
    for (std::size_t b = 0; b < n; ++b) {
        for (std::size_t axis = 0; axis < 3; ++axis) inputs_[axis][b] = boxes[b][axis];
    }
    for (std::size_t s = 0; s < sums_.size(); ++s) {
        const Sum& sum = sums_[s];
        const Elements& elements = near[s];
        const auto count = std::size_t(elements.count), outputs = orders[order];
        // Point b * count + e is element e in box b.
        term_inputs_.resize(first_input + sum.fields.size());
        for (auto& input : term_inputs_) input.clear();
        for (std::size_t b = 0; b < n; ++b) {
            for (std::size_t axis = 0; axis < 3; ++axis)
                term_inputs_[axis].insert(term_inputs_[axis].end(), count, boxes[b][axis]);
            for (std::size_t f = 0; f < sum.fields.size(); ++f) {
                auto& input = term_inputs_[first_input + f];
                input.insert(input.end(), elements.columns[f].begin(), elements.columns[f].end());
            }
        }
        Runner& term = *sum.term[std::size_t(order)];
        term.run(bindings_, term_inputs_);
        for (std::size_t b = 0; b < n; ++b) {
            const auto first = std::size_t(sum_input(s));
            for (std::size_t o = 0; o < outputs; ++o) {
                Interval total = elements.others[o];
                for (std::size_t e = b * count; e < (b + 1) * count; ++e)
                    total = total + term.outputs[o][e];
                inputs_[first + o][b] = total;
            }
        }
    }
    whole_[std::size_t(order)]->run(bindings_, inputs_);
}

void FrameField::over(const Near& near, std::span<const SpaceBox> boxes,
                      std::span<ValueAndGradient> out) {
    run(near, boxes, 1);
    for (std::size_t b = 0; b < boxes.size(); ++b) {
        const ValueAndGradient f = at(whole_[1]->outputs, b);
        out[b].value = of_solid(f.value);
        for (std::size_t i = 0; i < 3; ++i) out[b].gradient[i] = of_solid(f.gradient[i]);
    }
}

void FrameField::values(const Near& near, std::span<const SpaceBox> boxes,
                        std::span<Interval> out) {
    run(near, boxes, 0);
    for (std::size_t b = 0; b < boxes.size(); ++b) out[b] = of_solid(whole_[0]->outputs[0][b]);
}

void FrameField::tighten(const Near& near, std::span<const SpaceBox> boxes,
                         std::span<ValueAndGradient> out) {
    if (!is_bent_) return run(near, boxes, 1);
    std::vector<SpaceBox> middles;
    for (const SpaceBox& box : boxes) middles.push_back({mid(box[0]), mid(box[1]), mid(box[2])});
    std::vector<ValueAndGradient> at_middle(boxes.size());
    over(near, middles, at_middle);
    run(near, boxes, 2);
    for (std::size_t b = 0; b < boxes.size(); ++b) {
        if (!is_smooth_in(b)) continue;
        Interval value = at_middle[b].value;
        for (std::size_t i = 0; i < 3; ++i) {
            const Interval step = boxes[b][i] - middles[b][i];
            value = value + at_middle[b].gradient[i] * step;
        }
        for (std::size_t i = 0; i < 3; ++i) {
            Interval slope = at_middle[b].gradient[i];
            const Interval step_i = boxes[b][i] - middles[b][i];
            for (std::size_t j = 0; j < 3; ++j) {
                const Interval step_j = boxes[b][j] - middles[b][j];
                const Interval bend = of_solid(whole_[2]->outputs[second[i][j]][b]);
                slope = slope + bend * step_j;
                if (j == i) value = value + bend * square(step_i) * Interval(0.5);
                if (j > i) value = value + bend * (step_i * step_j);
            }
            out[b].gradient[i] = intersect(out[b].gradient[i], slope);
        }
        out[b].value = intersect(out[b].value, value);
    }
}

bool FrameField::is_smooth_in(std::size_t box) const {
    const auto& outputs = whole_[2]->outputs;
    return std::all_of(outputs.begin() + std::ptrdiff_t(orders[2]), outputs.end(),
                       [&](const auto& kink) { return mignitude(kink[box]) > 0; });
}

SpaceHessian FrameField::hessian(const Near& near, const SpaceBox& box) {
    SpaceHessian hessian;
    for (auto& row : hessian) row.fill(Interval::entire());
    if (!is_bent_) return hessian;
    run(near, {&box, 1}, 2);
    if (!is_smooth_in(0)) return hessian;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j)
            hessian[i][j] = of_solid(whole_[2]->outputs[second[i][j]][0]);
    }
    return hessian;
}

FrameField::Near FrameField::nearer(const Near& near, int k) const {
    const std::size_t order = is_bent_ ? 2 : 1;
    Near nearer;
    for (std::size_t s = 0; s < sums_.size(); ++s) {
        const Elements& elements = near[s];
        const auto count = std::size_t(elements.count), first = std::size_t(k) * count;
        const auto& outputs = sums_[s].term[order]->outputs;
        // How large the terms and their slopes are, and how far each of them changes.
        double size = 0, slope = 0;
        for (std::size_t e = first; e < first + count; ++e) {
            size += magnitude(outputs[0][e]);
            for (std::size_t o = 1; o < 4; ++o) slope += magnitude(outputs[o][e]);
        }
        Elements kept;
        kept.columns.resize(elements.columns.size());
        kept.others = elements.others;
        for (std::size_t e = 0; e < count; ++e) {
            bool matters = !(width(outputs[0][first + e]) <= negligible * size);
            for (std::size_t o = 1; o < 4; ++o)
                matters |= !(width(outputs[o][first + e]) <= negligible * slope);
            if (!matters) {
                for (std::size_t o = 0; o < orders[order]; ++o)
                    kept.others[o] = kept.others[o] + outputs[o][first + e];
                continue;
            }
            for (std::size_t f = 0; f < kept.columns.size(); ++f)
                kept.columns[f].push_back(elements.columns[f][e]);
            ++kept.count;
        }
        nearer.push_back(std::move(kept));
    }
    return nearer;
}

} // namespace isomotion::topology
