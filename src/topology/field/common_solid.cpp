#include "topology/field/common_solid.h"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "formula/graph/lowering.h"
#include "formula/graph/substitute.h"
#include "formula/interval/prune.h"
#include "scene/error.h"
#include "topology/field/relative_placement.h"

namespace isomotion::topology {
namespace {

using formula::Graph;
using formula::Interval;
using formula::Judged;
using formula::Node;
using formula::NodeId;
using formula::Op;

// A function that is negative inside the bounds. For a box it is made of the products of the
// distances from opposite faces: three functions that are smooth where six distances would meet in
// more kinks.
NodeId within_bounds(Graph& g, const Motion& motion) {
    const auto x = [&](std::size_t k) { return g.input(int(k)); };
    if (motion.shape == scene::Bounds::Shape::sphere) {
        NodeId sum = g.unary(Op::negate, g.multiply(motion.radius, motion.radius));
        for (std::size_t k = 0; k < 3; ++k) {
            const NodeId off = g.subtract(x(k), motion.centre[k]);
            sum = g.add(sum, g.multiply(off, off));
        }
        return sum;
    }
    NodeId most{};
    for (std::size_t k = 0; k < 3; ++k) {
        const NodeId between =
            g.multiply(g.subtract(x(k), motion.low[k]), g.subtract(x(k), motion.high[k]));
        most = k == 0 ? between : g.binary(Op::max, most, between);
    }
    return most;
}

// The two formulas in one graph, and the second one's bounds.
struct Pair {
    Motion motion; // the first one's
    NodeId second{}, second_bounds{};
};

animation::Rules placement_rules(const scene::OneSurface& one, double within, Graph& g) {
    return {one.surface.animation, within, g, g.input(clock_input)};
}

Pair paired(const Body& a, const Body& b, const Motion& of_a, Motion of_b, double within) {
    Pair pair{of_a};
    Graph& g = pair.motion.graph;
    animation::Rules rules_of_a = placement_rules(a.one, within, g);
    animation::Rules rules_of_b = placement_rules(b.one, within, g);
    const auto place = coordinates_in(g, placement_nodes(a.one.surface.placement, g, rules_of_a),
                                      placement_nodes(b.one.surface.placement, g, rules_of_b));
    const NodeId bounds = within_bounds(of_b.graph, of_b);
    auto& arrays = pair.motion.bindings.arrays;
    const auto nodes = formula::substitute(
        g, of_b.graph, std::array{of_b.field, bounds},
        [&](Graph&, const Node& node, NodeId rebuilt) {
            const bool is_place = node.op == Op::input && node.index < 3;
            return is_place ? place[std::size_t(node.index)] : rebuilt;
        },
        int(arrays.size()));
    pair.second = nodes[0];
    pair.second_bounds = nodes[1];
    std::ranges::move(of_b.bindings.arrays, std::back_inserter(arrays));
    return pair;
}

// Encloses one expression of the place and the clock.
class Enclosure {
public:
    Enclosure(const Motion& motion, NodeId root)
        : graph_(motion.graph)
        , program_(formula::schedule_lowered(graph_, root))
        , bindings_(formula::convert<Interval>(motion.bindings))
        , evaluator_(program_)
        , operations_(formula::cost(program_, bindings_.counts()).operations) {}

