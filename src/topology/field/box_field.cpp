#include "topology/field/box_field.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "formula/graph/substitute.h"

namespace isomotion::topology {
using formula::Graph;
using formula::Interval;
using formula::Node;
using formula::NodeId;
using formula::Op;

std::map<int, BoxField::Loops> BoxField::loops_to_cull(const Graph& graph,
                                                       std::span<const NodeId> roots) {
    std::map<int, Loops> loops;
    std::set<int> nested;
    for (const NodeId id : formula::nodes_below(graph, roots)) {
        const Node& node = graph[id];
        if (!formula::is_over_elements(node.op)) continue;
        Loops& over = loops[node.index];
        if (node.op == Op::sum) {
            over.sums.push_back(id);
        } else if (std::ranges::find(over.keys, node.children[0]) == over.keys.end()) {
            over.keys.push_back(node.children[0]);
        }
        const std::span<const NodeId> bodies(node.children.data(), node.arity);
        for (const NodeId below : formula::nodes_below(graph, bodies)) {
            if (formula::is_over_elements(graph[below].op)) nested.insert(node.index);
        }
        if (node.arrays != 0) nested.insert(node.index);
    }
    std::erase_if(loops, [&](const auto& array) { return nested.contains(array.first); });
    return loops;
}

BoxField::BoxField(Graph graph, std::span<const NodeId> jet, Inputs inputs, std::size_t rows,
                   std::span<const SumSlopes> slopes)
    : inputs_(inputs)
    , rows_(rows) {
    const std::size_t first_order = 1 + inputs.unknowns;
    std::vector<Node> sums;
    for (const auto& [array, loops] : loops_to_cull(graph, jet)) {
        cullings_.push_back(culling(graph, array, loops, jet.first(first_order), slopes));
        cullings_.back().first_sum = sums.size();
        for (const NodeId id : loops.sums) sums.push_back(graph[id]);
    }
    sums_ = sums.size();
    const auto with_rest = [&](auto&& rest) {
        if (sums.empty()) return std::vector<NodeId>(jet.begin(), jet.end());
        return formula::substitute(
            graph, graph, jet, [&](Graph& g, const Node& node, NodeId rebuilt) {
                const auto at = std::find(sums.begin(), sums.end(), node);
                if (at == sums.end()) return rebuilt;
                return g.add(rest(g, std::size_t(at - sums.begin())), rebuilt);
            });
    };
    const std::vector<NodeId> roots =
        with_rest([&](Graph& g, std::size_t sum) { return g.input(int(inputs_.count() + sum)); });
    value_ = formula::schedule(graph, std::span(roots).first(1));
    gradient_ = formula::schedule(graph, std::span(roots).first(first_order));
    jet_ = formula::schedule(graph, roots);
    if (std::ranges::none_of(cullings_, &Culling::can_expand)) return;

    for (const NodeId id : formula::nodes_below(graph, jet)) {
        if (graph[id].op != Op::parameter) continue;
        middle_ = std::max(middle_, std::size_t(graph[id].index) + 1);
    }
    std::size_t next = middle_ + inputs_.unknowns;
    for (const Node& sum : sums) {
        Remainder& remainder = remainders_.emplace_back();
        remainder.first_parameter = next;
        const auto known =
            std::ranges::find_if(slopes, [&](const SumSlopes& of) { return graph[of.sum] == sum; });
        if (known != slopes.end()) {
            remainder.slopes = known->first.size();
            remainder.second = known->second.size();
        }
        next += remainder.parameters();
    }
    const std::vector<NodeId> expanded_roots =
        with_rest([&](Graph& g, std::size_t sum) { return expanded(g, remainders_[sum]); });
    expanded_value_ = formula::schedule(graph, std::span(expanded_roots).first(1));
    expanded_gradient_ = formula::schedule(graph, std::span(expanded_roots).first(first_order));
    expanded_jet_ = formula::schedule(graph, expanded_roots);
}

NodeId BoxField::expanded(Graph& g, const Remainder& remainder) const {
    auto next = int(remainder.first_parameter);
    const auto off = [&](std::size_t k) {
        return g.subtract(g.input(int(k)), g.parameter(int(middle_ + k)));
    };
    NodeId all = g.parameter(next++);
    for (std::size_t k = 0; k < remainder.slopes; ++k)
        all = g.add(all, g.multiply(g.parameter(next++), off(k)));
    for (std::size_t i = 0, left = remainder.second; left > 0; ++i) {
        for (std::size_t j = 0; j <= i; ++j, --left)
            all = g.add(all, g.multiply(g.parameter(next++), g.multiply(off(i), off(j))));
    }
    return all;
}

BoxField::Culling BoxField::culling(Graph& graph, int array, const Loops& loops,
                                    std::span<const NodeId> first_order,
                                    std::span<const SumSlopes> slopes) const {
    Culling made;
    made.array = array;
    made.keys = loops.keys.size();
    const std::vector<NodeId> below = formula::nodes_below(graph, first_order);
    std::vector<NodeId> bodies, more, in_middle;
    bodies.reserve(loops.sums.size() + loops.keys.size());
    NodeId unless_smooth = graph.constant(0);
    for (const NodeId id : loops.sums) {
        made.is_first_order.push_back(std::ranges::binary_search(below, id));
        bodies.push_back(graph[id].children[0]);
        const auto known = std::ranges::find(slopes, id, &SumSlopes::sum);
        if (known == slopes.end()) continue;
        made.can_expand = true;
        in_middle.push_back(graph[id].children[0]);
        if (!known->second.empty())
            in_middle.insert(in_middle.end(), known->first.begin(),
                             known->first.begin() + std::ptrdiff_t(rows_));
        more.insert(more.end(), known->first.begin(), known->first.end());
        more.insert(more.end(), known->second.begin(), known->second.end());
        unless_smooth = graph.add(unless_smooth, known->unless_smooth);
    }
    more.push_back(unless_smooth);
    bodies.insert(bodies.end(), loops.keys.begin(), loops.keys.end());
    std::map<int, int> place_of;
    const auto as_input = [&](Graph& g, const Node& node, NodeId rebuilt) {
        if (node.op != Op::element) return rebuilt;
        const auto [it, is_new] =
            place_of.try_emplace(node.second, int(inputs_.count() + place_of.size()));
        if (is_new) made.fields.push_back(node.second);
        return g.input(it->second);
    };
    made.terms = formula::schedule(graph, formula::substitute(graph, graph, bodies, as_input));
    if (!made.can_expand) return made;
    bodies.insert(bodies.end(), more.begin(), more.end());
    made.expansion = formula::schedule(graph, formula::substitute(graph, graph, bodies, as_input));
    made.middle = formula::schedule(graph, formula::substitute(graph, graph, in_middle, as_input));
    return made;
}

BoxEvaluator::BoxEvaluator(const BoxField& field, formula::Bindings<Interval> bindings)
    : field_(field)
    , all_{std::move(bindings), std::vector<Interval>(field.sums_, Interval(0))}
    , value_(field.value_)
    , gradient_(field.gradient_)
    , jet_(field.jet_)
    , expanded_value_(field.expanded_value_)
    , expanded_gradient_(field.expanded_gradient_)
    , expanded_jet_(field.expanded_jet_) {
    for (const auto& culling : field.cullings_) {
        terms_.emplace_back(culling.terms);
        expansions_.emplace_back(culling.expansion);
        middles_.emplace_back(culling.middle);
    }
}

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
    if (elements.are_expanded()) return;
    for (std::size_t j = 0; j < elements.rest.size(); ++j)
        inputs_[own + j].assign(boxes.size(), elements.rest[j]);
}

