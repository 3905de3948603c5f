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

constexpr std::size_t most_lines = 64;  // of all moments; every other one is aimed at the surface
constexpr std::size_t most_bumps = 512; // that are stepped over
constexpr int steps_over_a_bump = 16;   // each begins elsewhere
// Random lines seldom meet an edge as rays along a silhouette do: they are moved aside until they
// graze the body, halving the way so many times.
constexpr int halvings_to_graze = 8;
// Samples on a line, of the longest step: as many as there are operations for.
constexpr double most_samples = 256, fewest_samples = 64;
constexpr double shortest = 0x1p-8; // part of the longest step
// A step that passes a bump is so rare that a trial of thousands may not meet one. So errors count
// for this part of what they are, and more steps pass. Lines that graze edges meet many: counting
// all of their errors left one pixel of 4096 wrong in three of nine pictures of sharp blends, this
// part none.
constexpr double part_of_errors_in_trials = 0.25, part_of_errors_at_edges = 0.7;
// Polynomials turn too seldom on a ray to hide a bump from three samples.
constexpr int plain_degree = 12;

// A moment, and how finely its lines are sampled.
struct Looked {
    const Moment* moment;
    Bindings<Interval> bindings; // the same values
    double length;               // of the longest step
    double apart;                // of samples
};

double diagonal(const std::array<Interval, 3>& box) {
    double square = 0;
    for (const Interval& side : box) square += (side.hi - side.lo) * (side.hi - side.lo);
    return std::sqrt(square);
}

// A part of a line in a box.
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
    bool is_below_0;
};

struct Sample {
    double t, f, slope;
};

// Whether hermite goes on behind b without a root between a and b; or with one, where F changes its
// sign: see shaders/march/cubic.glsl. The third sample is missing on a ray's first step. What only
// shortens steps there, and numbers beyond floats, are left out here.
// Guessed errors count for `part` of what they are, measured ones for `safety` times that.
bool passes(const Sample& a, const Sample& b, const std::optional<Sample>& third, double safety,
            double part) {
    const double h = b.t - a.t, mean = (b.f - a.f) / h;
    const double c2 = (mean - a.slope) / h, c3 = (b.slope + a.slope - 2 * mean) / (h * h);
    double error = std::abs(c3) * h * h * h;
    if (third) {
        const double o = third->t - a.t, p = third->t - b.t;
        const double off = a.f + o * (a.slope + o * (c2 + p * c3)) - third->f;
        const double bend = a.slope + o * (2 * c2 + (o + 2 * p) * c3) - third->slope;
        const double scale = 0.25 * h * h / (o * p);
        error = safety * scale * scale * (std::abs(off) + std::abs(0.5 * bend * o * p / (o + p)));
    }
    error *= part;
    const double upright = a.f < 0 ? -1 : 1;
    const double x = upright * 3 * c3, y = upright * (c2 - h * c3), z = upright * a.slope;
    const double root = std::sqrt(std::max(y * y - x * z, 0.0));
    double least_at = (y > 0 ? -z : root - y) / (y > 0 ? y + root : x);
    const bool dips = least_at > 0 && least_at < h;
    if (!dips) least_at = 0.5 * h;
    const double least =
        upright * (a.f + least_at * (a.slope + least_at * (c2 + (least_at - h) * c3)));
    const double in_step = 4 * least_at * (h - least_at) / (h * h);
    const bool clear = least > error * in_step * in_step;
    if ((a.f < 0) != (b.f < 0))
        return (clear || !dips) && error < 0.5 * std::max(std::abs(a.f), std::abs(b.f));
    const double middle = upright * (0.5 * (a.f + b.f) + 0.125 * h * (a.slope - b.slope));
    return clear && middle > error;
}

// Steps over the bumps that random lines meet.
class Trial {
public:
    Trial(const Field& field, const Smoothness& smoothness, std::span<const Moment> moments,
          double length, double safety, double operations)
        : field_(field)
        , is_smooth_(smoothness.is_smooth())
        , safety_(safety)
        , value_(field.value)
        , directional_(field.directional)
        , bounds_(value_enclosure(field)) {
        const std::vector<int> counts = moments.front().numbers.counts();
        double left = operations / (cost(field.value, counts).operations + 1); // evaluations
        const double whole = diagonal(moments.front().box);
        // Lines have half of the diagonal's length in the mean.
        const double affordable = left / (0.5 * whole / length * double(most_lines));
        const double samples_a_step = std::clamp(affordable, fewest_samples, most_samples);
        for (const Moment& moment : moments) {
            const double its = length * diagonal(moment.box) / whole;
            looked_.push_back(
                {&moment, convert<Interval>(moment.numbers), its, its / samples_a_step});
        }
        lines_.reserve(most_lines * (1 + halvings_to_graze));
        for (std::size_t k = 0; k < most_lines; ++k) {
            const Line line = random_line(looked_[k / 2 % looked_.size()], k % 2 == 1);
            if (!(line.length > 0)) continue;
            const auto samples = std::size_t(std::min(line.length / line.looked->apart, 1e5));
            if ((left -= double(samples)) < 0) break;
            find_bumps(lines_.emplace_back(line), samples);
        }
        // Most trials of a step that is too long end soon.
        const double step = 3 * (cost(field.directional, counts).operations + 1);
        most_bumps_ = std::size_t(0.25 * operations / (steps_over_a_bump * step));
        keep_bumps();
    }

