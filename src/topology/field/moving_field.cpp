#include "topology/field/moving_field.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "formula/graph/continuity.h"
#include "formula/graph/lowering.h"
#include "formula/graph/substitute.h"

namespace isomotion::topology {
namespace {

using formula::Graph;
using formula::Interval;
using formula::Node;
using formula::NodeId;
using formula::Op;

NodeId from_rest(Graph& g, const ComovingFrame& frame, std::size_t k, NodeId p, NodeId clock) {
    const NodeId since = g.subtract(clock, g.constant(frame.from));
    const NodeId scale = g.add(g.constant(1), g.multiply(since, g.constant(frame.growth)));
    return g.add(g.multiply(p, scale), g.multiply(since, g.constant(frame.by[k])));
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

MovingField::MovingField(const Motion& motion, const Stratum& stratum, const ComovingFrame& frame,
                         std::span<const Interval> multipliers)
    : stratum_(stratum)
    , comoving_(frame)
    , dimension_(stratum.dimension())
    , variables_(dimension_ + int(multipliers.size()) + 1)
    , bindings_(motion.bindings) {
    Graph g = motion.graph;
    const auto n = std::size_t(variables_), d = std::size_t(dimension_);

    // Free coordinates move up, the others follow the bounds.
    std::array<NodeId, clock_input + 1> stands_for{};
    std::vector<std::size_t> free_axes;
    const NodeId clock = g.input(int(n - 1));
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
            if (!frame.rests()) stands_for[k] = from_rest(g, frame, k, stands_for[k], clock);
            free_axes.push_back(k);
        } else {
            stands_for[k] = stratum.axes[k] == Stratum::End::low ? low[k] : high[k];
        }
    }
    stands_for[clock_input] = clock;
    const auto on_stratum = [&](NodeId root) {
        return formula::substitute(
            g, g, std::array{root}, [&](Graph& to, const Node& node, NodeId rebuilt) {
                if (node.op != Op::input) return rebuilt;
                if (node.index <= clock_input) return stands_for[std::size_t(node.index)];
                return to.input(int(d) + node.index - first_multiplier_input);
            })[0];
    };

    const NodeId field = on_stratum(motion.field);
    std::array<std::size_t, most_variables> unknowns{};
    std::iota(unknowns.begin(), unknowns.end(), 0);
    std::vector<NodeId> jet = jet_over_boxes(g, field, std::span(unknowns).first(n), n - 1);
    // There is no surface where F has no value, and no need to look for it in ever smaller boxes.
    jet[0] = g.select(g.constant(0), formula::without_value(g, field), g.constant(1), jet[0]);
    Graph lowered = g;
    numbers_ = formula::schedule(lowered, formula::lower(lowered, jet));

    std::vector<SumSlopes> slopes;
    if (multipliers.empty()) slopes = slopes_of_sums(g, std::span(jet).first(1 + n), n - 1);
    if (!frame.rests()) between_ends(g, jet, slopes);
    over_boxes_ = BoxField(g, jet, {n, !frame.rests()}, n - 1, slopes);

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
        const NodeId rise = on_stratum(
            jet_over_boxes(g, motion.field, std::span(unknowns).subspan(k, 1), 0).back());
        inward.push_back(stratum.axes[k] == Stratum::End::low ? rise : g.unary(Op::negate, rise));
    }
    inward_ = formula::schedule(g, inward);

