#include "animation/rules.h"

#include <algorithm>
#include <cmath>

#include "formula/graph/parser.h"
#include "formula/graph/substitute.h"
#include "formula/interval/double_double.h"

namespace isomotion::animation {
namespace {

using formula::NodeId;
using formula::Op;

std::map<double, bool> knots_of(const Keys& keys) {
    std::map<double, bool> knots;
    for (std::size_t k = 0; k < keys.keys.size(); ++k) {
        const bool differs = k > 0 && keys.keys[k].value != keys.keys[k - 1].value;
        knots[keys.keys[k].time] = keys.ease == Ease::hold && differs;
    }
    return knots;
}

NodeId part_of_time(formula::Graph& g, NodeId time, double from, double to) {
    const NodeId length = g.subtract(g.constant(to), g.constant(from));
    return g.divide(g.subtract(time, g.constant(from)), length);
}

// from + part (to - from), which is exactly `to` where the part is 1: a difference that is rounded
// would leave a gap between this rule and the next, and a value in the gap would be reached by
// neither. So the difference is taken in two parts, of which the second is mostly 0.
NodeId between(formula::Graph& g, double from, double to, NodeId part) {
    const formula::DoubleDouble<double> way = formula::exact_sum(to, -from);
    NodeId moved = g.multiply(g.constant(way.hi), part);
    if (way.lo != 0 && std::isfinite(way.lo))
        moved = g.add(moved, g.multiply(g.constant(way.lo), part));
    return g.add(g.constant(from), moved);
}

NodeId smooth_step(formula::Graph& g, NodeId u) {
    return g.multiply(g.multiply(u, u), g.subtract(g.constant(3), g.multiply(g.constant(2), u)));
}

// Hermite's basis: velocities at the ends, per span, on top of what rests there.
NodeId hermite(formula::Graph& g, NodeId u, NodeId rest_to_rest, NodeId start, NodeId stop) {
    const NodeId v = g.subtract(g.constant(1), u);
    const NodeId bend = g.subtract(g.multiply(start, v), g.multiply(stop, u));
    return g.add(rest_to_rest, g.multiply(g.multiply(u, v), bend));
}

} // namespace

std::vector<Knot> knots(const Animation& animation, const Parts& parts, formula::Interval range) {
    std::map<double, bool> all;
    const auto add = [&](double time, bool jumps) {
        const bool is_inside = range.lo < time && time < range.hi;
        if (is_inside || (jumps && time == range.hi && range.lo < range.hi)) all[time] |= jumps;
    };
    const auto is_near = [&](double time) { return range.lo < time && time <= range.hi; };
    for (const int track : parts.tracks) {
        const auto* keys = std::get_if<Keys>(&animation.tracks()[std::size_t(track)].source);
        if (!keys) continue;
        for (const auto& [time, jumps] : knots_of(*keys)) add(time, jumps);
    }
    for (const int array : parts.arrays) {
        const auto& samples = animation.arrays()[std::size_t(array)].samples;
        if (!samples) continue;
        const std::vector<double>& times = samples->times();
        const bool reads_rows = parts.rows.contains(array);
        for (std::size_t k = 0; k < times.size(); ++k) {
            if (!is_near(times[k])) continue; // a sample may be a file to read
            add(times[k], samples->jumps(k) || (reads_rows && samples->reorders(k)));
        }
    }
    for (const int array : parts.counts) {
        const auto& samples = animation.arrays()[std::size_t(array)].samples;
        if (!samples) continue;
        const std::vector<double>& times = samples->times();
        for (std::size_t k = 0; k < times.size(); ++k) {
            if (is_near(times[k]) && samples->recounts(k)) add(times[k], true);
        }
    }
    std::vector<Knot> knots;
    knots.reserve(all.size());
    for (const auto& [time, jumps] : all) knots.push_back({time, jumps});
    return knots;
}

NodeId smooth_way(formula::Graph& g, NodeId time, double from, double to) {
    return smooth_step(g, part_of_time(g, time, from, to));
}

Rules::Rules(const Animation& animation, double within, formula::Graph& graph, NodeId time,
             std::optional<Driver> driver)
    : animation_(animation)
    , within_(within)
    , graph_(graph)
    , time_(time)
    , driver_(driver) {}

int Rules::index_field(int array) const {
    return int(animation_.arrays()[std::size_t(array)].fields.size());
}

NodeId Rules::track(int k) {
    used_.tracks.insert(k);
    if (driver_ && driver_->track == k) return driver_->node;
    if (const auto known = tracks_.find(k); known != tracks_.end()) return known->second;
    const TrackSource& source = animation_.tracks()[std::size_t(k)].source;
    NodeId node{};
    if (const auto* number = std::get_if<double>(&source)) {
        node = graph_.constant(*number);
    } else if (const auto* keys = std::get_if<Keys>(&source)) {
        node = rule(*keys);
    } else {
        node = expression(std::get<Expression>(source).text, -1);
    }
    return tracks_[k] = node;
}

NodeId Rules::field(int a, int f) {
    used_.arrays.insert(a);
    const Array& array = animation_.arrays()[std::size_t(a)];
    const FieldSource& source = array.fields[std::size_t(f)].source;
    if (const auto* number = std::get_if<double>(&source)) return graph_.constant(*number);
    if (const auto* written = std::get_if<Expression>(&source)) return expression(written->text, a);
    const NodeId listed = graph_.element(a, f);
    if (std::holds_alternative<std::vector<double>>(source)) {
        used_.rows.insert(a);
        return listed;
    }
    const auto [begin_time, end_time] = array.samples->ends(within_);
    if (!(begin_time < end_time)) return listed;
    const NodeId begin = graph_.constant(begin_time), end = graph_.constant(end_time);
    const NodeId weight = graph_.divide(graph_.subtract(time_, begin), graph_.subtract(end, begin));
    const int fields = index_field(a);
    const NodeId stop = graph_.element(a, fields + 1 + f);
    // A difference of elements is enclosed wherever it is evaluated, and rounded nowhere.
    const NodeId way = graph_.subtract(stop, listed);
    if (!array.samples->is_curved(std::get<Column>(source).index))
        return graph_.add(listed, graph_.multiply(weight, way));
    return hermite(graph_, weight,
                   graph_.add(listed, graph_.multiply(smooth_step(graph_, weight), way)),
                   graph_.element(a, 2 * fields + 1 + f), graph_.element(a, 3 * fields + 1 + f));
}

NodeId Rules::in_place(const formula::Node& node, NodeId rebuilt) {
    if (node.op == Op::parameter) return track(node.index);
    if (node.op == Op::element) return field(node.index, node.second);
    if (formula::is_over_elements(node.op)) used_.counts.insert(node.index);
    return rebuilt;
}

NodeId Rules::expression(const std::string& text, int array) {
    formula::Vocabulary vocabulary;
    vocabulary.inputs = {"t"};
    if (array >= 0) vocabulary.inputs = {"t", "i", "n"};
    const std::size_t tracks = animation_.nameable();
    for (std::size_t k = 0; k < tracks; ++k) {
        vocabulary.parameters.push_back(animation_.tracks()[k].name);
    }
    if (array >= 0) {
        for (const ArrayField& field : animation_.arrays()[std::size_t(array)].fields) {
            vocabulary.parameters.push_back(field.name);
        }
    }
    vocabulary.allows_random = true;
    formula::Graph parsed;
    const NodeId root = formula::parse(text, vocabulary, parsed);
    const auto its_place = [&](formula::Graph& to, const formula::Node& node, NodeId rebuilt) {
        if (node.op == Op::input && node.index == 0) return time_;
        if (node.op == Op::input && node.index == 1) {
            used_.rows.insert(array);
            return to.element(array, index_field(array));
        }
        if (node.op == Op::input) {
            const Array& of = animation_.arrays()[std::size_t(array)];
            return to.constant(of.samples ? of.samples->count(within_) : of.count);
        }
        if (node.op != Op::parameter) return rebuilt;
        return std::size_t(node.index) < tracks ? track(node.index)
                                                : field(array, node.index - int(tracks));
    };
    return formula::substitute(graph_, parsed, std::array{root}, its_place)[0];
}

NodeId Rules::rule(const Keys& keys) {
    formula::Graph& g = graph_;
    const std::vector<Key>& all = keys.keys;
    if (within_ <= all.front().time) return g.constant(all.front().value);
    if (within_ >= all.back().time) return g.constant(all.back().value);
    const auto after = std::upper_bound(all.begin(), all.end(), within_,
                                        [](double t, const Key& key) { return t < key.time; });
    const auto k = std::size_t(after - all.begin()) - 1;
    const Key &a = all[k], &b = all[k + 1];
    if (keys.ease == Ease::hold) return g.constant(a.value);
    const NodeId length = g.subtract(g.constant(b.time), g.constant(a.time));
    const NodeId u = part_of_time(g, time_, a.time, b.time);
    const auto at_part = [&](NodeId part) { return between(g, a.value, b.value, part); };
    if (keys.ease == Ease::linear) return at_part(u);
    const NodeId rest_to_rest = at_part(smooth_way(g, time_, a.time, b.time));
    if (keys.ease == Ease::smooth) return rest_to_rest;
    return hermite(g, u, rest_to_rest, g.multiply(g.constant(keys.velocity(k)), length),
                   g.multiply(g.constant(keys.velocity(k + 1)), length));
}

std::vector<formula::ArrayColumns<double>> Rules::columns() const {
    std::vector<formula::ArrayColumns<double>> all;
    for (const Array& array : animation_.arrays()) {
        formula::ArrayColumns<double>& columns = all.emplace_back();
        columns.count = array.count;
        ElementSamples::Span span;
        if (array.samples) {
            span = array.samples->span(within_);
            columns.count = span.begin.count;
        }
        const auto count = std::size_t(columns.count);
        const std::size_t fields = array.fields.size();
        columns.fields.resize((span.begin_velocity.empty() ? 2 : 4) * fields + 1);
        for (std::size_t i = 0; i < count; ++i) columns.fields[fields].push_back(double(i));
        for (std::size_t f = 0; f < fields; ++f) {
            const FieldSource& source = array.fields[f].source;
            if (const auto* list = std::get_if<std::vector<double>>(&source)) {
                columns.fields[f] = *list;
                columns.fields[f].resize(count);
            } else if (const auto* data = std::get_if<Column>(&source)) {
                columns.fields[f] = span.begin.fields[data->index];
                columns.fields[fields + 1 + f] = span.end[data->index];
                columns.fields[2 * fields + 1 + f] = span.begin_velocity[data->index];
                columns.fields[3 * fields + 1 + f] = span.end_velocity[data->index];
            }
        }
    }
    return all;
}

} // namespace isomotion::animation