    Interval operator()(const std::array<Interval, 4>& box) {
        Interval value;
        evaluator_.point(bindings_, box, {&value, 1});
        return value;
    }
    double operations() const { return operations_; }

private:
    Graph graph_;
    formula::Program program_;
    formula::Bindings<Interval> bindings_;
    formula::Evaluator<Interval> evaluator_;
    double operations_;
};

// A domain that contains the first one's bounds at all times of the clock.
std::array<Interval, 4> domain_of(const Motion& motion) {
    std::array<Interval, 4> box{};
    box[3] = motion.clock;
    for (std::size_t k = 0; k < 3; ++k) {
        box[k] = {Enclosure(motion, motion.low[k])(box).lo,
                  Enclosure(motion, motion.high[k])(box).hi};
    }
    return box;
}

// Whether the two have nothing in common outside the second one's bounds, proved by intervals.
bool keeps_within_bounds(const Pair& pair) {
    constexpr double most_operations = 2e8;
    constexpr int most_boxes = 1 << 14;
    Enclosure bounds(pair.motion, pair.second_bounds);
    Enclosure first(pair.motion, pair.motion.field), second(pair.motion, pair.second);
    const std::array<Interval, 4> domain = domain_of(pair.motion);
    if (!std::ranges::all_of(domain,
                             [](Interval side) { return std::isfinite(side.hi - side.lo); }))
        return false;
    double operations = 0;
    int boxes = 0;
    return formula::prune(domain, [&](const std::array<Interval, 4>& box) {
        if (boxes++ == most_boxes || operations > most_operations) return Judged::refused;
        operations += bounds.operations();
        if (bounds(box).hi < 0) return Judged::settled;
        operations += first.operations() + second.operations();
        return first(box).lo > 0 || second(box).lo > 0 ? Judged::settled : Judged::open;
    });
}

Motion common(Pair pair) {
    const bool is_within = keeps_within_bounds(pair);
    Motion motion = std::move(pair.motion);
    Graph& g = motion.graph;
    motion.field = g.binary(Op::max, motion.field, pair.second);
    if (!is_within) motion.field = g.binary(Op::max, motion.field, pair.second_bounds);
    motion.moves = depends_on_clock(motion);
    return motion;
}

// Adds the spans in which a surface may be scaled to a point or turned inside out: scenes are
// refused for that at the times of frames only.
void find_points(const scene::OneSurface& one, double within, Interval clock,
                 std::vector<Interval>& spans) {
    Graph g;
    animation::Rules rules = placement_rules(one, within, g);
    const std::array scale{placement_nodes(one.surface.placement, g, rules).scale};
    find_not_positive(g, scale, clock, one.surface.animation.seed(), spans);
}

// Where a placement's rules change.
std::vector<animation::Knot> knots_of(const scene::OneSurface& one, Interval range) {
    Graph g;
    animation::Rules rules = placement_rules(one, mid(range), g);
    placement_nodes(one.surface.placement, g, rules);
    return animation::knots(one.surface.animation, rules.used(), range);
}

const Motion& piece_at(const Motions& all, double time) {
    const auto now = std::ranges::find_if(
        all.pieces, [&](const Motion& piece) { return contains(piece.clock, time); });
    return now == all.pieces.end() ? all.pieces.back() : *now;
}

const Motion& end_of(const Motions& all) { return all.at_end ? *all.at_end : all.pieces.back(); }

void expect_few_arrays(const Motions& a, const Motions& b) {
    const std::size_t arrays =
        a.pieces.front().bindings.arrays.size() + b.pieces.front().bindings.arrays.size();
    if (arrays <= std::size_t(formula::max_arrays)) return;
    throw scene::SceneError(fmt::format(
        "two surfaces with {} arrays together: contact is proved of at most {}; put elements of "
        "one kind into one array",
        arrays, formula::max_arrays));
}

// Joins two lists, each item once.
template<class T> void join(std::vector<T>& all, const std::vector<T>& more) {
    for (const T& one : more) {
        if (std::ranges::find(all, one) == all.end()) all.push_back(one);
    }
}

} // namespace

Motions common_motions(const Body& a, const Body& b, Interval range) {
    const Motions of_a = motions(a.one, a.side, range, Clock::time);
    const Motions of_b = motions(b.one, b.side, range, Clock::time);
    expect_few_arrays(of_a, of_b);
    Motions all;
    std::set<double> cuts{range.hi};
    for (const Motions* one : {&of_a, &of_b}) {
        for (const Motion& piece : one->pieces) cuts.insert(piece.clock.hi);
        join(all.jumps, one->jumps);
        join(all.collapses, one->collapses);
        join(all.doubts, one->doubts);
    }
    bool changes_at_end = of_a.at_end || of_b.at_end;
    for (const scene::OneSurface* one : {&a.one, &b.one}) {
        for (const animation::Knot& knot : knots_of(*one, range)) {
            cuts.insert(knot.time);
            if (knot.jumps) join(all.jumps, {knot.time});
            changes_at_end |= knot.time == range.hi;
        }
    }
    std::ranges::sort(all.jumps);
    if (changes_at_end) {
        Pair pair = paired(a, b, end_of(of_a), end_of(of_b), range.hi);
        pair.motion.clock = range.hi;
        all.at_end = common(std::move(pair));
    }
    double from = range.lo;
    for (const double to : cuts) {
        const double middle = from + (to - from) / 2;
        Pair pair = paired(a, b, piece_at(of_a, middle), piece_at(of_b, middle), middle);
        pair.motion.clock = {from, to};
        for (const Body* body : {&a, &b})
            find_points(body->one, middle, pair.motion.clock, all.collapses);
        Motion motion = common(std::move(pair));
        find_steps(motion, all.doubts);
        all.pieces.push_back(std::move(motion));
        from = to;
    }
    std::ranges::sort(all.collapses, {}, &Interval::lo);
    return all;
}

} // namespace isomotion::topology
