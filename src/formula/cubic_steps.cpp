#include "formula/cubic_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "formula/enclosure.h"

namespace isomotion::formula {
namespace {

constexpr std::size_t most_lines = 64;  // of all regions
constexpr std::size_t most_regions = 4; // that are looked at
constexpr std::size_t most_bumps = 512; // that are stepped over
constexpr int steps_over_a_bump = 16;   // each begins elsewhere
constexpr int samples_a_step = 64;      // on a line, of the longest step
constexpr double shortest = 0x1p-5;     // part of the longest step
// Hermite takes its errors for 32 times as large, unless a scene says otherwise. A step that passes
// a bump is so rare that a trial of thousands may not meet one, so these pass more.
constexpr double safety = 8;
constexpr double part_of_first_error = 0.25;
// Polynomials turn too seldom on a ray to hide a bump from three samples.
constexpr int plain_degree = 12;

// A region, with values of names in the middle of what they may be.
struct Looked {
    Bindings<double> numbers;
    Bindings<Interval> bindings;
    std::array<Interval, 3> box;
};

template<class T> Bindings<T> middle_of(const Bindings<Interval>& bindings) {
    Bindings<T> all;
    for (const Interval& value : bindings.parameters) all.parameters.emplace_back(mid(value));
    for (const auto& array : bindings.arrays) {
        auto& columns = all.arrays.emplace_back();
        columns.count = array.count;
        for (const auto& field : array.fields) {
            auto& column = columns.fields.emplace_back();
            for (const Interval& value : field) column.emplace_back(mid(value));
        }
    }
    all.seed = bindings.seed;
    return all;
}

// From side to side of a box.
struct Line {
    const Looked* looked;
    std::array<double, 3> from{}, along{}; // `along` has length 1
    double length = 0;

    double coordinate(std::size_t axis, double t) const { return from[axis] + t * along[axis]; }
};

// F has one sign from `begin` to `end` on a line, and the other one on both sides.
struct Bump {
    const Line* line;
    double begin, end;
};

struct Sample {
    double t, f, slope;
};

// Whether hermite passes from a to b, where F has one sign: see shaders/march/hermite.glsl. The
// third sample is missing on a ray's first step.
bool passes(const Sample& a, const Sample& b, const std::optional<Sample>& third) {
    const double h = b.t - a.t, mean = (b.f - a.f) / h;
    const double c2 = (mean - a.slope) / h, c3 = (b.slope + a.slope - 2 * mean) / (h * h);
    double error = part_of_first_error * std::abs(c3) * h * h * h;
    if (third) {
        const double o = third->t - a.t, p = third->t - b.t;
        const double off = a.f + o * (a.slope + o * (c2 + p * c3)) - third->f;
        const double bend = a.slope + o * (2 * c2 + (o + 2 * p) * c3) - third->slope;
        const double scale = 0.25 * h * h / (o * p);
        error = safety * scale * scale * (std::abs(off) + std::abs(0.5 * bend * o * p / (o + p)));
    }
    const double upright = a.f < 0 ? -1 : 1;
    const double x = upright * 3 * c3, y = upright * (c2 - h * c3), z = upright * a.slope;
    const double root = std::sqrt(std::max(y * y - x * z, 0.0));
    double least_at = (y > 0 ? -z : root - y) / (y > 0 ? y + root : x);
    if (!(least_at > 0 && least_at < h)) least_at = 0.5 * h;
    const double least =
        upright * (a.f + least_at * (a.slope + least_at * (c2 + (least_at - h) * c3)));
    const double in_step = 4 * least_at * (h - least_at) / (h * h);
    const double middle = upright * (0.5 * (a.f + b.f) + 0.125 * h * (a.slope - b.slope));
    return least > error * in_step * in_step && middle > error;
}

// Steps over the bumps that random lines meet.
class Trial {
public:
    Trial(const Field& field, bool is_smooth, std::span<const Region> regions, double length,
          double operations)
        : field_(field)
        , is_smooth_(is_smooth)
        , value_(field.value)
        , directional_(field.directional)
        , length_(length) {
        const std::size_t count = std::min(regions.size(), most_regions);
        for (std::size_t k = 0; k < count; ++k) {
            const Region& region = regions[k * regions.size() / count];
            looked_.push_back({middle_of<double>(region.bindings),
                               middle_of<Interval>(region.bindings), region.box});
        }
        const std::vector<int> counts = looked_.front().numbers.counts();
        double left = operations / (cost(field.value, counts).operations + 1); // evaluations
        lines_.reserve(most_lines);
        for (std::size_t k = 0; k < most_lines; ++k) {
            const Line line = random_line(looked_[k % count]);
            const auto samples = std::size_t(std::min(line.length / apart(), 1e5));
            if ((left -= double(samples)) < 0) break;
            find_bumps(lines_.emplace_back(line), samples);
        }
        const double step = 3 * (cost(field.directional, counts).operations + 1);
        keep_bumps(std::size_t(operations / (steps_over_a_bump * step)));
    }

    // The longest part that steps over no bump.
    double longest(bool is_first) {
        for (double part = 1; part > shortest; part *= 0.5)
            if (!hides_a_bump(part * length_, is_first)) return part;
        return shortest;
    }

private:
    double in(const Interval& side) {
        return side.lo + (side.hi - side.lo) * double(random_() >> 11) * 0x1p-53;
    }

