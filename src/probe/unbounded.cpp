#include "probe/unbounded.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "formula/enclosure.h"
#include "formula/graph/substitute.h"
#include "probe/sample_points.h"
#include "scene/surfaces.h"

namespace isomotion::probe {
namespace {

using scene::BoundsAt, scene::OneSurface, scene::SurfaceAt;

using formula::Interval, formula::Node, formula::NodeId, formula::Op;
using Point = std::array<Interval, 3>;

constexpr int most_points = 8;
constexpr double most_work = 2e7; // operations

bool has_bounds(const Interval& a) { return std::isfinite(a.lo) && std::isfinite(a.hi); }

std::vector<Point> points_of(const BoundsAt& bounds) {
    std::vector<Point> points;
    for (int k = 1; int(points.size()) < most_points; ++k) {
        const glm::dvec3 p = sample_point(bounds, k);
        if (is_in(bounds, p)) points.push_back({p.x, p.y, p.z});
    }
    return points;
}

// A part of F that has no bounds at any point although what it is made of has, for one element of
// an array or for none.
struct Culprit {
    NodeId node = 0;
    std::optional<int> array;
    std::size_t element = 0; // of the array
    int others = 0;          // elements of which the same is true
};

// Evaluates those parts of F that depend on the elements of one array, or on none.
class Parts {
public:
    Parts(const formula::Field& field, std::optional<int> array)
        : graph_(field.graph)
        , array_(array) {
        const std::uint32_t within = array ? 1u << *array : 0;
        place_.assign(field.root + 1, -1);
        std::vector<NodeId> roots;
        for (const NodeId id : formula::nodes_below(graph_, std::array{field.root})) {
            if ((graph_[id].arrays & ~within) != 0) continue;
            place_[id] = int(nodes_.size());
            nodes_.push_back(id);
        }
        // A sum over the one element that is bound is the element's term.
        for (const NodeId id : nodes_)
            roots.push_back(array && graph_[id].arrays != 0 ? graph_.sum(*array, id) : id);
        program_ = formula::schedule(graph_, roots);
    }

    double operations(std::vector<int> counts) const {
        if (array_) counts[std::size_t(*array_)] = 1;
        return formula::cost(program_, counts).operations + 1;
    }

    // Whether each part has no bounds at any of the points, while its own parts have them.
    std::vector<bool> blamed(const formula::Bindings<Interval>& bindings,
                             const std::vector<Point>& points) const {
        formula::Evaluator<Interval> evaluate(program_);
        std::vector<Interval> values(nodes_.size());
        std::vector<bool> all(nodes_.size(), true);
        for (const Point& p : points) {
            evaluate.point(bindings, p, values);
            for (std::size_t k = 0; k < nodes_.size(); ++k)
                all[k] = all[k] && !has_bounds(values[k]) && made_of_bounded(nodes_[k], values);
        }
        return all;
    }
    NodeId node(std::size_t k) const { return nodes_[k]; }

private:
    // Sums are as their terms, which are looked at for each element.
    bool made_of_bounded(NodeId id, const std::vector<Interval>& values) const {
        const Node& node = graph_[id];
        if (formula::is_over_elements(node.op)) return false;
        for (int k = 0; k < node.arity; ++k) {
            const int child = place_[node.children[std::size_t(k)]];
            if (child < 0 || !has_bounds(values[std::size_t(child)])) return false;
        }
        return true;
    }

