#include "topology/search/separable_search.h"

#include <algorithm>

#include "formula/graph/substitute.h"
#include "topology/field/separable.h"

namespace isomotion::topology {
namespace {

using formula::Interval;
using formula::Node;
using formula::NodeId;
using formula::Op;

// A point along one axis at which its term has slope 0.
struct Turn {
    Root at;
    Interval value; // of the term
};

// Roots at the end of a span are found as well as those inside.
Interval with_margin(Interval span) {
    const double more = 1e-9 * (span.hi - span.lo);
    return {span.lo - more, span.hi + more};
}

class Combinations {
public:
    Combinations(const MovingField& field, std::vector<std::vector<Turn>> turns, Term& by_clock,
                 const SearchOptions& searching)
        : field_(field)
        , turns_(std::move(turns))
        , by_clock_(by_clock)
        , searching_(searching)
        , clocks_(with_margin(field.domain()[field.clock()]))
        , all_clocks_(by_clock.over(clocks_).value)
        , enclosures_(field) {}

    std::optional<SearchResult> find() && {
        if (!combine(0, Interval(0))) return std::nullopt;
        add_jets();
        put_in_order(found_.points);
        return std::move(found_);
    }

private:
    // Turns along the axes from this one on, with the sum of the values along those before it.
    bool combine(std::size_t axis, Interval sum) {
        if (axis == turns_.size()) return is_stopped() || add(sum);
        for (std::size_t k = 0; k < turns_[axis].size(); ++k) {
            const Turn& turn = turns_[axis][k];
            if (axis == 0 && searching_.progress)
                searching_.progress(double(k) / double(turns_[axis].size()));
            now_.where[axis] = turn.at.where;
            now_.alone[axis] = turn.at.alone;
            if (!combine(axis + 1, sum + turn.value)) return false;
        }
        return true;
    }

    bool add(Interval sum) {
        ++found_.work.boxes;
        if (!contains(all_clocks_ + sum, 0.0)) return true;
        const auto times = zeros(by_clock_, sum, clocks_);
        if (!times) return false;
        for (const Root& time : *times) {
            now_.where[field_.clock()] = time.where;
            now_.alone[field_.clock()] = time.alone;
            found_.points.push_back(now_);
        }
        return true;
    }

    void add_jets() {
        constexpr std::size_t together = 64;
        std::vector<Box> boxes;
        std::vector<Jet<Interval>> jets;
        for (std::size_t first = 0; first < found_.points.size() && !is_stopped();
             first += together) {
            const auto some = std::span(found_.points)
                                  .subspan(first)
                                  .first(std::min(together, found_.points.size() - first));
            boxes.clear();
            for (const CriticalPoint& point : some) boxes.push_back(point.where);
            enclosures_.jets(enclosures_.all(), boxes, jets);
            for (std::size_t k = 0; k < some.size(); ++k) some[k].jet = jets[k];
        }
    }

    bool is_stopped() const { return searching_.stopped && searching_.stopped(); }

    const MovingField& field_;
    std::vector<std::vector<Turn>> turns_; // along each free axis
    Term& by_clock_;
    const SearchOptions& searching_;
    Interval clocks_, all_clocks_;
    Enclosures enclosures_;
    CriticalPoint now_{};
    SearchResult found_;
};

} // namespace

std::optional<SeparableResult> search_separable(const Motion& motion, const Stratum& stratum,
                                                const SearchOptions& searching) {
    formula::Graph graph = motion.graph;
    const auto terms = separated(graph, motion.field, clock_input + 1);
    if (!terms) return std::nullopt;
    const auto bindings = formula::convert<Interval>(motion.bindings);
    SeparableResult result{MovingField(motion, stratum), {}};
    const MovingField& field = result.field;

    std::vector<std::vector<Turn>> turns;
    NodeId by_clock = (*terms)[clock_input];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const NodeId of_axis = (*terms)[axis];
        if (stratum.axes[axis] != Stratum::End::free) {
            const NodeId wall =
                (stratum.axes[axis] == Stratum::End::low ? motion.low : motion.high)[axis];
            const NodeId at_wall = formula::substitute(
                graph, graph, std::array{of_axis}, [&](auto&, const Node& node, NodeId rebuilt) {
                    return node.op == Op::input ? wall : rebuilt;
                })[0];
            by_clock = graph.add(by_clock, at_wall);
            continue;
        }
        Term term(graph, of_axis, axis, bindings);
        const auto at = stationary_points(term, with_margin(field.domain()[turns.size()]));
        if (!at) return std::nullopt;
        std::vector<Turn>& found = turns.emplace_back();
        for (const Root& root : *at) found.push_back({root, term.over(root.where).value});
    }
    Term of_clock(graph, by_clock, clock_input, bindings);
    auto found = Combinations(field, std::move(turns), of_clock, searching).find();
    if (!found) return std::nullopt;
    result.found = std::move(*found);
    return result;
}

} // namespace isomotion::topology
