#include "topology/field/box_field.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "formula/graph/substitute.h"

namespace isomotion::topology {
namespace {

using formula::Graph;
using formula::Interval;
using formula::Node;
using formula::NodeId;
using formula::Op;

// The sums over the largest array whose sums hold no others; none where there is no such array.
std::vector<NodeId> sums_to_cull(const Graph& graph, std::span<const NodeId> roots,
                                 std::span<const int> counts) {
    std::map<int, std::vector<NodeId>> sums;
    std::set<int> nested;
    for (const NodeId id : formula::nodes_below(graph, roots)) {
        if (graph[id].op != Op::sum) continue;
        sums[graph[id].index].push_back(id);
        const NodeId body = graph[id].children[0];
        for (const NodeId below : formula::nodes_below(graph, std::array{body})) {
            if (graph[below].op == Op::sum) nested.insert(graph[id].index);
        }
        if (graph[id].arrays != 0) nested.insert(graph[id].index);
    }
    const std::vector<NodeId>* largest = nullptr;
    int most = 0;
    for (const auto& [array, found] : sums) {
        if (nested.contains(array)) continue;
        const int count = counts[std::size_t(array)];
        if (largest && count <= most) continue;
        largest = &found;
        most = count;
    }
    return largest ? *largest : std::vector<NodeId>{};
}

} // namespace

BoxField::BoxField(Graph graph, std::span<const NodeId> jet, Inputs inputs, std::size_t rows,
                   std::span<const int> counts)
    : inputs_(inputs)
    , rows_(rows) {
    const std::size_t first_order = 1 + inputs.unknowns;
    std::vector<NodeId> roots(jet.begin(), jet.end());
    const std::vector<NodeId> sums = sums_to_cull(graph, roots, counts);
    if (!sums.empty()) {
        culling_ = culling(graph, sums, graph[sums[0]].index, jet.first(first_order));
        std::vector<Node> nodes;
        nodes.reserve(sums.size());
        for (const NodeId id : sums) nodes.push_back(graph[id]);
        const auto with_rest = [&](Graph& g, const Node& node, NodeId rebuilt) {
            const auto at = std::find(nodes.begin(), nodes.end(), node);
            if (at == nodes.end()) return rebuilt;
            return g.add(g.input(int(inputs_.count()) + int(at - nodes.begin())), rebuilt);
        };
        roots = formula::substitute(graph, graph, roots, with_rest);
    }
    value_ = formula::schedule(graph, std::span(roots).first(1));
    gradient_ = formula::schedule(graph, std::span(roots).first(first_order));
    jet_ = formula::schedule(graph, roots);
}

BoxField::Culling BoxField::culling(Graph& graph, std::span<const NodeId> sums, int array,
                                    std::span<const NodeId> first_order) const {
    Culling made;
    made.array = array;
    const std::vector<NodeId> below = formula::nodes_below(graph, first_order);
    std::vector<NodeId> bodies;
    bodies.reserve(sums.size());
    for (const NodeId id : sums) {
        made.is_first_order.push_back(std::ranges::binary_search(below, id));
        bodies.push_back(graph[id].children[0]);
    }
    std::map<int, int> place_of;
    const auto as_input = [&](Graph& g, const Node& node, NodeId rebuilt) {
        if (node.op != Op::element) return rebuilt;
        const auto [it, is_new] =
            place_of.try_emplace(node.second, int(inputs_.count() + place_of.size()));
        if (is_new) made.fields.push_back(node.second);
        return g.input(it->second);
    };
    made.terms = formula::schedule(graph, formula::substitute(graph, graph, bodies, as_input));
    return made;
}

BoxEvaluator::BoxEvaluator(const BoxField& field, formula::Bindings<Interval> bindings)
    : field_(field)
    , all_{std::move(bindings),
           std::vector<Interval>(field.culling_.is_first_order.size(), Interval(0))}
    , value_(field.value_)
    , gradient_(field.gradient_)
    , jet_(field.jet_)
    , terms_(field.culling_.terms) {}

void BoxEvaluator::load(std::size_t lane, const Box& box) {
    const std::size_t n = field_.inputs_.unknowns;
    for (std::size_t k = 0; k < n; ++k) inputs_[k][lane] = box[k];
    if (!field_.inputs_.has_ends) return;
    inputs_[n][lane] = box[n - 1].lo;
    inputs_[n + 1][lane] = box[n - 1].hi;
    inputs_[n + 2][lane] = {-1, 1};
}

void BoxEvaluator::load(const Elements& elements, std::span<const Box> boxes) {
    const std::size_t own = field_.inputs_.count();
    inputs_.resize(std::max(inputs_.size(), own + elements.rest.size()));
    for (std::size_t k = 0; k < own; ++k) inputs_[k].resize(boxes.size());
    for (std::size_t b = 0; b < boxes.size(); ++b) load(b, boxes[b]);
    for (std::size_t j = 0; j < elements.rest.size(); ++j)
        inputs_[own + j].assign(boxes.size(), elements.rest[j]);
}

void BoxEvaluator::run(formula::Evaluator<Interval>& program, const Elements& elements,
                       std::size_t outputs) {
    const std::size_t lanes = inputs_[0].size();
    outputs_.resize(std::max(outputs_.size(), outputs));
    const std::vector<std::span<const Interval>> from(inputs_.begin(), inputs_.end());
    std::vector<std::span<Interval>> to;
    for (std::size_t k = 0; k < outputs; ++k) {
        outputs_[k].resize(lanes);
        to.emplace_back(outputs_[k]);
    }
    program.points(elements.bindings, from, to);
}

void BoxEvaluator::values(const Elements& elements, std::span<const Box> boxes,
                          std::vector<Interval>& values) {
    load(elements, boxes);
    run(value_, elements, 1);
    values = outputs_[0];
}

void BoxEvaluator::gradients(const Elements& elements, std::span<const Box> boxes,
                             std::vector<Jet<Interval>>& jets) {
    const std::size_t n = field_.inputs_.unknowns;
    load(elements, boxes);
    run(gradient_, elements, 1 + n);
    jets.resize(boxes.size());
    for (std::size_t b = 0; b < boxes.size(); ++b)
        unpack(jets[b], n, 0, [&](std::size_t k) { return outputs_[k][b]; });
}

void BoxEvaluator::jets(const Elements& elements, std::span<const Box> boxes,
                        std::vector<Jet<Interval>>& jets) {
    load(elements, boxes);
    run(jet_, elements, field_.jet_.outputs.size());
    jets.assign(boxes.size(), {});
    for (std::size_t b = 0; b < boxes.size(); ++b) {
        unpack(jets[b], field_.inputs_.unknowns, field_.rows_,
               [&](std::size_t k) { return outputs_[k][b]; });
    }
}

Jet<Interval> BoxEvaluator::jet(const Box& box) {
    std::vector<Jet<Interval>> one;
    jets(all_, {&box, 1}, one);
    return one[0];
}

bool BoxEvaluator::run_terms(const Box& box, const Elements& from) {
    const BoxField::Culling& culling = field_.culling_;
    if (culling.array < 0) return false;
    const formula::ArrayColumns<Interval>& columns =
        from.bindings.arrays[std::size_t(culling.array)];
    const auto count = std::size_t(columns.count);
    if (count <= 1) return false;
    const std::size_t own = field_.inputs_.count();
    inputs_.resize(std::max(inputs_.size(), own + culling.fields.size()));
    for (std::size_t k = 0; k < own; ++k) inputs_[k].resize(1);
    load(0, box);
    for (std::size_t k = 0; k < own; ++k) inputs_[k].assign(count, Interval(inputs_[k][0]));
    for (std::size_t f = 0; f < culling.fields.size(); ++f)
        inputs_[own + f] = columns.fields[std::size_t(culling.fields[f])];
    run(terms_, from, culling.is_first_order.size());
    return true;
}

template<class Matters> Elements BoxEvaluator::kept(const Elements& from, Matters&& matters) const {
    const auto array = std::size_t(field_.culling_.array);
    const auto count = std::size_t(from.bindings.arrays[array].count);
    Elements kept = from;
    formula::ArrayColumns<Interval>& to = kept.bindings.arrays[array];
    std::size_t next = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (!matters(i)) {
            for (std::size_t j = 0; j < kept.rest.size(); ++j)
                kept.rest[j] = kept.rest[j] + outputs_[j][i];
            continue;
        }
        for (auto& field : to.fields) {
            if (!field.empty()) field[next] = field[i];
        }
        ++next;
    }
    to.count = int(next);
    for (auto& field : to.fields) {
        if (!field.empty()) field.resize(next);
    }
    return kept;
}