    CubicSteps steps() {
        CubicSteps found;
        found.longest = longest(false);
        found.first = std::min(found.longest, longest(true));
        return found;
    }

    // From now on bumps are those of lines that graze the bodies which the random lines meet, with
    // an effort of so many evaluations.
    void graze(double evaluations) {
        const std::vector<Bump> chords = std::move(chords_);
        chords_.clear();
        bumps_.clear();
        part_of_errors_ = part_of_errors_at_edges;
        const std::size_t count = std::min(chords.size(), most_lines);
        for (std::size_t k = 0; k < count && evaluations > 0; ++k)
            evaluations -= graze(chords[k * chords.size() / count]);
        keep_bumps();
    }

private:
    // The longest part that steps over no bump, where no shorter one does either. Bounds judge
    // steps over kinks, so that a formula with kinks may fail at shorter parts alone.
    double longest(bool is_first) {
        double found = 1;
        for (double part = 1; part > shortest && (part == found || !is_smooth_); part *= 0.5)
            if (hides_a_bump(part, is_first)) found = 0.5 * part;
        return found;
    }

    double in(const Interval& side) {
        return side.lo + (side.hi - side.lo) * double(random_() >> 11) * 0x1p-53;
    }

    // Where F may be 0, if halving the box at random leads to such a place.
    std::array<double, 3> aimed_place(const Looked& looked) {
        std::array<Interval, 3> box = looked.moment->box;
        for (std::size_t k = 0; k < 3 * 10; ++k) {
            Interval& side = box[k % 3];
            std::array halves{Interval(side.lo, mid(side)), Interval(mid(side), side.hi)};
            if (random_() >> 63) std::swap(halves[0], halves[1]);
            side = halves[0];
            if (!may_be_0(looked, box)) side = halves[1];
        }
        return {in(box[0]), in(box[1]), in(box[2])};
    }

    bool may_be_0(const Looked& looked, const std::array<Interval, 3>& box) {
        Interval f;
        bounds_.point(looked.bindings, box, {&f, 1});
        return f.lo <= 0 && f.hi >= 0;
    }

