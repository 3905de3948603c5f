#include "topology/field/moving_field.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "formula/graph/derivative.h"
#include "formula/graph/lowering.h"
#include "formula/graph/substitute.h"
#include "topology/field/kinks.h"

namespace isomotion::topology {
namespace {

using formula::Graph;
using formula::Interval;
using formula::Node;
using formula::NodeId;
using formula::Op;

NodeId derivative(Graph& g, NodeId root, std::size_t by) {
    std::vector<NodeId> direction(most_variables, g.constant(0));
    direction[by] = g.constant(1);
    return formula::differentiate_inputs(g, root, direction, formula::Slopes::generalized);
}

NodeId drifting(Graph& g, const ComovingFrame& drift, std::size_t k, NodeId p, NodeId clock) {
    const NodeId since = g.subtract(clock, g.constant(drift.from));
    const NodeId scale = g.add(g.constant(1), g.multiply(since, g.constant(drift.growth)));
    return g.add(g.multiply(p, scale), g.multiply(since, g.constant(drift.by[k])));
}

// The largest parts of the roots that depend on coordinates and are linear in the clock. Not so
// large as products of places: twice evaluated they would cost more than they gain.
std::vector<NodeId> linear_in_clock(const Graph& g, std::span<const NodeId> roots, int clock) {
    constexpr int more = 2;
    struct Shape {
        int degree = 0;
        bool has_place = false;
    };
    std::map<NodeId, Shape> shapes;
    const std::vector<NodeId> below = formula::nodes_below(g, roots);
    for (const NodeId id : below) {
        const Node& node = g[id];
        Shape shape;
        int sum = 0;
        bool moves = false;
        for (std::size_t k = 0; k < node.arity; ++k) {
            const Shape& child = shapes[node.children[k]];
            shape.has_place |= child.has_place;
            shape.degree = std::max(shape.degree, child.degree);
            sum += child.degree;
            moves |= child.has_place && child.degree > 0;
        }
        if (node.op == Op::input) {
            shape = {node.index == clock, node.index < clock};
        } else if (node.op == Op::multiply) {
            shape.degree = moves ? more : std::min(sum, more);
        } else if (node.op != Op::add && node.op != Op::subtract && node.op != Op::negate) {
            if (shape.degree > 0) shape.degree = more;
        }
        shapes[id] = shape;
    }
    const auto is_linear = [&](NodeId id) {
        return shapes[id].degree == 1 && shapes[id].has_place;
    };
    std::set<NodeId> largest, wanted(roots.begin(), roots.end());
    for (auto id = below.rbegin(); id != below.rend(); ++id) { // parents first
        if (!wanted.contains(*id)) continue;
        if (is_linear(*id)) {
            largest.insert(*id);
            continue;
        }
        const Node& node = g[*id];
        for (std::size_t k = 0; k < node.arity; ++k) wanted.insert(node.children[k]);
    }
    return {largest.begin(), largest.end()};
}

// Of point `p` of the outputs of a jet's program.
template<class T>
Jet<T> unpacked(const std::vector<std::vector<T>>& outputs, std::size_t p, std::size_t n) {
    const std::size_t d = n - 1;
    Jet<T> jet;
    jet.value = outputs[0][p];
    for (std::size_t k = 0; k < n; ++k) jet.gradient[k] = outputs[1 + k][p];
    std::size_t at = 1 + n;
    for (std::size_t i = 0; i < d; ++i) {
        for (std::size_t j = i; j < n; ++j, ++at) {
            jet.hessian[i][j] = outputs[at][p];
            if (j < d) jet.hessian[j][i] = outputs[at][p];
        }
    }
    return jet;
}

} // namespace

int Stratum::dimension() const { return int(std::count(axes.begin(), axes.end(), End::free)); }

std::vector<Stratum> strata_of_box() {
    constexpr std::array ends{Stratum::End::free, Stratum::End::low, Stratum::End::high};
    std::vector<Stratum> strata;
    for (const auto x : ends) {
        for (const auto y : ends) {
            for (const auto z : ends) strata.push_back({{x, y, z}});
        }
    }
    std::stable_sort(strata.begin(), strata.end(), [](const Stratum& a, const Stratum& b) {
        return a.dimension() > b.dimension();
    });
    return strata;
}

MovingField::MovingField(const Motion& motion, const Stratum& stratum, const ComovingFrame& drift)
    : stratum_(stratum)
    , comoving_(drift)
    , variables_(stratum.dimension() + 1)
    , bindings_(motion.bindings) {
    Graph g = motion.graph;
    const auto n = std::size_t(variables_), d = n - 1;

    // Free coordinates move up, the others follow the bounds.
    std::array<NodeId, most_variables> stands_for{};
    std::vector<std::size_t> free_axes;
    const NodeId clock = g.input(int(d));
    const auto of_clock = [&](NodeId root) {
        return formula::substitute(g, g, std::array{root},
                                   [&](Graph&, const Node& node, NodeId rebuilt) {
                                       return node.op == Op::input ? clock : rebuilt;
                                   })[0];
    };
    std::array<NodeId, 3> low{}, high{};
    for (std::size_t k = 0; k < 3; ++k) {
        low[k] = of_clock(motion.low[k]);
        high[k] = of_clock(motion.high[k]);
        if (stratum.axes[k] == Stratum::End::free) {
            stands_for[k] = g.input(int(free_axes.size()));
            if (!drift.rests()) stands_for[k] = drifting(g, drift, k, stands_for[k], clock);
            free_axes.push_back(k);
        } else {
            stands_for[k] = stratum.axes[k] == Stratum::End::low ? low[k] : high[k];
        }
    }
    stands_for[clock_input] = clock;
    const auto on_stratum = [&](NodeId root) {
        return formula::substitute(
            g, g, std::array{root}, [&](Graph&, const Node& node, NodeId rebuilt) {
                return node.op == Op::input ? stands_for[std::size_t(node.index)] : rebuilt;
            })[0];
    };

    const NodeId field = on_stratum(motion.field);
    std::vector<NodeId> all{field};
    for (std::size_t k = 0; k < n; ++k) all.push_back(derivative(g, field, k));
    const NodeId kink = kinks(g, field);
    for (std::size_t i = 0; i < d; ++i) {
        for (std::size_t j = i; j < n; ++j) {
            all.push_back(g.add(derivative(g, all[1 + i], j), kink));
        }
    }
    Graph lowered = g;
    numbers_ = formula::schedule(lowered, formula::lower(lowered, all));

    if (!drift.rests()) all = between_ends(g, all);
    const std::vector<NodeId> culled = with_rests(g, all);
    value_ = formula::schedule(g, std::span(culled).first(1));
    gradient_ = formula::schedule(g, std::span(culled).first(1 + n));
    jet_ = formula::schedule(g, culled);

    std::vector<NodeId> conditions;
    for (std::size_t k = 0; k < d; ++k) {
        const NodeId x = stands_for[free_axes[k]];
        conditions.push_back(g.subtract(x, low[free_axes[k]]));
        conditions.push_back(g.subtract(high[free_axes[k]], x));
    }
    if (motion.shape == scene::Bounds::Shape::sphere && d == 3) {
        const NodeId r = of_clock(motion.radius);
        NodeId reach = g.multiply(r, r);
        for (std::size_t k = 0; k < 3; ++k) {
            const NodeId off = g.subtract(stands_for[k], of_clock(motion.centre[k]));
            reach = g.subtract(reach, g.multiply(off, off));
        }
        conditions.push_back(reach);
    }
    place_ = formula::schedule(g, conditions);

    std::vector<NodeId> inward;
    for (std::size_t k = 0; k < 3; ++k) {
        if (stratum.axes[k] == Stratum::End::free) continue;
        const NodeId slope = on_stratum(derivative(g, motion.field, k));
        inward.push_back(stratum.axes[k] == Stratum::End::low ? slope : g.unary(Op::negate, slope));
    }
    inward_ = formula::schedule(g, inward);

    domain_[d] = motion.clock;
    const formula::Program corners = formula::schedule(g, [&] {
        std::vector<NodeId> ends;
        for (const std::size_t k : free_axes) {
            ends.push_back(low[k]);
            ends.push_back(high[k]);
        }
        return ends;
    }());
    // Of coordinates that drift there is more to be had from short times.
    const int times = drift.rests() ? 1 : 64;
    formula::Evaluator<Interval> evaluator(corners);
    std::vector<Interval> ends(2 * d);
    double from = motion.clock.lo;
    for (int time = 1; time <= times; ++time) {
        const double to = time == times ? motion.clock.hi
                                        : motion.clock.lo + (motion.clock.hi - motion.clock.lo) *
                                                                (double(time) / times);
        Box at{};
        at[d] = {from, to};
        from = to;
        evaluator.point({}, at, ends);
        for (std::size_t k = 0; k < d; ++k) {
            Interval side{ends[2 * k].lo, ends[2 * k + 1].hi};
            if (!drift.rests()) side = drift.p(k, side, at[d]);
            domain_[k] = time == 1 ? side : hull(domain_[k], side);
        }
    }
}

Interval MovingField::x(const Box& box, std::size_t k) const {
    if (comoving_.rests()) return box[k];
    return comoving_.x(k, box[k], box[std::size_t(dimension())]);
}

// A function that is linear in the clock takes values between those at the clock's ends, whatever
// else it depends on. So x - c of an x that drifts and a c that moves is known as well as if
// neither moved: no enclosure by parts would know.
std::vector<NodeId> MovingField::between_ends(Graph& graph, std::span<const NodeId> roots) const {
    const int clock = dimension();
    const NodeId low = graph.input(variables_), high = graph.input(variables_ + 1);
    const NodeId either = graph.input(variables_ + 2);
    const std::vector<NodeId> linear = linear_in_clock(graph, roots, clock);
    const auto at = [&](NodeId end) {
        return formula::substitute(
            graph, graph, linear, [&](Graph&, const Node& node, NodeId rebuilt) {
                const bool is_clock = node.op == Op::input && node.index == clock;
                return is_clock ? end : rebuilt;
            });
    };
    const std::vector<NodeId> at_low = at(low), at_high = at(high);
    std::vector<Node> nodes;
    nodes.reserve(linear.size());
    for (const NodeId id : linear) nodes.push_back(graph[id]);
    return formula::substitute(
        graph, graph, roots, [&](Graph& g, const Node& node, NodeId rebuilt) {
            const auto found = std::find(nodes.begin(), nodes.end(), node);
            if (found == nodes.end()) return rebuilt;
            const auto which = std::size_t(found - nodes.begin());
            return g.select(either, g.constant(0), at_low[which], at_high[which]);
        });
}

// Sums over the largest array whose sums hold no others.
std::vector<NodeId> MovingField::with_rests(Graph& graph, std::span<const NodeId> roots) {
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
    for (const auto& [array, found] : sums) {
        if (nested.contains(array)) continue;
        const auto count = [&](int a) { return bindings_.arrays[std::size_t(a)].count; };
        if (culling_.array < 0 || count(array) > count(culling_.array)) culling_.array = array;
    }
    if (culling_.array < 0) return {roots.begin(), roots.end()};
    const std::vector<NodeId>& found = sums[culling_.array];
    culling_.sums = int(found.size());

    std::vector<NodeId> bodies;
    std::map<int, int> place_of;
    bodies.reserve(found.size());
    for (const NodeId id : found) bodies.push_back(graph[id].children[0]);
    const auto as_input = [&](Graph& g, const Node& node, NodeId rebuilt) {
        if (node.op != Op::element) return rebuilt;
        const auto [it, is_new] =
            place_of.try_emplace(node.second, int(first_rest() + place_of.size()));
        if (is_new) culling_.fields.push_back(node.second);
        return g.input(it->second);
    };
    const std::vector<NodeId> terms = formula::substitute(graph, graph, bodies, as_input);
    culling_.terms = formula::schedule(graph, terms);

    std::vector<Node> nodes;
    nodes.reserve(found.size());
    for (const NodeId id : found) nodes.push_back(graph[id]);
    const auto with_rest = [&](Graph& g, const Node& node, NodeId rebuilt) {
        const auto at = std::find(nodes.begin(), nodes.end(), node);
        if (at == nodes.end()) return rebuilt;
        return g.add(g.input(int(first_rest()) + int(at - nodes.begin())), rebuilt);
    };
    return formula::substitute(graph, graph, roots, with_rest);
}

Enclosures::Enclosures(const MovingField& field)
    : field_(field)
    , all_{formula::convert<Interval>(field.bindings_),
           std::vector<Interval>(std::size_t(field.culling_.sums), Interval(0))}
    , value_(field.value_)
    , gradient_(field.gradient_)
    , jet_(field.jet_)
    , place_(field.place_)
    , inward_(field.inward_)
    , terms_(field.culling_.terms) {}

void Enclosures::load(const Elements& elements, std::span<const Box> boxes) {
    const auto n = std::size_t(field_.variables_);
    const std::size_t first_rest = field_.first_rest();
    inputs_.resize(std::max(inputs_.size(), first_rest + elements.rest.size()));
    for (std::size_t k = 0; k < first_rest; ++k) inputs_[k].resize(boxes.size());
    for (std::size_t b = 0; b < boxes.size(); ++b) {
        for (std::size_t k = 0; k < n; ++k) inputs_[k][b] = boxes[b][k];
        if (first_rest > n) {
            inputs_[n][b] = boxes[b][n - 1].lo;
            inputs_[n + 1][b] = boxes[b][n - 1].hi;
            inputs_[n + 2][b] = {-1, 1};
        }
    }
    for (std::size_t j = 0; j < elements.rest.size(); ++j) {
        inputs_[first_rest + j].assign(boxes.size(), elements.rest[j]);
    }
}

void Enclosures::run(formula::Evaluator<Interval>& program, const Elements& elements,
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

void Enclosures::values(const Elements& elements, std::span<const Box> boxes,
                        std::vector<Interval>& values) {
    load(elements, boxes);
    run(value_, elements, 1);
    values = outputs_[0];
}

void Enclosures::gradients(const Elements& elements, std::span<const Box> boxes,
                           std::vector<Jet<Interval>>& jets) {
    const auto n = std::size_t(field_.variables_);
    load(elements, boxes);
    run(gradient_, elements, 1 + n);
    jets.resize(boxes.size());
    for (std::size_t b = 0; b < boxes.size(); ++b) {
        jets[b].value = outputs_[0][b];
        for (std::size_t k = 0; k < n; ++k) jets[b].gradient[k] = outputs_[1 + k][b];
    }
}

void Enclosures::jets(const Elements& elements, std::span<const Box> boxes,
                      std::vector<Jet<Interval>>& jets) {
    const auto n = std::size_t(field_.variables_);
    load(elements, boxes);
    run(jet_, elements, field_.jet_.outputs.size());
    jets.resize(boxes.size());
    for (std::size_t b = 0; b < boxes.size(); ++b) jets[b] = unpacked(outputs_, b, n);
}

Jet<Interval> Enclosures::jet(const Box& box) {
    std::vector<Jet<Interval>> one;
    jets(all_, {&box, 1}, one);
    return one[0];
}

std::span<const Interval> Enclosures::conditions(const Box& box) {
    conditions_.resize(field_.place_.outputs.size());
    place_.point(all_.bindings, box, conditions_);
    return conditions_;
}

Enclosures::Place Enclosures::place(const Box& box) {
    bool inside = true;
    for (const Interval& condition : conditions(box)) {
        if (condition.hi < 0) return Place::outside;
        inside &= condition.lo > 0;
    }
    return inside ? Place::inside : Place::unknown;
}

Interval Enclosures::reach(const Box& box) { return conditions(box).back(); }

std::vector<Interval> Enclosures::inward(const Box& box) {
    std::vector<Interval> slopes(field_.inward_.outputs.size());
    inward_.point(all_.bindings, box, slopes);
    return slopes;
}

Elements Enclosures::near(const Box& box, const Elements& from, double negligible) {
    const MovingField::Culling& culling = field_.culling_;
    if (culling.array < 0) return from;
    const auto n = std::size_t(field_.variables_), sums = std::size_t(culling.sums);
    const formula::ArrayColumns<Interval>& columns =
        from.bindings.arrays[std::size_t(culling.array)];
    const auto count = std::size_t(columns.count);
    if (count <= 1) return from;
    const std::size_t first_field = field_.first_rest();
    inputs_.resize(std::max(inputs_.size(), first_field + culling.fields.size()));
    for (std::size_t k = 0; k < n; ++k) inputs_[k].assign(count, box[k]);
    if (first_field > n) {
        inputs_[n].assign(count, box[n - 1].lo);
        inputs_[n + 1].assign(count, box[n - 1].hi);
        inputs_[n + 2].assign(count, {-1, 1});
    }
    for (std::size_t f = 0; f < culling.fields.size(); ++f) {
        inputs_[first_field + f] = columns.fields[std::size_t(culling.fields[f])];
    }
    run(terms_, from, sums);

    std::vector<double> largest(sums, 0);
    for (std::size_t j = 0; j < sums; ++j) {
        for (std::size_t i = 0; i < count; ++i) {
            largest[j] = std::max(largest[j], magnitude(outputs_[j][i]));
        }
    }
    Elements kept{from.bindings, from.rest};
    formula::ArrayColumns<Interval>& to = kept.bindings.arrays[std::size_t(culling.array)];
    std::size_t next = 0;
    for (std::size_t i = 0; i < count; ++i) {
        bool matters = false;
        for (std::size_t j = 0; j < sums; ++j) {
            const double most = magnitude(outputs_[j][i]);
            matters |= std::isinf(most) || !(most <= negligible * largest[j]);
        }
        if (!matters) {
            for (std::size_t j = 0; j < sums; ++j) {
                kept.rest[j] = kept.rest[j] + outputs_[j][i];
            }
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

Numbers::Numbers(const MovingField& field)
    : field_(field)
    , evaluator_(field.numbers_)
    , inputs_(std::size_t(field.variables_))
    , outputs_(field.numbers_.outputs.size()) {}

Jet<double> Numbers::jet(const Point& point) {
    std::vector<Jet<double>> one;
    jets({&point, 1}, one);
    return one[0];
}

void Numbers::jets(std::span<const Point> points, std::vector<Jet<double>>& jets) {
    const std::size_t n = inputs_.size();
    for (std::size_t k = 0; k < n; ++k) {
        inputs_[k].clear();
        for (const Point& point : points) inputs_[k].push_back(point[k]);
    }
    std::vector<std::span<double>> to;
    for (auto& output : outputs_) {
        output.resize(points.size());
        to.emplace_back(output);
    }
    const std::vector<std::span<const double>> from(inputs_.begin(), inputs_.end());
    evaluator_.points(field_.bindings_, from, to);
    jets.resize(points.size());
    for (std::size_t p = 0; p < points.size(); ++p) jets[p] = unpacked(outputs_, p, n);
}

} // namespace isomotion::topology
