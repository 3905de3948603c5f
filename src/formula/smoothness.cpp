#include "formula/smoothness.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "formula/graph/continuity.h"
#include "formula/graph/degree.h"
#include "formula/graph/roughness.h"
#include "formula/graph/squares.h"

namespace isomotion::formula {
namespace {

using Box = std::array<Interval, 3>;

constexpr int most_halvings = 21; // 128 cells along each axis

bool is_0(const Interval& decoration) { return decoration == Interval{0, 0}; }

// Whether F keeps off 0 wherever a decoration isn't 0, by dividing the box.
class Inspection {
public:
    // `program` has F, or 0 if it doesn't matter where that is, and a decoration.
    Inspection(const Program& program, double evaluations)
        : program_(program)
        , left_(evaluations) {}

    bool holds(const Region& region) { return holds(region.bindings, region.box, 0); }

private:
    bool holds(const Bindings<Interval>& bindings, const Box& box, int halvings) {
        std::array<Interval, 2> told;
        program_.point(bindings, box, told);
        if (is_0(told[1]) || told[0].lo > 0 || told[0].hi < 0) return true;
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

enum class Met {
    nothing,
    even_slopes, // slopes go on across what was met: as of cos(acos(min(abs(x), 1)))
    change       // of slopes
};

// What slopes do at the places of a decoration, along random lines.
class LineProbe {
public:
    static constexpr int asks_of_a_line = 500, slopes_of_a_line = 32;

    LineProbe(const Program& decoration, const Program& directional)
        : decoration_(decoration)
        , directional_(directional) {}

    // Goes on up to `most` lines where nothing was met along so many.
    Met along_lines(const Region& region, int lines, int most) {
        bindings_ = region.bindings;
        numbers_.parameters.clear();
        for (Interval& value : bindings_.parameters) {
            value = mid(value);
            numbers_.parameters.push_back(value.lo);
        }
        numbers_.arrays.clear();
        for (auto& array : bindings_.arrays) {
            numbers_.arrays.push_back({array.count, {}});
            for (auto& field : array.fields) {
                auto& column = numbers_.arrays.back().fields.emplace_back();
                for (Interval& value : field) {
                    value = mid(value);
                    column.push_back(value.lo);
                }
            }
        }
        Met all = Met::nothing;
        for (int k = 0; k < (all == Met::nothing ? most : lines) && all != Met::change; ++k) {
            draw_line(region.box);
            if (!may_be_in(0, 1)) continue;
            usual_slope_ = 0;
            for (int part = 0; part < 16; ++part)
                usual_slope_ += std::abs(slope((part + 0.5) / 16)) / 16;
            // Dead ends, which wide bounds lead to, are left early: others are tried instead.
            asks_left_ = asks_of_a_line;
            for (int met = 0; met < 8 && asks_left_ > 0 && all != Met::change;) {
                const Met found = descend();
                met += found != Met::nothing;
                all = std::max(all, found);
            }
        }
        return all;
    }

private:
    double in(const Interval& side) {
        return side.lo + (side.hi - side.lo) * double(random_() >> 11) * 0x1p-53;
    }

    // Draws a line at random, from side to side of the box.
    void draw_line(const Box& box) {
        double begin = -HUGE_VAL, end = HUGE_VAL;
        for (std::size_t k = 0; k < 3; ++k) {
            from_[k] = in(box[k]);
            along_[k] = in(box[k]) - from_[k];
            const double a = (box[k].lo - from_[k]) / along_[k];
            const double b = (box[k].hi - from_[k]) / along_[k];
            begin = std::max(begin, std::min(a, b));
            end = std::min(end, std::max(a, b));
        }
        for (std::size_t k = 0; k < 3; ++k) {
            from_[k] += begin * along_[k];
            along_[k] *= end - begin;
        }
    }

    // dF over the line, at a part of it.
    double slope(double t) {
        std::array<double, 6> inputs{};
        for (std::size_t k = 0; k < 3; ++k) {
            inputs[k] = from_[k] + t * along_[k];
            inputs[3 + k] = along_[k];
        }
        std::array<double, 2> f{};
        directional_.point(numbers_, inputs, f);
        return f[1];
    }

    bool may_be_in(double a, double b) {
        --asks_left_;
        Box box;
        for (std::size_t k = 0; k < 3; ++k)
            box[k] = Interval(from_[k]) + Interval(a, b) * Interval(along_[k]);
        Interval decoration;
        decoration_.point(bindings_, box, {&decoration, 1});
        return !is_0(decoration);
    }

    // What the slopes do at one of the places that the line may meet, chosen at random.
    Met descend() {
        double a = 0, b = 1;
        while (b - a > place) {
            const double middle = 0.5 * (a + b);
            const bool to_the_left = random_() >> 63;
            const bool is_there = may_be_in(to_the_left ? a : middle, to_the_left ? middle : b);
            if (!is_there && !may_be_in(to_the_left ? middle : a, to_the_left ? b : middle))
                return Met::nothing;
            (to_the_left == is_there ? b : a) = middle;
        }
        const double before = slope(a - beside), after = slope(b + beside);
        const double usual = std::max({usual_slope_, std::abs(before), std::abs(after)});
        const double change = std::abs(after - before);
        if (change <= 1e-3 * usual) return Met::even_slopes;
        // F may be flat on one side, along the entire line. A bend that begins there changes slopes
        // in proportion to the distance.
        const double wider = std::abs(slope(b + 16 * beside) - slope(a - 16 * beside));
        return wider >= 8 * change ? Met::even_slopes : Met::change;
    }

    // Parts of a line: how closely a place is found, and from how far its slopes are taken.
    static constexpr double place = 1e-10, beside = 1e-8;

    Evaluator<Interval> decoration_;
    Evaluator<double> directional_;
    Bindings<Interval> bindings_;
    Bindings<double> numbers_;
    std::array<double, 3> from_{}, along_{};
    double usual_slope_ = 0;
    std::mt19937_64 random_;
    int asks_left_ = 0; // of the decoration
};

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
        const Roughness rough = roughness(graph_, field_.root);
        // The operations allowed are shared: the more places there are, the fewer each may take.
        const std::size_t count = rough.kinks.size() + rough.jumps.size() + rough.poles.size();
        operations_ *= 4 / (3 + double(count));
        const auto any = [&](const std::vector<NodeId>& places, auto&& matters) {
            return std::ranges::any_of(places, matters);
        };
        Smoothness found;
        found.kinks = any(rough.kinks, [&](NodeId place) { return matters(place, Met::change); });
        found.jumps = any(rough.jumps, [&](NodeId place) { return may_be_there(place); });
        found.poles =
            any(rough.poles, [&](NodeId place) { return matters(place, Met::even_slopes); });
        return found;
    }

private:
    double evaluations(const Program& program) const {
        return operations_ / (cost(program, counts_).operations + 1);
    }

