#include "formula/smoothness.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "formula/element_kernels.h"
#include "formula/graph/continuity.h"
#include "formula/graph/degree.h"
#include "formula/graph/log_sums.h"
#include "formula/graph/roughness.h"
#include "formula/graph/squares.h"
#include "formula/interval/prune.h"
#include "formula/line_probe.h"

namespace isomotion::formula {
namespace {

using Box = std::array<Interval, 3>;

constexpr double smallest = 0x1.01p-7; // 128 cells along each axis, but for rounding
constexpr int most_elements = 64;      // that are looked at, each alone
constexpr auto each_quadric = std::size_t(ElementKernels::coefficients_each);

bool is_0(const Interval& decoration) { return decoration == Interval{0, 0}; }

// Whether F keeps off 0 wherever a decoration isn't 0, by dividing the box.
class Inspection {
public:
    // `program` has F, or 0 if it doesn't matter where that is, and a decoration.
    Inspection(const Program& program, double evaluations)
        : program_(program)
        , left_(evaluations) {}

    bool holds(const Region& region) {
        return left_ > 0 && prune(region.box, [&](const Box& box) {
                   std::array<Interval, 2> told;
                   program_.point(region.bindings, box, told);
                   --left_;
                   if (is_0(told[1]) || told[0].lo > 0 || told[0].hi < 0) return Judged::settled;
                   const bool is_small = longest_side(box, region.box).part <= smallest;
                   return is_small || --left_ < 0 ? Judged::refused : Judged::open;
               });
    }

private:
    Evaluator<Interval> program_;
    double left_;
};

// The region with one element of its array alone.
Region with_one_element(const Region& region, std::size_t element) {
    Region one{{region.bindings.parameters, {{1, {}}}}, region.box};
    for (const std::vector<Interval>& column : region.bindings.arrays.front().fields) {
        one.bindings.arrays.front().fields.emplace_back();
        if (element < column.size())
            one.bindings.arrays.front().fields.back().push_back(column[element]);
    }
    return one;
}

// What is asked of one field over some regions.
class Examination {
public:
    Examination(const Field& field, std::span<const Region> regions, double operations)
        : field_(field)
        , graph_(field.graph)
        , regions_(regions)
        , operations_(operations) {
        graph_.fold_exactly();
        for (const auto& array : regions.front().bindings.arrays) counts_.push_back(array.count);
    }

    Smoothness result() {
        const Roughness rough = roughness(graph_, field_.root, least_part_of_rays);
        // The operations allowed are shared: the more places there are, the fewer each may take.
        const std::size_t count = rough.kinks.size() + rough.jumps.size() + rough.poles.size();
        operations_ *= 4 / (3 + double(count));
        const auto any = [&](const std::vector<NodeId>& places, auto&& matters) {
            return std::ranges::any_of(places, matters);
        };
        Smoothness found;
        // Shaders that find elements by place know no key beyond some size: F is flat there, even
        // where equal keys leave it smooth.
        found.kinks = asks_for_least() ||
                      any(rough.kinks, [&](NodeId place) { return matters(place, Met::change); });
        found.jumps = any(rough.jumps, [&](NodeId place) { return may_be_there(place); });
        found.poles =
            any(rough.poles, [&](NodeId place) { return matters(place, Met::even_slopes); });
        return found;
    }

private:
    double evaluations(const Program& program) const {
        return operations_ / (cost(program, counts_).operations + 1);
    }

    bool asks_for_least() const {
        for (std::size_t id = 0; id < field_.graph.size(); ++id) {
            const Node& node = field_.graph[NodeId(id)];
            if (node.op == Op::least && counts_[std::size_t(node.index)] > 1) return true;
        }
        return false;
    }

    bool may_be_there(NodeId decoration) { return may_be_near_0(decoration, graph_.constant(0)); }

    // Whether no element of the one array shows the decoration anywhere. Lines through all elements
    // take longer than boxes through each.
    bool is_at_no_element(NodeId decoration) {
        const auto has_many = [](const Region& region) {
            return region.bindings.arrays.front().count > 1;
        };
        if (counts_.size() != 1 || std::ranges::none_of(regions_, has_many)) return false;
        const Program program = schedule(graph_, std::array{graph_.constant(0), decoration});
        const auto loops = std::ranges::count(program.instructions, Instruction::Kind::loop_begin,
                                              &Instruction::kind);
        if (graph_[decoration].op != Op::sum || loops != 1) return false;
        const std::vector<int> one{1};
        Inspection inspection(program, operations_ / (cost(program, one).operations + 1));
        for (const Region& region : regions_) {
            const int count = region.bindings.arrays.front().count;
            for (int k = 0; k < count; ++k)
                if (!inspection.holds(with_one_element(region, std::size_t(k)))) return false;
        }
        return true;
    }