    formula::Graph graph_;
    std::optional<int> array_;
    std::vector<NodeId> nodes_;
    std::vector<int> place_; // among those, of the field's nodes; -1: not there
    formula::Program program_;
};

std::optional<Culprit> culprit(const formula::Field& field, std::optional<int> array,
                               formula::Bindings<Interval> bindings,
                               const std::vector<Point>& points) {
    const Parts parts(field, array);
    const auto first_blamed = [&](const std::vector<bool>& blamed) -> std::optional<std::size_t> {
        const auto found = std::ranges::find(blamed, true);
        if (found == blamed.end()) return std::nullopt;
        return std::size_t(found - blamed.begin());
    };
    if (!array) {
        const auto k = first_blamed(parts.blamed(bindings, points));
        return k ? std::optional(Culprit{parts.node(*k), {}, 0, 0}) : std::nullopt;
    }
    const formula::ArrayColumns<Interval> all = bindings.arrays[std::size_t(*array)];
    auto& one = bindings.arrays[std::size_t(*array)];
    one.count = 1;
    double work = most_work;
    const double each = double(points.size()) * parts.operations(bindings.counts());
    std::optional<Culprit> found;
    std::size_t blamed_part = 0;
    for (std::size_t i = 0; i < std::size_t(all.count) && (work -= each) > 0; ++i) {
        for (std::size_t f = 0; f < all.fields.size(); ++f) {
            if (!all.fields[f].empty()) one.fields[f] = {all.fields[f][i]};
        }
        const std::vector<bool> blamed = parts.blamed(bindings, points);
        if (found) {
            found->others += blamed[blamed_part];
        } else if (const auto k = first_blamed(blamed)) {
            blamed_part = *k;
            found = Culprit{parts.node(*k), array, i, 0};
        }
    }
    return found;
}

// One that belongs to no element, or else to the first array that has one.
std::optional<Culprit> first_culprit(const formula::Field& field,
                                     const formula::Bindings<Interval>& bindings,
                                     const std::vector<Point>& points) {
    if (auto found = culprit(field, std::nullopt, bindings, points)) return found;
    for (int array = 0; array < int(bindings.arrays.size()); ++array) {
        if (auto found = culprit(field, array, bindings, points)) return found;
    }
    return std::nullopt;
}

// A value that a part of F is made of, as tracks and arrays name it.
struct NamedValue {
    std::string name;
    double value = 0;
};

// What a quotient is divided by, or what another part is made of.
std::vector<NamedValue> values_of(const OneSurface& one, const SurfaceAt& now, const Culprit& of) {
    const formula::Graph& graph = one.surface.field->graph;
    const animation::Animation& animation = one.surface.animation;
    const Node& part = graph[of.node];
    const NodeId from = part.op == Op::divide ? part.children[1] : of.node;
    std::vector<NamedValue> values;
    for (const NodeId id : formula::nodes_below(graph, std::array{from})) {
        const Node& node = graph[id];
        if (node.op == Op::parameter) {
            values.push_back({animation.tracks()[std::size_t(node.index)].name,
                              now.bindings.parameters[std::size_t(node.index)]});
        }
        if (node.op != Op::element || node.index != of.array) continue;
        const auto a = std::size_t(node.index), f = std::size_t(node.second);
        const animation::Array& array = animation.arrays()[a];
        values.push_back({fmt::format("{}.{}[{}]", array.name, array.fields[f].name, of.element),
                          now.bindings.arrays[a].fields[f][of.element]});
    }
    return values;
}

} // namespace

std::optional<std::string> why_unbounded(const OneSurface& one, const SurfaceAt& now) {
    const formula::Field& field = *one.surface.field;
    const auto bindings = formula::convert<Interval>(now.bindings);
    const std::vector<int> counts = now.bindings.counts();
    if (formula::cost(field.value, counts).operations > most_work / most_points)
        return std::nullopt;
    // Parts adds a node for each.
    if (2 * field.graph.size() > formula::limits::graph_nodes) return std::nullopt;
    const formula::EnclosurePrograms& programs = formula::enclosure_programs(field);
    const std::vector<Point> points = points_of(now.bounds);
    formula::Evaluator<Interval> value(programs.value), jumps(programs.jumps);
    const bool is_known = std::ranges::any_of(points, [&](const Point& p) {
        Interval f;
        std::array<Interval, 2> jump;
        value.point(bindings, p, {&f, 1});
        jumps.point(bindings, p, jump);
        return has_bounds(f) && has_bounds(jump[0]);
    });
    if (is_known) return std::nullopt;
    const std::optional<Culprit> found = first_culprit(field, bindings, points);
    if (!found) return std::nullopt;
    const std::vector<NamedValue> values = values_of(one, now, *found);
    if (values.empty()) return std::nullopt;
    std::string told = fmt::format("{} is {:g}", place_of(one, values[0].name), values[0].value);
    for (std::size_t k = 1; k < values.size(); ++k)
        told += fmt::format(", {} {:g}", values[k].name, values[k].value);
    const bool is_of_element = std::ranges::any_of(
        values, [](const NamedValue& value) { return value.name.ends_with(']'); });
    if (is_of_element && found->others > 0)
        told += fmt::format(" (and {} more like it)", found->others);
    const bool is_divisor = field.graph[found->node].op == Op::divide;
    return fmt::format("{} at t = {}: {}F has no value or may jump at every point that was tried, "
                       "so that no zero is found",
                       told, now.values->time, is_divisor ? "a divisor is 0 by it, and " : "");
}

} // namespace isomotion::probe