    bool may_be_there(NodeId decoration) { return may_be_near_0(decoration, graph_.constant(0)); }

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
        const Program program = schedule(graph_, std::array{value, decoration});
        Inspection inspection(program, evaluations(program));
        return !std::all_of(regions_.begin(), regions_.end(),
                            [&](const Region& region) { return inspection.holds(region); });
    }

    // Cubics may go wrong at any place that a ray can meet, also off the surface: where min(a, b)
    // turns from a to b, b may be on its way to 0. Places that few rays meet, as
    // sqrt(x^2 + y^2) = 0, matter where F may be 0.
    bool matters(NodeId decoration, Met least) {
        if (!may_look()) return true;
        const Program program = schedule(graph_, std::array{decoration});
        LineProbe probe(program, field_.directional);
        const double line =
            LineProbe::asks_of_a_line * (cost(program, counts_).operations + 1) +
            LineProbe::slopes_of_a_line * cost(field_.directional, counts_).operations;
        const int most =
            int(std::clamp(operations_ / (line * double(regions_.size())), 0.0, 1000.0));
        const int lines = std::min(most, regions_.size() > 1 ? 8 : 32);
        Met all = Met::nothing;
        for (const Region& region : regions_) {
            all = std::max(all, probe.along_lines(region, lines, most));
            if (all >= least) return true;
        }
        return all == Met::nothing && may_be_near_0(decoration, value_with_gaps());
    }

    const Field& field_;
    Graph graph_;
    std::span<const Region> regions_;
    double operations_;
    double made_ = 0; // nodes and instructions of programs
    std::optional<NodeId> value_;
    std::vector<int> counts_;
};

} // namespace

Smoothness smoothness(const Field& field, std::span<const Region> regions, double operations) {
    const bool squares = has_squares(field.graph, field.root);
    if (const auto polynomial = degree(field.graph, field.root))
        return {.degree = polynomial, .squares = squares};
    Smoothness found = Examination(field, regions, operations).result();
    found.squares = squares;
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