Elements BoxEvaluator::near(const Box& box, const Elements& from, double negligible) {
    if (!run_terms(box, from)) return from;
    const std::size_t sums = from.rest.size(), count = outputs_[0].size();
    std::vector<double> largest(sums, 0);
    for (std::size_t j = 0; j < sums; ++j) {
        for (std::size_t i = 0; i < count; ++i)
            largest[j] = std::max(largest[j], magnitude(outputs_[j][i]));
    }
    return kept(from, [&](std::size_t i) {
        bool matters = false;
        for (std::size_t j = 0; j < sums; ++j) {
            const double most = magnitude(outputs_[j][i]);
            matters |= std::isinf(most) || !(most <= negligible * largest[j]);
        }
        return matters;
    });
}

Elements BoxEvaluator::changing(const Box& box, const Elements& from, double negligible) {
    if (!run_terms(box, from)) return from;
    const std::size_t sums = from.rest.size(), count = outputs_[0].size();
    std::vector<double> size(sums, 0);
    for (std::size_t j = 0; j < sums; ++j) {
        for (std::size_t i = 0; i < count; ++i) size[j] += magnitude(outputs_[j][i]);
    }
    return kept(from, [&](std::size_t i) {
        bool matters = false;
        for (std::size_t j = 0; j < sums; ++j) {
            if (!field_.culling_.is_first_order[j]) continue;
            matters |= std::isinf(size[j]) || !(width(outputs_[j][i]) <= negligible * size[j]);
        }
        return matters;
    });
}

} // namespace isomotion::topology
