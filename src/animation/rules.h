// All motion as expressions of time, from which other expressions can be built: to differentiate by
// time, and to enclose values over a span of time.
//
// Animation::at() gives values at one time; the rules here are the same functions of real numbers,
// without the rounding of at(). Between two successive knots each track and field has one rule.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "animation/animation.h"
#include "formula/graph/graph.h"
#include "formula/interval/interval.h"

namespace isomotion::animation {

struct Knot {
    double time = 0;
    bool jumps = false; // values before and after differ
};

// Indices of tracks and of arrays, by which part of them is read.
struct Parts {
    std::set<int> tracks, arrays; // arrays: the values of fields
    std::set<int> counts{};       // the number of elements, which every sum reads
    std::set<int> rows{}; // the row of an element, which its index and lists of numbers depend on
};

// The times inside `range` at which a rule of these parts changes, ascending: times of keys and of
// samples, and the range's end if values jump there, since values at a jump's own time are those
// after it.
std::vector<Knot> knots(const Animation& animation, const Parts& parts, formula::Interval range);

// A track whose value another node gives. Values that depend on time by this track alone then
// depend on that node alone.
struct Driver {
    int track = 0;
    formula::NodeId node = 0;
};

// The part of the way that keys that rest at `from` and `to` have made: smoothstep of the time.
formula::NodeId smooth_way(formula::Graph& graph, formula::NodeId time, double from, double to);

class Rules {
public:
    // Rules that hold around the time `within`, which lies between two knots; if it is at a knot,
    // those after it. Makes nodes in `graph`, where `time` represents the time.
    Rules(const Animation& animation, double within, formula::Graph& graph, formula::NodeId time,
          std::optional<Driver> driver = {});

    formula::NodeId track(int track);
    // For use inside a sum over the array.
    formula::NodeId field(int array, int field);
    // The replacement of a node in an expression of tracks and arrays (formula::Replacement).
    formula::NodeId in_place(const formula::Node& node, formula::NodeId rebuilt);
    // The columns that elements in the graph refer to: an array's own fields, then the index of
    // each element, its values at the span's end and both velocities (ElementSamples::Span).
    std::vector<formula::ArrayColumns<double>> columns() const;
    // The parts that the nodes made or replaced so far depend on.
    const Parts& used() const { return used_; }

private:
    formula::NodeId expression(const std::string& text, int array);
    formula::NodeId rule(const Keys& keys);
    int index_field(int array) const;

    const Animation& animation_;
    double within_;
    formula::Graph& graph_;
    formula::NodeId time_;
    std::optional<Driver> driver_;
    std::map<int, formula::NodeId> tracks_;
    Parts used_;
};

} // namespace isomotion::animation
