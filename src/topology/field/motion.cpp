#include "topology/field/motion.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "animation/rules.h"
#include "formula/graph/chebyshev_form.h"
#include "formula/graph/continuity.h"
#include "formula/graph/functions.h"
#include "formula/graph/lowering.h"
#include "formula/graph/substitute.h"
#include "formula/interval/prune.h"
#include "topology/field/idle_parts.h"
#include "topology/field/monotone_track.h"

namespace isomotion::topology {
namespace {

using formula::Graph;
using formula::Interval;
using formula::Judged;
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

// For each node, whether there is no input below it.
std::vector<bool> resting(const Graph& graph, std::span<const NodeId> below) {
    std::vector<bool> rests(graph.size(), false);
    for (const NodeId id : below) {
        const Node& node = graph[id];
        bool rest = node.op != Op::input;
        for (std::size_t k = 0; k < node.arity; ++k) rest = rest && rests[node.children[k]];
        rests[id] = rest;
    }
    return rests;
}

// What an element is computed from and doesn't move is computed once, in double, as constants are
// folded: floor(i/2) is then what the animation says, not what an enclosure of i/2 leaves of it.
void fold_elements(Motion& motion) {
    Graph& g = motion.graph;
    const std::vector<NodeId> below = formula::nodes_below(g, std::array{motion.field});
    const std::vector<bool> rests = resting(g, below);
    const auto folds = [&](NodeId id) {
        return rests[id] && std::has_single_bit(g[id].arrays) &&
               !formula::is_over_elements(g[id].op);
    };
    std::vector<bool> is_whole(g.size(), false); // folds, and some parent doesn't
    for (const NodeId id : below) {
        for (std::size_t k = 0; k < g[id].arity; ++k) {
            const NodeId child = g[id].children[k];
            is_whole[child] = is_whole[child] || (folds(child) && !folds(id));
        }
    }
    std::vector<Node> wholes;
    std::vector<NodeId> columns;
    for (const NodeId id : below) {
        if (!is_whole[id] || g[id].arity == 0) continue;
        const Node node = g[id];
        const int array = std::countr_zero(node.arrays);
        formula::ArrayColumns<double>& of = motion.bindings.arrays[std::size_t(array)];
        std::vector<int> fields;
        NodeId alone = formula::substitute(
            g, g, std::array{id}, [&](Graph& to, const Node& leaf, NodeId rebuilt) {
                if (leaf.op != Op::element) return rebuilt;
                const auto at = std::find(fields.begin(), fields.end(), leaf.second);
                const auto input = int(at - fields.begin());
                if (at == fields.end()) fields.push_back(leaf.second);
                return to.input(input);
            })[0];
        const formula::Program program = formula::schedule_lowered(g, alone);
        formula::Evaluator<double> evaluator(program);
        std::vector<double> column(std::size_t(of.count));
        for (std::size_t i = 0; i < column.size(); ++i) {
            std::vector<double> inputs;
            inputs.reserve(fields.size());
            for (const int field : fields) inputs.push_back(of.fields[std::size_t(field)][i]);
            evaluator.point(motion.bindings, inputs, {&column[i], 1});
        }
        wholes.push_back(node);
        columns.push_back(g.element(array, int(of.fields.size())));
        of.fields.push_back(std::move(column));
    }
    motion.field = formula::substitute(
        g, g, std::array{motion.field}, [&](Graph&, const Node& node, NodeId rebuilt) {
            const auto at = std::find(wholes.begin(), wholes.end(), node);
            return at == wholes.end() ? rebuilt : columns[std::size_t(at - wholes.begin())];
        })[0];
}

Motion piece(const scene::OneSurface& one, Side side, double within, std::optional<int> driver,
             animation::Parts* used = nullptr) {
    Motion motion;
    motion.driver = driver;
    Graph& g = motion.graph;
    std::optional<animation::Driver> by;
    if (driver) by = {*driver, g.input(clock_input)};
    animation::Rules rules(one.surface.animation, within, g,
                           g.input(driver ? time_input : clock_input), by);
    // A track without a value leaves the formula none, though min or 0*c would hide it.
    const auto in_place = [&](Graph& to, const Node& node, NodeId rebuilt) {
        const NodeId made = rules.in_place(node, rebuilt);
        return made == rebuilt ? made : formula::with_gaps(to, made);
    };
    const formula::Field& field = *one.surface.field;
    Graph named = field.graph;
    const auto number = [&](int parameter) -> std::optional<double> {
        const animation::TrackSource& source =
            one.surface.animation.tracks()[std::size_t(parameter)].source;
        const auto* constant = std::get_if<double>(&source);
        return constant ? std::optional(*constant) : std::nullopt;
    };
    const NodeId smooth = formula::chebyshev_on_paper(named, field.root, number);
    // Where F has no value stays so when a number in place of a name lets that vanish: 0*log(x).
    const NodeId root = formula::with_gaps(named, smooth);
    motion.field = formula::substitute(g, named, std::array{root}, in_place)[0];
    if (side == Side::positive) motion.field = g.unary(Op::negate, motion.field);

    const scene::Bounds& bounds = one.surface.bounds;
    motion.shape = bounds.shape;
    const auto track = [&](int k) { return formula::with_gaps(g, rules.track(k)); };
    if (bounds.shape == scene::Bounds::Shape::sphere) motion.radius = track(bounds.radius);
    for (std::size_t k = 0; k < 3; ++k) {
        if (bounds.shape == scene::Bounds::Shape::box) {
            motion.low[k] = track(bounds.min[k]);
            motion.high[k] = track(bounds.max[k]);
        } else {
            motion.centre[k] = track(bounds.centre[k]);
            motion.low[k] = g.subtract(motion.centre[k], motion.radius);
            motion.high[k] = g.add(motion.centre[k], motion.radius);
        }
    }
    motion.bindings.arrays = rules.columns();
    motion.bindings.seed = one.surface.animation.seed();
    if (used) *used = rules.used();
    fold_elements(motion);
    motion.moves = depends_on_clock(motion);
    return motion;
}

// The track that all motion goes through, with the surface as it depends on it. No rule beside the
// track's own may change in the range: where something rests at one time, it may move at another.
std::optional<Motion> through_one_track(const scene::OneSurface& one, const animation::Parts& parts,
                                        Side side, Interval range) {
    const animation::Animation& animation = one.surface.animation;
    for (const int k : parts.arrays) {
        const auto& samples = animation.arrays()[std::size_t(k)].samples;
        if (samples && samples->times().size() > 1) return std::nullopt;
    }
    for (const int k : parts.tracks) {
        if (std::holds_alternative<double>(animation.tracks()[std::size_t(k)].source)) continue;
        animation::Parts beside;
        Motion motion = piece(one, side, mid(range), k, &beside);
        beside.tracks.erase(k);
        if (!animation::knots(animation, beside, range).empty()) continue;
        if (reads(motion, clock_input) && !reads(motion, time_input)) return motion;
    }
    return std::nullopt;
}

// The piece with the way between two keys for its clock, if all tracks that move ease between
// these. By time F would not move at the keys, where events are then degenerate; by the way it
// does.
std::optional<Motion> by_easing(const Motion& piece, const animation::Animation& animation,
                                const animation::Parts& parts) {
    std::optional<Easing> easing;
    for (const int k : parts.tracks) {
        const auto* keys = std::get_if<animation::Keys>(&animation.tracks()[std::size_t(k)].source);
        if (!keys || keys->ease != animation::Ease::smooth) continue;
        for (std::size_t at = 1; at < keys->keys.size(); ++at) {
            const animation::Key &from = keys->keys[at - 1], &to = keys->keys[at];
            if (piece.clock.hi <= from.time || to.time <= piece.clock.lo) continue;
            if (easing && (easing->from != from.time || easing->to != to.time)) return std::nullopt;
            easing = {from.time, to.time, piece.clock};
        }
    }
    if (!easing) return std::nullopt;
    Motion eased = piece;
    Graph& g = eased.graph;
    const Node way = g[animation::smooth_way(g, g.input(clock_input), easing->from, easing->to)];
    // First by another input than the clock, so that what else reads the clock shows; then by the
    // clock.
    const auto replace = [&](auto&& in_place) {
        const auto all = [&](NodeId& root) {
            root = formula::substitute(g, g, std::array{root}, in_place)[0];
        };
        all(eased.field);
        all(eased.radius);
        for (auto* corner : {&eased.low, &eased.high, &eased.centre})
            std::ranges::for_each(*corner, all);
    };
    replace([&](Graph& to, const Node& node, NodeId rebuilt) {
        return node == way ? to.input(time_input) : rebuilt;
    });
    if (reads(eased, clock_input)) return std::nullopt;
    replace([&](Graph& to, const Node& node, NodeId rebuilt) {
        const bool is_way = node.op == Op::input && node.index == time_input;
        return is_way ? to.input(clock_input) : rebuilt;
    });
    eased.easing = easing;
    eased.clock = easing->way(piece.clock);
    return eased;
}

// Spans of the piece's clock, which is the time, in which the bounds may be empty or turned inside
// out: scenes are refused for that at the times of frames only.
void find_collapses(const Motion& motion, std::vector<Interval>& collapses) {
    Graph g = motion.graph;
    std::vector<NodeId> wholes; // greater than 0 while the bounds hold anything
    if (motion.shape == scene::Bounds::Shape::sphere) {
        wholes.push_back(motion.radius);
    } else {
        for (std::size_t k = 0; k < 3; ++k)
            wholes.push_back(g.subtract(motion.high[k], motion.low[k]));
    }
    find_not_positive(g, wholes, motion.clock, motion.bindings.seed, collapses);
}

} // namespace

void find_not_positive(const Graph& graph, std::span<const NodeId> lengths, Interval clock,
                       std::uint64_t seed, std::vector<Interval>& spans) {
    Graph g;
    std::vector<NodeId> wholes;
    for (const NodeId root : lengths) {
        wholes.push_back(formula::substitute(
            g, graph, std::array{root}, [](Graph& to, const Node& node, NodeId rebuilt) {
                return node.op == Op::input ? to.input(0) : rebuilt;
            })[0]);
    }
    const formula::Program program = formula::schedule(g, wholes);
    formula::Bindings<Interval> bindings;
    bindings.seed = seed;
    formula::Evaluator<Interval> evaluator(program);
    std::vector<Interval> values(wholes.size());
    // Two halves that touch are one span.
    const auto add = [&](Interval time) {
        if (!spans.empty() && spans.back().hi == time.lo) {
            spans.back().hi = time.hi;
        } else {
            spans.push_back(time);
        }
    };
    constexpr double smallest = 0x1.01p-14; // part of the clock, but for rounding
    [[maybe_unused]] const bool is_searched =
        formula::prune(std::array{clock}, [&](const std::array<Interval, 1>& part) {
            const Interval time = part[0];
            evaluator.point(bindings, part, values);
            if (std::ranges::all_of(values, [](Interval value) { return value.lo > 0; }))
                return Judged::settled;
            const bool collapses_all =
                std::ranges::any_of(values, [](Interval value) { return value.hi <= 0; });
            const bool is_small = formula::longest_side(part, std::array{clock}).part <= smallest;
            if (!collapses_all && !is_small) return Judged::open;
            add(time);
            return Judged::settled;
        });
    assert(is_searched); // nothing is refused, and what can't be halved is small
}

void find_steps(const Motion& motion, std::vector<std::string>& doubts) {
    const std::vector<NodeId> below = formula::nodes_below(motion.graph, roots(motion));
    const std::vector<bool> rests = resting(motion.graph, below);
    for (const NodeId id : below) {
        const Op op = motion.graph[id].op;
        if (!formula::may_jump(op)) continue;
        if (rests[id]) continue;
        const std::string doubt = fmt::format(
            "'{}' steps from value to value; what changes at a step is not seen", name(op));
        if (std::find(doubts.begin(), doubts.end(), doubt) == doubts.end()) doubts.push_back(doubt);
    }
}

bool depends_on_clock(const Motion& motion) {
    return reads(motion, clock_input) || reads(motion, time_input);
}

Interval with_ends_in_doubt(Interval clock) {
    constexpr double doubt = 4 * std::numeric_limits<double>::epsilon();
    const double by = doubt * magnitude(clock);
    return {clock.lo - by, clock.hi + by};
}

Motions motions(const scene::OneSurface& one, Side side, Interval range, Clock clock) {
    Motions all;
    const animation::Animation& animation = one.surface.animation;
    animation::Parts parts;
    piece(one, side, mid(range), std::nullopt, &parts);
    std::vector<animation::Knot> knots = animation::knots(animation, parts, range);
    for (const animation::Knot& knot : knots) {
        if (knot.jumps) all.jumps.push_back(knot.time);
    }
    if (!knots.empty() && knots.back().time == range.hi) {
        all.at_end = piece(one, side, range.hi, std::nullopt);
        all.at_end->clock = range.hi;
        drop_idle_parts(*all.at_end);
        knots.pop_back();
    }
    double from = range.lo;
    for (std::size_t k = 0; k <= knots.size(); ++k) {
        const double to = k < knots.size() ? knots[k].time : range.hi;
        Motion motion = piece(one, side, from + (to - from) / 2, std::nullopt);
        motion.clock = {from, to};
        drop_idle_parts(motion);
        find_steps(motion, all.doubts);
        find_collapses(motion, all.collapses);
        all.pieces.push_back(std::move(motion));
        from = to;
    }
    if (clock == Clock::track_if_one && all.jumps.empty()) {
        auto whole = through_one_track(one, parts, side, range);
        const auto driver = whole ? whole->driver : std::nullopt;
        if (whole && driver) {
            whole->clock = MonotoneTrack(one, *driver, range).values();
            // A track with a pole in the range is no clock: there is no end to its values.
            if (std::isfinite(whole->clock.lo) && std::isfinite(whole->clock.hi)) {
                drop_idle_parts(*whole);
                all.pieces.clear();
                all.pieces.push_back(std::move(*whole));
                return all;
            }
        }
        for (Motion& motion : all.pieces) {
            if (auto eased = by_easing(motion, animation, parts)) motion = std::move(*eased);
        }
    }
    return all;
}

} // namespace isomotion::topology