    // Making programs for one place of many takes as long as running them.
    bool may_look() {
        made_ += double(graph_.size() + field_.directional.instructions.size());
        return made_ <= 1e7;
    }

    // F, and the entire line where it has no value.
    NodeId value_with_gaps() {
        if (!value_) value_ = with_gaps(graph_, field_.root);
        return *value_;
    }

    bool may_be_near_0(NodeId decoration, NodeId value) {
        if (!may_look()) return true;
        if (is_at_no_element(decoration)) return false;
        const Program program = schedule(graph_, std::array{value, decoration});
        Inspection inspection(program, evaluations(program));
        return !std::all_of(regions_.begin(), regions_.end(),
                            [&](const Region& region) { return inspection.holds(region); });
    }

    // Whether a decoration is of the terms of the one array.
    bool is_of_elements(const Program& decoration) const {
        return counts_.size() == 1 &&
               std::ranges::any_of(decoration.instructions, [](const Instruction& now) {
                   return now.kind == Instruction::Kind::loop_begin;
               });
    }

    // Cubics step over no round element where F is flat beside it, since the elements' radii bound
    // their steps (render/element_radius.h). Discs may be thinner than these tell.
    const ElementKernels* round_kernels() {
        if (!asked_for_kernels_) round_kernels_ = find_round_kernels();
        asked_for_kernels_ = true;
        return round_kernels_ ? &*round_kernels_ : nullptr;
    }

    std::optional<ElementKernels> find_round_kernels() const {
        auto kernels = element_kernels(field_, 0);
        if (!kernels || kernels->quadrics == 0 || kernels->is_least) return std::nullopt;
        const int count = counts_.front(), some = std::min(count, most_elements);
        for (const Region& region : regions_) {
            const auto& columns = region.bindings.arrays[0].fields;
            for (const int field : kernels->fields)
                if (columns[std::size_t(field)].size() < std::size_t(count)) return std::nullopt;
            for (int k = 0; k < some; ++k) {
                const auto all = quadrics(*kernels, region, int(std::int64_t(k) * count / some));
                for (std::size_t q = 0; q < all.size(); q += each_quadric) {
                    if (!is_round(std::span(all).subspan(q + 4, 6))) return std::nullopt;
                }
            }
        }
        return kernels;
    }

    // An element's quadrics, where parameters are in the middle of what they may be.
    static std::vector<double> quadrics(const ElementKernels& kernels, const Region& region,
                                        int element) {
        Bindings<double> values;
        for (const Interval& value : region.bindings.parameters)
            values.parameters.push_back(mid(value));
        std::vector<double> inputs(std::max<std::size_t>(1, kernels.fields.size()));
        const auto& columns = region.bindings.arrays[0].fields;
        for (std::size_t f = 0; f < kernels.fields.size(); ++f)
            inputs[f] = mid(columns[std::size_t(kernels.fields[f])][std::size_t(element)]);
        std::vector<double> found(std::size_t(kernels.quadrics) * each_quadric);
        Evaluator<double>(kernels.coefficients).point(values, inputs, found);
        return found;
    }

    // Whether a place on an element is nearer to its centre than a 64th of the bounds' radius,
    // which is the least radius that bounds steps.
    static bool is_tiny(const ElementKernels& kernels, const Region& region, int element,
                        const std::array<double, 3>& p) {
        double bounds = 0; // squared
        for (const Interval& side : region.box)
            bounds += 0.25 * (side.hi - side.lo) * (side.hi - side.lo);
        const std::vector<double> all = quadrics(kernels, region, element);
        for (std::size_t q = 0; q < all.size(); q += each_quadric) {
            const double* g = &all[q + 1];
            const double* h = &all[q + 4];
            const double x = g[0] + h[0] * p[0] + h[1] * p[1] + h[2] * p[2];
            const double y = g[1] + h[1] * p[0] + h[3] * p[1] + h[4] * p[2];
            const double z = g[2] + h[2] * p[0] + h[4] * p[1] + h[5] * p[2];
            const double size = (h[0] + h[3] + h[5]) / 3;
            if (x * x + y * y + z * z < 0x1p-12 * bounds * size * size) return true;
        }
        return false;
    }