    Line random_line(const Looked& looked) {
        Line line{&looked};
        double begin = -HUGE_VAL, end = HUGE_VAL, square = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            line.from[k] = in(looked.box[k]);
            line.along[k] = in(looked.box[k]) - line.from[k];
            square += line.along[k] * line.along[k];
        }
        for (std::size_t k = 0; k < 3; ++k) {
            line.along[k] /= std::sqrt(square);
            const double a = (looked.box[k].lo - line.from[k]) / line.along[k];
            const double b = (looked.box[k].hi - line.from[k]) / line.along[k];
            begin = std::max(begin, std::min(a, b));
            end = std::min(end, std::max(a, b));
        }
        for (std::size_t k = 0; k < 3; ++k) line.from[k] += begin * line.along[k];
        line.length = end - begin;
        return line;
    }

    double apart() const { return length_ / samples_a_step; }

    void find_bumps(const Line& line, std::size_t count) {
        std::array<std::vector<double>, 3> places;
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (std::size_t k = 0; k < count; ++k)
                places[axis].push_back(line.coordinate(axis, double(k) * apart()));
        std::vector<double> values(count);
        const std::array<std::span<const double>, 3> inputs{places[0], places[1], places[2]};
        value_.points(line.looked->numbers, inputs, std::array{std::span<double>(values)});
        double begun = -HUGE_VAL; // where F has changed its sign last
        for (std::size_t k = 1; k < count; ++k) {
            if (std::isnan(values[k])) begun = -HUGE_VAL;
            if (!(values[k - 1] < 0 && values[k] > 0) && !(values[k - 1] > 0 && values[k] < 0))
                continue;
            const double end = double(k) * apart();
            if (end - begun < length_) bumps_.push_back({&line, begun, end});
            begun = double(k - 1) * apart();
        }
    }

    // An even selection.
    void keep_bumps(std::size_t most) {
        const std::size_t count = std::min({bumps_.size(), most, most_bumps});
        for (std::size_t k = 0; k < count; ++k) bumps_[k] = bumps_[k * bumps_.size() / count];
        bumps_.resize(count);
    }

    Sample sample(const Line& line, double t) {
        std::array<double, 6> inputs{};
        for (std::size_t k = 0; k < 3; ++k) {
            inputs[k] = line.coordinate(k, t);
            inputs[3 + k] = line.along[k];
        }
        std::array<double, 2> f{};
        directional_.point(line.looked->numbers, inputs, f);
        return {t, f[0], f[1]};
    }

    // Where F isn't smooth, cubics don't judge.
    bool is_judged_by_cubics(const Line& line, double begin, double end) {
        if (is_smooth_) return true;
        if (!rough_) rough_.emplace(enclosure_programs(field_).rough);
        std::array<Interval, 3> box;
        for (std::size_t k = 0; k < 3; ++k)
            box[k] = Interval(line.from[k]) + Interval(begin, end) * Interval(line.along[k]);
        std::array<Interval, 2> told;
        rough_->point(line.looked->bindings, box, told);
        return told[1] == Interval{0, 0};
    }

    bool hides_a_bump(double length, bool is_first) {
        for (const Bump& bump : bumps_) {
            if (bump.end - bump.begin > length) continue;
            for (int k = 0; k < steps_over_a_bump; ++k)
                if (is_hidden(bump, length, is_first)) return true;
        }
        return false;
    }

    // Whether a step over the bump, which begins at random, is passed.
    bool is_hidden(const Bump& bump, double length, bool is_first) {
        const double begin = bump.begin - in({0, 1}) * (length - (bump.end - bump.begin));
        const Sample low = sample(*bump.line, begin);
        // As long as Newton's.
        const double h = is_first ? std::min(length, std::abs(low.f / low.slope)) : length;
        const double before = is_first ? 0 : length / in({1.2, 2.5});
        if (begin - before < 0 || begin + h > bump.line->length || begin + h < bump.end)
            return false;
        const Sample high = sample(*bump.line, begin + h);
        std::optional<Sample> third;
        if (!is_first) third = sample(*bump.line, begin - before);
        return (low.f < 0) == (high.f < 0) && passes(low, high, third) &&
               is_judged_by_cubics(*bump.line, begin, begin + h);
    }

    const Field& field_;
    bool is_smooth_;
    Evaluator<double> value_, directional_;
    std::optional<Evaluator<Interval>> rough_;
    double length_;
    std::vector<Looked> looked_;
    std::vector<Line> lines_;
    std::vector<Bump> bumps_;
    std::mt19937_64 random_;
};

} // namespace

CubicSteps cubic_steps(const Field& field, const Smoothness& smoothness,
                       std::span<const Region> regions, double length, double operations) {
    if (smoothness.degree && *smoothness.degree <= plain_degree) return {};
    Trial trial(field, smoothness.is_smooth(), regions, length, operations);
    CubicSteps found;
    found.longest = trial.longest(false);
    found.first = std::min(found.longest, trial.longest(true));
    return found;
}

} // namespace isomotion::formula