void BoxEvaluator::run(Evaluator& program, const Elements& elements, std::size_t outputs) {
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
    run(of(elements, value_, expanded_value_), elements, 1);
    values = outputs_[0];
}

void BoxEvaluator::gradients(const Elements& elements, std::span<const Box> boxes,
                             std::vector<Jet<Interval>>& jets) {
    const std::size_t n = field_.inputs_.unknowns;
    load(elements, boxes);
    run(of(elements, gradient_, expanded_gradient_), elements, 1 + n);
    jets.resize(boxes.size());
    for (std::size_t b = 0; b < boxes.size(); ++b)
        unpack(jets[b], n, 0, [&](std::size_t k) { return outputs_[k][b]; });
}

void BoxEvaluator::jets(const Elements& elements, std::span<const Box> boxes,
                        std::vector<Jet<Interval>>& jets) {
    load(elements, boxes);
    run(of(elements, jet_, expanded_jet_), elements, field_.jet_.outputs.size());
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

void BoxEvaluator::run_terms(Evaluator& program, const BoxField::Culling& culling,
                             std::span<const Box> boxes, const Elements& from,
                             std::size_t outputs) {
    const auto& columns = from.bindings.arrays[std::size_t(culling.array)];
    const std::size_t own = field_.inputs_.count(), lanes = boxes.size() * columns.count;
    inputs_.resize(std::max(inputs_.size(), own + culling.fields.size()));
    for (std::size_t k = 0; k < own; ++k) inputs_[k].resize(lanes);
    for (std::size_t b = 0, lane = 0; b < boxes.size(); ++b) {
        for (int i = 0; i < columns.count; ++i) load(lane++, boxes[b]);
    }
    for (std::size_t f = 0; f < culling.fields.size(); ++f) {
        const auto& field = columns.fields[std::size_t(culling.fields[f])];
        inputs_[own + f].clear();
        for (std::size_t b = 0; b < boxes.size(); ++b)
            inputs_[own + f].insert(inputs_[own + f].end(), field.begin(), field.end());
    }
    run(program, from, outputs);
}

template<class Size, class Matters>
Elements BoxEvaluator::cull(const Box& box, const Elements& from, Size&& size, Matters&& matters) {
    Elements kept = from;
    for (std::size_t which = 0; which < terms_.size(); ++which) {
        const BoxField::Culling& culling = field_.cullings_[which];
        formula::ArrayColumns<Interval>& columns = kept.bindings.arrays[std::size_t(culling.array)];
        const auto count = std::size_t(columns.count), sums = culling.is_first_order.size();
        if (count <= 1) continue;
        run_terms(terms_[which], culling, {&box, 1}, from, sums + culling.keys);
        std::vector<double> least; // the least is no greater
        for (std::size_t j = sums; j < sums + culling.keys; ++j) {
            least.push_back(formula::infinity);
            for (std::size_t i = 0; i < count; ++i)
                least.back() = std::min(least.back(), outputs_[j][i].hi);
        }
        std::vector<double> sizes;
        for (std::size_t j = 0; j < sums; ++j)
            sizes.push_back(size(std::span<const Interval>(outputs_[j]).first(count)));
        std::size_t next = 0;
        for (std::size_t i = 0; i < count; ++i) {
            bool is_kept = false;
            for (std::size_t j = 0; j < sums; ++j)
                is_kept |= matters(outputs_[j][i], sizes[j], culling.is_first_order[j] != 0);
            for (std::size_t j = 0; j < culling.keys; ++j)
                is_kept |= outputs_[sums + j][i].lo <= least[j];
            if (!is_kept) {
                for (std::size_t j = 0; j < sums; ++j) {
                    Interval& rest = kept.rest[culling.first_sum + j];
                    rest = rest + outputs_[j][i];
                }
                continue;
            }
            for (auto& field : columns.fields) {
                if (!field.empty()) field[next] = field[i];
            }
            ++next;
        }
        columns.count = int(next);
        for (auto& field : columns.fields) {
            if (!field.empty()) field.resize(next);
        }
    }
    return kept;
}

Elements BoxEvaluator::near(const Box& box, const Elements& from, double negligible) {
    // An infinite term, beside a pole, is kept; what is negligible is told by the largest finite
    // one.
    const auto largest = [](std::span<const Interval> terms) {
        double most = 0;
        for (const Interval& term : terms) {
            if (!std::isinf(magnitude(term))) most = std::max(most, magnitude(term));
        }
        return most;
    };
    return cull(box, from, largest, [&](const Interval& term, double most, bool) {
        return std::isinf(magnitude(term)) || !(magnitude(term) <= negligible * most);
    });
}

Elements BoxEvaluator::changing(const Box& box, const Elements& from, double negligible) {
    const auto all = [](std::span<const Interval> terms) {
        double sum = 0;
        for (const Interval& term : terms) sum += magnitude(term);
        return sum;
    };
    return cull(box, from, all, [&](const Interval& term, double size, bool is_first_order) {
        return is_first_order && (std::isinf(size) || !(width(term) <= negligible * size));
    });
}

} // namespace isomotion::topology