    // Whether no axis of an ellipsoid is more than some 3.5 times as long as another, by the
    // Hessian (xx xy xz yy yz zz) of its quadric: what is left is definite without a 16th of its
    // trace.
    static bool is_round(std::span<const double> hessian) {
        const double trace = hessian[0] + hessian[3] + hessian[5];
        const double sign = trace < 0 ? -1 : 1, part = trace / 16;
        const double xx = sign * (hessian[0] - part), yy = sign * (hessian[3] - part),
                     zz = sign * (hessian[5] - part);
        const double xy = sign * hessian[1], xz = sign * hessian[2], yz = sign * hessian[4];
        const double minor = xx * yy - xy * xy;
        const double determinant = zz * minor - xx * yz * yz - yy * xz * xz + 2 * xy * xz * yz;
        return xx > 0 && minor > 0 && determinant > 0;
    }

    // Looks at an even selection of elements, one by one. `round`: their kernels if they are round.
    Met at_elements(LineProbe& probe, const ElementKernels* round) const {
        Met all = Met::nothing;
        const int count = counts_.front(), some = std::min(count, most_elements);
        for (int k = 0; k < some && all != Met::change; ++k) {
            const Region& region = regions_[std::size_t(k) % regions_.size()];
            const auto element = int(std::int64_t(k) * count / some);
            for (int line = 0; line < 2 && all != Met::change; ++line) {
                const Met met = probe.at_element(region, element);
                const bool is_lost = round && met == Met::even_slopes &&
                                     is_tiny(*round, region, element, probe.place());
                all = std::max(all, is_lost ? Met::change : met);
            }
        }
        return all;
    }

    // Cubics may go wrong at any place that a ray can meet, also off the surface: where min(a, b)
    // turns from a to b, b may be on its way to 0. Places that few rays meet, as
    // sqrt(x^2 + y^2) = 0, matter where F may be 0.
    bool matters(NodeId decoration, Met least) {
        if (!may_look()) return true;
        if (is_at_no_element(decoration)) return false;
        const Program program = schedule(graph_, std::array{decoration});
        const bool of_elements = is_of_elements(program);
        const ElementKernels* round = of_elements ? round_kernels() : nullptr;
        LineProbe probe(program, field_.directional, round != nullptr);
        // A line takes some 500 evaluations of the decoration, and at most 48 slopes.
        const double line = 500 * (cost(program, counts_).operations + 1) +
                            48 * cost(field_.directional, counts_).operations;
        const double most = operations_ / (line * double(regions_.size()));
        const int lines = int(std::clamp(most, 0.0, regions_.size() > 1 ? 8.0 : 32.0));
        Met all = Met::nothing;
        for (const Region& region : regions_) {
            all = std::max(all, probe.along_lines(region, lines));
            if (all >= least) return true;
        }
        // A field may make one element unlike the others. Few lines meet each of many.
        if (of_elements) all = std::max(all, at_elements(probe, round));
        if (all >= least) return true;
        return all == Met::nothing && may_be_near_0(decoration, value_with_gaps());
    }

    const Field& field_;
    Graph graph_;
    std::span<const Region> regions_;
    double operations_;
    double made_ = 0; // nodes and instructions of programs
    std::optional<NodeId> value_;
    std::vector<int> counts_;
    bool asked_for_kernels_ = false;
    std::optional<ElementKernels> round_kernels_;
};

} // namespace

Smoothness smoothness(const Field& field, std::span<const Region> regions, double operations) {
    const bool false_touches =
        has_squares(field.graph, field.root) || has_fading_logs(field.graph, field.root);
    if (const auto polynomial = degree(field.graph, field.root))
        return {.degree = polynomial, .false_touches = false_touches};
    Smoothness found = Examination(field, regions, operations).result();
    found.false_touches = false_touches;
    return found;
}

std::string words(const Smoothness& smoothness) {
    if (smoothness.degree) return fmt::format("polynomial of degree {}", *smoothness.degree);
    std::vector<std::string_view> places;
    if (smoothness.kinks) places.emplace_back("kinks");
    if (smoothness.jumps) places.emplace_back("jumps");
    if (smoothness.poles) places.emplace_back("poles or places without a value");
    return places.empty() ? "smooth" : fmt::format("with {}", fmt::join(places, ", "));
}

} // namespace isomotion::formula