    Line random_line(const Looked& looked, bool is_aimed) {
        Line line{&looked};
        line.from = is_aimed ? aimed_place(looked)
                             : std::array{in(looked.moment->box[0]), in(looked.moment->box[1]),
                                          in(looked.moment->box[2])};
        double square = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            line.along[k] = in(looked.moment->box[k]) - line.from[k];
            square += line.along[k] * line.along[k];
        }
        for (std::size_t k = 0; k < 3; ++k) line.along[k] /= std::sqrt(square);
        return within_box(line, -HUGE_VAL, HUGE_VAL);
    }

    // The part of a line from t = begin to end that is in its box; with a negative length, none is.
    static Line within_box(Line line, double begin, double end) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Interval& side = line.looked->moment->box[k];
            const double a = (side.lo - line.from[k]) / line.along[k];
            const double b = (side.hi - line.from[k]) / line.along[k];
            begin = std::max(begin, std::min(a, b));
            end = std::min(end, std::max(a, b));
        }
        for (std::size_t k = 0; k < 3; ++k) line.from[k] += begin * line.along[k];
        line.length = end - begin;
        return line;
    }

    // F at even distances on a line.
    std::vector<double> values_on(const Line& line, std::size_t count) {
        std::array<std::vector<double>, 3> places;
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (std::size_t k = 0; k < count; ++k)
                places[axis].push_back(line.coordinate(axis, double(k) * line.looked->apart));
        std::vector<double> values(count);
        const std::array<std::span<const double>, 3> inputs{places[0], places[1], places[2]};
        value_.points(line.looked->moment->numbers, inputs, std::array{std::span<double>(values)});
        return values;
    }

    void find_bumps(const Line& line, std::size_t count) {
        const std::vector<double> values = values_on(line, count);
        double begun = -HUGE_VAL; // where F has changed its sign last
        std::size_t last = 0;     // sample with a sign
        for (std::size_t k = 0; k < count; ++k) {
            if (values[k] == 0) continue;
            if (std::isnan(values[k])) {
                begun = -HUGE_VAL;
            } else if ((values[last] < 0 && values[k] > 0) || (values[last] > 0 && values[k] < 0)) {
                const double end = double(k) * line.looked->apart;
                if (end - begun < line.looked->length)
                    bumps_.push_back({&line, begun, end, values[last] < 0});
                if (begun >= 0) chords_.push_back({&line, begun, end, values[last] < 0});
                begun = double(last) * line.looked->apart;
            }
            last = k;
        }
    }

    // Halves the way aside from a chord to where the line leaves the body, and returns the number
    // of evaluations that it took.
    double graze(const Bump& chord) {
        const double length = chord.line->looked->length, reach = chord.end - chord.begin;
        const std::array<double, 3> aside = random_perpendicular(chord.line->along);
        double inside = 0, outside = reach, evaluations = 0;
        for (int k = 0; k < halvings_to_graze; ++k) {
            Line line = *chord.line;
            const double by = 0.5 * (inside + outside);
            for (std::size_t axis = 0; axis < 3; ++axis) line.from[axis] += by * aside[axis];
            line = within_box(line, chord.begin - 2 * length, chord.end + 2 * length);
            const double most = (reach + 4 * length) / line.looked->apart;
            const auto samples =
                std::size_t(std::clamp(line.length / line.looked->apart, 0.0, most));
            evaluations += double(samples);
            const std::size_t known = chords_.size();
            if (samples > 0) find_bumps(lines_.emplace_back(line), samples);
            const bool meets = std::any_of(
                chords_.begin() + std::ptrdiff_t(known), chords_.end(),
                [&](const Bump& found) { return found.is_below_0 == chord.is_below_0; });
            (meets ? inside : outside) = by;
        }
        return evaluations;
    }

    std::array<double, 3> random_perpendicular(const std::array<double, 3>& along) {
        std::array<double, 3> v{in({-1, 1}), in({-1, 1}), in({-1, 1})};
        const double lean = v[0] * along[0] + v[1] * along[1] + v[2] * along[2];
        double square = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            v[axis] -= lean * along[axis];
            square += v[axis] * v[axis];
        }
        for (double& coordinate : v) coordinate /= std::sqrt(square);
        return v;
    }

    // An even selection.
    void keep_bumps() {
        const std::size_t count = std::min({bumps_.size(), most_bumps_, most_bumps});
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
        directional_.point(line.looked->moment->numbers, inputs, f);
        return {t, f[0], std::isnan(f[1]) ? 0 : f[1]}; // as hermite does
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

    bool hides_a_bump(double part, bool is_first) {
        for (const Bump& bump : bumps_) {
            const double length = part * bump.line->looked->length;
            if (bump.end - bump.begin > length) continue;
            for (int k = 0; k < steps_over_a_bump; ++k) {
                // Steps grow, or are as long as they may be.
                const double before = length / (k % 2 ? in({1.2, 2.5}) : 1);
                if (is_hidden(bump, length, is_first ? 0 : before)) return true;
            }
        }
        return false;
    }

    // Whether a step over the bump, which begins at random, is passed. `before`: the length of the
    // step before it; 0 for a ray's first step, which is no longer than Newton's.
    bool is_hidden(const Bump& bump, double length, double before) {
        const double begin = bump.begin - in({0, 1}) * (length - (bump.end - bump.begin));
        if (begin - before < 0 || begin + length > bump.line->length) return false;
        const Sample low = sample(*bump.line, begin);
        const bool is_first = before == 0;
        // Behind a kink a step has no third sample, either, and any length.
        const bool is_newtons = is_first && is_smooth_;
        const double end =
            begin + (is_newtons ? std::min(length, std::abs(low.f / low.slope)) : length);
        if (!(end >= bump.end)) return false;
        std::optional<Sample> third;
        if (!is_first) third = sample(*bump.line, begin - before);
        return passes(low, sample(*bump.line, end), third, safety_, part_of_errors_) &&
               is_judged_by_cubics(*bump.line, begin - before, end);
    }

    const Field& field_;
    bool is_smooth_;
    double safety_;
    Evaluator<double> value_, directional_;
    Evaluator<Interval> bounds_;
    std::optional<Evaluator<Interval>> rough_;
    std::vector<Looked> looked_;
    std::vector<Line> lines_;
    std::vector<Bump> bumps_;
    std::vector<Bump> chords_; // of any length
    double part_of_errors_ = part_of_errors_in_trials;
    std::size_t most_bumps_ = 0;
    std::mt19937_64 random_;
};

} // namespace

CubicSteps cubic_steps(const Field& field, const Smoothness& smoothness,
                       std::span<const Moment> moments, double length, double safety,
                       double operations) {
    if (moments.empty() || (smoothness.degree && *smoothness.degree <= plain_degree)) return {};
    // A line has a hundred samples and more.
    const std::vector<int> counts = moments.front().numbers.counts();
    if (100 * cost(field.value, counts).operations > operations) return {};
    Trial trial(field, smoothness, moments, length, safety, operations);
    CubicSteps found = trial.steps();
    trial.graze(0.5 * operations / (cost(field.value, counts).operations + 1));
    const CubicSteps at_edges = trial.steps();
    found.longest = std::min(found.longest, at_edges.longest);
    found.first = std::min(found.first, at_edges.first);
    return found;
}

} // namespace isomotion::formula
