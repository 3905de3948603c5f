#include "formula/smoothness.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "formula/graph/degree.h"
#include "formula/graph/roughness.h"

namespace isomotion::formula {
namespace {

using Box = std::array<Interval, 3>;

constexpr int most_halvings = 15; // 32 cells along each axis

// Whether a decoration is 0 over all of a box, or over each of its parts.
class Inspection {
public:
    Inspection(const Program& program, double evaluations)
        : program_(program)
        , left_(evaluations) {}

    bool holds(const Region& region) { return holds(region.bindings, region.box, 0); }

private:
    bool holds(const Bindings<Interval>& bindings, const Box& box, int halvings) {
        Interval decoration;
        program_.point(bindings, box, {&decoration, 1});
        if (decoration == Interval{0, 0}) return true;
        if (halvings == most_halvings || (left_ -= 2) < 0) return false;
        std::array parts{box, box};
        const auto axis = std::size_t(halvings % 3);
        const double middle = mid(box[axis]);
        parts[0][axis].hi = parts[1][axis].lo = middle;
        return holds(bindings, parts[0], halvings + 1) && holds(bindings, parts[1], halvings + 1);
    }

    Evaluator<Interval> program_;
    double left_;
};

} // namespace

Smoothness smoothness(const Field& field, std::span<const Region> regions, double operations) {
    Graph g = field.graph;
    g.fold_exactly();
    const Roughness rough = roughness(g, field.root);
    const auto may_hold = [&](NodeId decoration) {
        if (g.is_constant(decoration, 0)) return false;
        const Program program = schedule(g, std::array{decoration});
        std::vector<int> counts;
        for (const auto& array : regions.front().bindings.arrays) counts.push_back(array.count);
        Inspection inspection(program, operations / (cost(program, counts).operations + 1));
        return !std::all_of(regions.begin(), regions.end(),
                            [&](const Region& region) { return inspection.holds(region); });
    };
    Smoothness found;
    found.degree = degree(field.graph, field.root);
    if (found.degree) return found;
    found.kinks = may_hold(rough.kinks);
    found.jumps = may_hold(rough.jumps);
    found.poles = may_hold(rough.poles);
    return found;
}

std::string words(const Smoothness& smoothness) {
    if (smoothness.degree) return fmt::format("polynomial of degree {}", *smoothness.degree);
    std::vector<std::string_view> places;
    if (smoothness.kinks) places.push_back("kinks");
    if (smoothness.jumps) places.push_back("jumps");
    if (smoothness.poles) places.push_back("poles or places without a value");
    return places.empty() ? "smooth" : fmt::format("with {}", fmt::join(places, ", "));
}

} // namespace isomotion::formula
