#include "topology/motion.h"

#include <algorithm>

#include <fmt/format.h>

#include "animation/rules.h"
#include "formula/substitute.h"
#include "topology/clock.h"

namespace isomotion::topology {
namespace {

using formula::Graph;
using formula::Interval;
using formula::Node;
using formula::NodeId;
using formula::Op;

constexpr int time_input = clock_input + 1; // where the clock is a track

std::vector<NodeId> roots(const Motion& motion) {
    std::vector<NodeId> roots{motion.field};
    roots.insert(roots.end(), motion.low.begin(), motion.low.end());
    roots.insert(roots.end(), motion.high.begin(), motion.high.end());
    return roots;
}

bool reads(const Motion& motion, int input) {
    const std::vector<NodeId> all = formula::nodes_below(motion.graph, roots(motion));
    return std::any_of(all.begin(), all.end(), [&](NodeId id) {
        return motion.graph[id].op == Op::input && motion.graph[id].index == input;
    });
}

Motion piece(const scene::Scene& scene, Side side, double within, std::optional<int> driver) {
    Motion motion;
    motion.driver = driver;
    Graph& g = motion.graph;
    std::optional<animation::Driver> by;
    if (driver) by = {*driver, g.input(clock_input)};
    animation::Rules rules(scene.timeline.animation, within, g,
                           g.input(driver ? time_input : clock_input), by);
    const auto in_place = [&](Graph&, const Node& node, NodeId rebuilt) {
        if (node.op == Op::parameter) return rules.track(node.index);
        if (node.op == Op::element) return rules.field(node.index, node.second);
        return rebuilt;
    };
    const formula::Field& field = *scene.surface.field;
    motion.field = formula::substitute(g, field.graph, std::array{field.root}, in_place)[0];
    if (side == Side::positive) motion.field = g.unary(Op::negate, motion.field);

    const scene::Bounds& bounds = scene.surface.bounds;
    motion.shape = bounds.shape;
    if (bounds.shape == scene::Bounds::Shape::sphere) motion.radius = rules.track(bounds.radius);
    for (std::size_t k = 0; k < 3; ++k) {
        if (bounds.shape == scene::Bounds::Shape::box) {
            motion.low[k] = rules.track(bounds.min[k]);
            motion.high[k] = rules.track(bounds.max[k]);
        } else {
            motion.centre[k] = rules.track(bounds.centre[k]);
            motion.low[k] = g.subtract(motion.centre[k], motion.radius);
            motion.high[k] = g.add(motion.centre[k], motion.radius);
        }
    }
    motion.bindings.arrays = rules.columns();
    motion.bindings.seed = scene.timeline.animation.seed();
    motion.moves = reads(motion, clock_input) || reads(motion, time_input);
    return motion;
}

// The track that all motion goes through, with the surface as it depends on it.
std::optional<Motion> through_one_track(const scene::Scene& scene, Side side, double within) {
    const animation::Animation& animation = scene.timeline.animation;
    for (const animation::Array& array : animation.arrays()) {
        if (array.samples && array.samples->times().size() > 1) return std::nullopt;
    }
    for (std::size_t k = 0; k < animation.tracks().size(); ++k) {
        if (std::holds_alternative<double>(animation.tracks()[k].source)) continue;
        Motion motion = piece(scene, side, within, int(k));
        if (reads(motion, clock_input) && !reads(motion, time_input)) return motion;
    }
    return std::nullopt;
}

// Operations that may step from one value to another: where they do there is no derivative.
void find_steps(const Motion& motion, std::vector<std::string>& doubts) {
    for (const NodeId id : formula::nodes_below(motion.graph, roots(motion))) {
        const Op op = motion.graph[id].op;
        if (op != Op::floor && op != Op::sign && op != Op::random) continue;
        if (op == Op::random) {
            const auto below = formula::nodes_below(motion.graph, std::array{id});
            const bool rests = std::none_of(below.begin(), below.end(), [&](NodeId b) {
                return motion.graph[b].op == Op::input;
            });
            if (rests) continue;
        }
        const std::string doubt = fmt::format(
            "'{}' steps from value to value; what changes at a step is not seen", name(op));
        if (std::find(doubts.begin(), doubts.end(), doubt) == doubts.end()) doubts.push_back(doubt);
    }
}

} // namespace

Motions motions(const scene::Scene& scene, Side side, Interval range, Clock clock) {
    Motions all;
    const animation::Animation& animation = scene.timeline.animation;
    const std::vector<animation::Knot> knots = animation::knots(animation, range);
    for (const animation::Knot& knot : knots) {
        if (knot.jumps) all.jumps.push_back(knot.time);
    }
    if (clock == Clock::track_if_one && all.jumps.empty()) {
        if (auto motion = through_one_track(scene, side, mid(range))) {
            motion->clock = Driven(scene, *motion->driver, range).values();
            find_steps(*motion, all.doubts);
            all.pieces.push_back(std::move(*motion));
            return all;
        }
    }
    double from = range.lo;
    for (std::size_t k = 0; k <= knots.size(); ++k) {
        const double to = k < knots.size() ? knots[k].time : range.hi;
        Motion motion = piece(scene, side, from + (to - from) / 2, std::nullopt);
        motion.clock = {from, to};
        find_steps(motion, all.doubts);
        all.pieces.push_back(std::move(motion));
        from = to;
    }
    return all;
}

} // namespace isomotion::topology