    domain_[n - 1] = motion.clock;
    std::ranges::copy(multipliers, domain_.begin() + dimension_);
    const formula::Program corners = formula::schedule(g, [&] {
        std::vector<NodeId> ends;
        for (const std::size_t k : free_axes) {
            ends.push_back(low[k]);
            ends.push_back(high[k]);
        }
        return ends;
    }());
    // Coordinates that move have tighter domains over short times.
    const int times = frame.rests() ? 1 : 64;
    formula::Evaluator<Interval> evaluator(corners);
    formula::Bindings<Interval> bindings; // bounds are expressions of the clock
    bindings.seed = motion.bindings.seed;
    std::vector<Interval> ends(2 * d);
    double from = motion.clock.lo;
    for (int time = 1; time <= times; ++time) {
        const double to = time == times ? motion.clock.hi
                                        : motion.clock.lo + (motion.clock.hi - motion.clock.lo) *
                                                                (double(time) / times);
        Box at{};
        at[n - 1] = {from, to};
        from = to;
        evaluator.point(bindings, at, ends);
        for (std::size_t k = 0; k < d; ++k) {
            Interval side{ends[2 * k].lo, ends[2 * k + 1].hi};
            if (!frame.rests()) side = frame.p(k, side, at[n - 1]);
            domain_[k] = time == 1 ? side : hull(domain_[k], side);
        }
    }
}

Interval MovingField::x(const Box& box, std::size_t k) const {
    if (comoving_.rests()) return box[k];
    return comoving_.x(k, box[k], box[clock()]);
}

// A function that is linear in the clock takes values between those at the clock's ends, whatever
// else it depends on. So x - c of an x that moves along and a c that moves is known as well as if
// neither moved: no enclosure by parts would know.
void MovingField::between_ends(Graph& graph, std::vector<NodeId>& jet,
                               std::vector<SumSlopes>& slopes) const {
    std::vector<NodeId*> all;
    all.reserve(jet.size());
    for (NodeId& root : jet) all.push_back(&root);
    for (SumSlopes& of : slopes) {
        for (NodeId& root : of.first) all.push_back(&root);
        for (NodeId& root : of.second) all.push_back(&root);
        all.push_back(&of.unless_smooth);
    }
    const auto as_roots = [&] {
        std::vector<NodeId> roots;
        roots.reserve(all.size());
        for (const NodeId* root : all) roots.push_back(*root);
        return roots;
    };
    const int clock = variables_ - 1;
    const NodeId low = graph.input(variables_), high = graph.input(variables_ + 1);
    const NodeId either = graph.input(variables_ + 2);
    const std::vector<NodeId> linear = linear_in_clock(graph, as_roots(), clock);
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
    for (SumSlopes& of : slopes) all.push_back(&of.sum); // as the jet has it
    const std::vector<NodeId> rewritten = formula::substitute(
        graph, graph, as_roots(), [&](Graph& g, const Node& node, NodeId rebuilt) {
            const auto found = std::find(nodes.begin(), nodes.end(), node);
            if (found == nodes.end()) return rebuilt;
            const auto which = std::size_t(found - nodes.begin());
            return g.select(either, g.constant(0), at_low[which], at_high[which]);
        });
    for (std::size_t k = 0; k < all.size(); ++k) *all[k] = rewritten[k];
}

Enclosures::Enclosures(const MovingField& field)
    : BoxEvaluator(field.over_boxes_, formula::convert<Interval>(field.bindings_))
    , place_(field.place_)
    , inward_(field.inward_)
    , conditions_(field.place_.outputs.size())
    , inward_values_(field.inward_.outputs.size()) {}

std::span<const Interval> Enclosures::conditions(const Box& box) {
    place_.point(all().bindings, box, conditions_);
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

std::vector<Interval> Enclosures::inward(const Box& box) {
    inward_.point(all().bindings, box, inward_values_);
    return inward_values_;
}

Numbers::Numbers(const MovingField& field)
    : field_(field)
    , evaluator_(field.numbers_, std::size_t(field.variables_), field.clock()) {}

Jet<double> Numbers::jet(const Point& point) {
    std::vector<Jet<double>> one;
    jets({&point, 1}, one);
    return one[0];
}

void Numbers::jets(std::span<const Point> points, std::vector<Jet<double>>& jets) {
    evaluator_.evaluate(field_.bindings_, points);
    jets.resize(points.size());
    for (std::size_t p = 0; p < points.size(); ++p) jets[p] = evaluator_.jet(p);
}

} // namespace isomotion::topology
