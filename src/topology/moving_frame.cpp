#include "topology/moving_frame.h"

#include <algorithm>

#include "formula/substitute.h"
#include "topology/field_moment.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

// The clock of a motion becomes the last parameter.
formula::NodeId without_clock(const Motion& motion, formula::Graph& to, formula::NodeId root) {
    const int clock = int(motion.bindings.parameters.size());
    return formula::substitute(
               to, motion.graph, std::array{root},
               [&](formula::Graph& g, const formula::Node& node, formula::NodeId rebuilt) {
                   const bool is_clock = node.op == formula::Op::input && node.index == clock_input;
                   return is_clock ? g.parameter(clock) : rebuilt;
               })
        .front();
}

} // namespace

MovingFrames::MovingFrames(const scene::Scene& scene, Side solid, Interval range)
    : motions_(motions(scene, solid, range, Clock::time)) {}

MovingFrames::Frame MovingFrames::at(Interval time) const {
    const auto now = std::ranges::find_if(
        motions_.pieces, [&](const Motion& motion) { return contains(motion.clock, mid(time)); });
    const Motion& motion = now != motions_.pieces.end() ? *now : motions_.pieces.back();
    Frame frame;
    frame.formula.bindings = formula::convert<Interval>(motion.bindings);
    frame.formula.bindings.parameters.push_back(time);
    frame.formula.root = without_clock(motion, frame.formula.graph, motion.field);

    formula::Bindings<Interval> middle = frame.formula.bindings;
    middle.parameters.back() = mid(time);
    const auto value = [&](formula::NodeId node) {
        formula::Graph graph;
        const formula::NodeId root = without_clock(motion, graph, node);
        const formula::Program program = formula::schedule(graph, std::array{root});
        const std::array<Interval, 3> nowhere{};
        Interval result;
        formula::Evaluator<Interval>(program).point(middle, nowhere, {&result, 1});
        return mid(result);
    };
    frame.bounds.shape = motion.shape;
    for (int i = 0; i < 3; ++i) {
        frame.bounds.min[i] = value(motion.low[std::size_t(i)]);
        frame.bounds.max[i] = value(motion.high[std::size_t(i)]);
    }
    if (motion.shape == scene::Bounds::Shape::sphere) {
        for (int i = 0; i < 3; ++i) frame.bounds.centre[i] = value(motion.centre[std::size_t(i)]);
        frame.bounds.radius = value(motion.radius);
    } else {
        frame.bounds.centre = 0.5 * (frame.bounds.min + frame.bounds.max);
        frame.bounds.radius = 0.5 * glm::distance(frame.bounds.min, frame.bounds.max);
    }
    return frame;
}

CertifiedFrame MovingFrames::certify(double time, const FrameLimits& limits) const {
    const Frame frame = at(time);
    return certify_frame(frame.formula, frame.bounds, limits);
}

KindProofs MovingFrames::proofs(const FrameLimits& limits) const {
    KindProofs proofs;
    proofs.moment = [this](const Event& event) {
        const Frame frame = at(event.time);
        return field_moment(frame.formula, frame.bounds);
    };
    proofs.frame = [this, limits](double time) { return certify(time, limits).betti; };
    return proofs;
}

} // namespace isomotion::topology
