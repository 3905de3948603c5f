#include "roots/first_root.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "roots/outward.h"

namespace isomotion::roots {
namespace {

using formula::Interval;

int sign_of(const Interval& f) { return f.lo > 0 ? 1 : f.hi < 0 ? -1 : 0; }

// A lower bound of a function on a piece of length h that is at least `at_begin` and `at_end` at
// its ends and whose slope stays in `slope`: where the two lines of steepest descent meet.
double least_between(double at_begin, double at_end, const Interval& slope, double h) {
    const double down = slope.lo, up = slope.hi;
    if (!(down < 0)) return at_begin;
    if (!(up > 0)) return at_end;
    if (std::isinf(down) || std::isinf(up)) return -HUGE_VAL;
    // Rounding of the quotient is far below the part of it that is given away here.
    const double parts[] = {up * at_begin, -down * at_end, down * up * h};
    const double size = std::abs(parts[0]) + std::abs(parts[1]) + std::abs(parts[2]);
    return (parts[0] + parts[1] + parts[2] - 1e-14 * size) / (up - down);
}

Interval times(const Interval& f, int sign) { return sign < 0 ? Interval{-f.hi, -f.lo} : f; }

} // namespace

// One ray on its way. Everything up to `a` is known: F has the sign `sign` there but in the runs
// that were noted as touching.
struct RootFinder::Lane {
    enum class Phase { begin, march, refine, resume, done };

    Tube tube;
    FirstRoot* root = nullptr;
    Phase phase = Phase::begin;
    double a = 0, step = 0;
    Interval at_a;
    int sign = 0;
    // Pieces that could not be told from zero, still being put together.
    bool in_run = false;
    double run_begin = 0;
    double low = 0, high = 0; // of a crossing being narrowed down
    int evaluations = 0;

    double b() const { return std::min(a + step, tube.far); }

    void touch(double from, double to) {
        if (root->answer != Answer::touching) {
            root->answer = Answer::touching;
            root->touch_low = below(from);
        }
        root->touch_high = above(to);
    }

    void end(bool hit) {
        if (root->answer == Answer::touching) {
            root->after_is_hit = hit;
        } else {
            root->answer = hit ? Answer::hit : Answer::miss;
        }
        if (hit) {
            root->low = below(low);
            root->high = above(high);
        }
        phase = Phase::done;
    }

    void give_up() {
        const float known =
            root->answer == Answer::touching ? root->touch_low : below(in_run ? run_begin : a);
        *root = {};
        root->answer = Answer::undecided;
        root->low = known;
        phase = Phase::done;
    }

    // F changes its sign in [low, high], which is as narrow as it gets. Where the shader's interval
    // may have ended already, the crossing may be seen or not; where F may jump there may be none.
    void end_crossing(bool has_root) {
        if (has_root && low >= tube.near_inside && high <= tube.far_inside) {
            end(true);
            return;
        }
        touch(low, high);
        sign = -sign;
        a = high;
        phase = Phase::resume;
    }
};

RootFinder::RootFinder(const formula::EnclosurePrograms& field, const scene::SurfaceAt& surface,
                       Budget budget)
    : value_(OverAll(field.value))
    , directional_(OverAll(field.directional))
    , gradient_(OverAll(field.gradient))
    , jumps_(OverAll(field.jumps))
    , bindings_(formula::convert<Interval>(surface.bindings))
    , may_lack_values_(field.may_lack_values)
    , budget_(budget) {}

RootFinder::RootFinder(const elements::FieldByPlace::Frame& field, Budget budget)
    : value_(elements::BoxesByPlace(field.programs().value, field))
    , directional_(elements::BoxesByPlace(field.programs().directional, field))
    , gradient_(elements::BoxesByPlace(field.programs().gradient, field))
    , jumps_(elements::BoxesByPlace(field.programs().jumps, field))
    , may_lack_values_(field.programs().may_lack_values)
    , budget_(budget) {}

// Boxes to evaluate, one for each lane that asks.
struct RootFinder::Request {
    std::array<std::vector<Interval>, 6> inputs;
    std::array<std::vector<Interval>, 3> outputs;

    void clear() {
        for (auto& input : inputs) input.clear();
    }
    // The part of the tube from t = a to b. Its radius leaves room for the rounding here.
    void add(const Tube& tube, double a, double b, bool with_direction) {
        for (int k = 0; k < 3; ++k) {
            const double p = tube.anchor[k] + a * tube.direction[k];
            const double q = tube.anchor[k] + b * tube.direction[k];
            inputs[std::size_t(k)].push_back(
                {std::min(p, q) - tube.radius, std::max(p, q) + tube.radius});
            if (!with_direction) continue;
            inputs[std::size_t(3 + k)].push_back({tube.direction[k] - tube.direction_radius,
                                                  tube.direction[k] + tube.direction_radius});
        }
    }
    void evaluate(Program& program, const formula::Bindings<Interval>& bindings,
                  std::size_t arguments, std::size_t results) {
        std::vector<std::span<const Interval>> from;
        std::vector<std::span<Interval>> to;
        for (std::size_t k = 0; k < arguments; ++k) from.emplace_back(inputs[k]);
        for (std::size_t k = 0; k < results; ++k) {
            outputs[k].resize(inputs[0].size());
            to.emplace_back(outputs[k]);
        }
        if (OverAll* all = std::get_if<OverAll>(&program)) {
            all->points(bindings, from, to);
        } else {
            std::get<elements::BoxesByPlace>(program).points(from, to);
        }
    }
};

void RootFinder::find(std::span<const Tube> tubes, std::span<FirstRoot> roots) {
    std::vector<Lane> lanes(std::min<std::size_t>(tubes.size(), lanes_together));
    std::size_t next = 0;
    const auto refill = [&](Lane& lane) {
        while (next < tubes.size()) {
            const std::size_t ray = next++;
            roots[ray] = {};
            if (!tubes[ray].holds) {
                roots[ray].answer = Answer::undecided;
                roots[ray].low = -HUGE_VALF;
                continue;
            }
            if (!(tubes[ray].near <= tubes[ray].far)) continue; // passes the bounds by
            lane = {};
            lane.tube = tubes[ray];
            lane.root = &roots[ray];
            lane.a = lane.tube.near;
            return true;
        }
        return false;
    };
    std::erase_if(lanes, [&](Lane& lane) { return !refill(lane); });
    Request points, pieces;
    while (!lanes.empty()) {
        points.clear();
        pieces.clear();
        for (const Lane& lane : lanes) {
            const double at = lane.phase == Lane::Phase::refine  ? 0.5 * (lane.low + lane.high)
                              : lane.phase == Lane::Phase::march ? lane.b()
                                                                 : lane.a;
            points.add(lane.tube, at, at, false);
            if (lane.phase == Lane::Phase::march) pieces.add(lane.tube, lane.a, lane.b(), true);
        }
        points.evaluate(value_, bindings_, 3, 1);
        pieces.evaluate(directional_, bindings_, 6, 2);
        sharpen(lanes, points);
        std::size_t piece = 0;
        for (std::size_t k = 0; k < lanes.size(); ++k) {
            Lane& lane = lanes[k];
            const Interval at_point = points.outputs[0][k];
            lane.evaluations += 1;
            switch (lane.phase) {
            case Lane::Phase::begin:
                begin(lane, at_point);
                break;
            case Lane::Phase::resume:
                resume(lane, at_point);
                break;
            case Lane::Phase::refine:
                refine(lane, at_point);
                break;
            case Lane::Phase::march:
                lane.evaluations += 1;
                march(lane, at_point, pieces.outputs[0][piece], pieces.outputs[1][piece]);
                ++piece;
                break;
            case Lane::Phase::done:
                break;
            }
            if (lane.phase != Lane::Phase::done && lane.evaluations > budget_.evaluations) {
                lane.give_up();
            }
        }
        std::erase_if(lanes, [&](Lane& lane) {
            if (lane.phase != Lane::Phase::done) return false;
            evaluations_ += lane.evaluations;
            return !refill(lane);
        });
    }
}

void RootFinder::gradients(std::span<const Tube> tubes, std::span<FirstRoot> roots) {
    Request places;
    std::vector<FirstRoot*> hits;
    for (std::size_t k = 0; k < roots.size(); ++k) {
        if (roots[k].answer != Answer::hit || roots[k].cap >= 0) continue;
        hits.push_back(&roots[k]);
        const double t = 0.5 * (double(roots[k].low) + double(roots[k].high));
        for (int axis = 0; axis < 3; ++axis)
            places.inputs[std::size_t(axis)].emplace_back(tubes[k].anchor[axis] +
                                                          t * tubes[k].direction[axis]);
    }
    if (hits.empty()) return;
    places.evaluate(gradient_, bindings_, 3, 3);
    for (std::size_t k = 0; k < hits.size(); ++k) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            hits[k]->gradient[axis] = float(mid(places.outputs[axis][k]));
    }
}

// Where the tube's thickness alone makes a sign uncertain: F over the cross-section at a point is F
// in its middle and at most the gradient times the radius more. Near nodes and where large terms
// cancel that is far less than what the terms' own enclosures leave.
void RootFinder::sharpen(std::vector<Lane>& lanes, Request& points) {
    std::vector<std::size_t> uncertain;
    for (std::size_t k = 0; k < lanes.size(); ++k) {
        if (sign_of(points.outputs[0][k]) != 0) continue;
        uncertain.push_back(k);
        lanes[k].evaluations += 1;
    }
    sharpen(uncertain, points);
}

void RootFinder::sharpen(std::span<const std::size_t> uncertain, Request& points) {
    if (uncertain.empty()) return;
    Request middles, sections;
    for (const std::size_t k : uncertain) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Interval box = points.inputs[axis][k];
            sections.inputs[axis].push_back(box);
            middles.inputs[axis].push_back(mid(box));
        }
    }
    middles.evaluate(value_, bindings_, 3, 1);
    sections.evaluate(gradient_, bindings_, 3, 3);
    for (std::size_t u = 0; u < uncertain.size(); ++u) {
        Interval f = middles.outputs[0][u];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            f = f +
                sections.outputs[axis][u] * (sections.inputs[axis][u] - middles.inputs[axis][u]);
        }
        Interval& known = points.outputs[0][uncertain[u]];
        known = intersect(known, f);
    }
}

std::vector<int> RootFinder::signs(std::span<const Tube> tubes) {
    std::vector<int> signs;
    if (tubes.empty()) return signs;
    Request pieces;
    for (const Tube& tube : tubes) pieces.add(tube, tube.near, tube.far, false);
    pieces.evaluate(value_, bindings_, 3, 1);
    std::vector<std::size_t> uncertain;
    for (std::size_t k = 0; k < tubes.size(); ++k) {
        if (sign_of(pieces.outputs[0][k]) == 0) uncertain.push_back(k);
    }
    sharpen(uncertain, pieces);
    for (const Interval& f : pieces.outputs[0]) signs.push_back(sign_of(f));
    evaluations_ += std::int64_t(tubes.size() + uncertain.size());
    return signs;
}

void RootFinder::begin(Lane& lane, const Interval& f) const {
    lane.sign = sign_of(f);
    lane.step = (lane.tube.far - lane.tube.near) / 8;
    resume(lane, f);
}

// Marches on from `a`, where F is `f`.
void RootFinder::resume(Lane& lane, const Interval& f) const {
    lane.at_a = f;
    lane.in_run = sign_of(f) == 0;
    lane.run_begin = lane.a;
    lane.phase = Lane::Phase::march;
}

void RootFinder::refine(Lane& lane, const Interval& f) const {
    const double middle = 0.5 * (lane.low + lane.high);
    const int sign = sign_of(f);
    if (sign == lane.sign) {
        lane.low = middle;
    } else if (sign == -lane.sign) {
        lane.high = middle;
    }
    // F is too near zero to be told from it, or the enclosure is as narrow as the tube allows.
    if (sign == 0 || lane.high - lane.low <= budget_.bracket * lane.tube.footprint) {
        lane.end_crossing(true);
    }
}

void RootFinder::march(Lane& lane, const Interval& at_b, const Interval& f, const Interval& slope) {
    const double b = lane.b(), h = b - lane.a;
    const int sign_a = sign_of(lane.at_a), sign_b = sign_of(at_b);
    const bool is_unbounded = std::isinf(f.lo) || std::isinf(f.hi);
    if (may_lack_values_ && is_unbounded && sign_of(f) == 0) {
        lane.evaluations += 1;
        if (breaks(lane.tube, lane.a, b).has_no_value) {
            pass_gap(lane, at_b);
            return;
        }
    }
    int piece_sign = sign_of(f);
    if (piece_sign == 0 && sign_a != 0 && sign_a == sign_b) {
        const double least = least_between(times(lane.at_a, sign_a).lo, times(at_b, sign_b).lo,
                                           times(slope, sign_a), h);
        if (least > 0) piece_sign = sign_a;
    }
    const auto go_on = [&] {
        lane.a = b;
        lane.at_a = at_b;
        if (b >= lane.tube.far) finish(lane);
    };
    if (piece_sign != 0) {
        if (lane.in_run) {
            end_run(lane, piece_sign);
            if (lane.phase != Lane::Phase::march) return;
        }
        lane.sign = piece_sign;
        lane.step = 1.5 * h;
        go_on();
        return;
    }
    // One crossing and no more, if the slope has one sign: F is continuous then.
    const bool crosses = sign_a != 0 && sign_b == -sign_a;
    if (crosses && sign_of(slope) != 0 && !lane.in_run) {
        lane.low = lane.a;
        lane.high = b;
        lane.phase = Lane::Phase::refine;
        return;
    }
    // Long runs, along a double line say, are passed in longer pieces while they last.
    const bool lasts = lane.in_run && sign_b == 0;
    // Where the signs at both ends are known, the tube's thickness is not what hides the piece's:
    // shorter pieces will tell.
    const bool told = sign_a != 0 && sign_b != 0;
    double narrow = (told ? budget_.narrowest : budget_.narrow) * lane.tube.footprint;
    if (lasts) narrow = std::max(narrow, 0.25 * (lane.a - lane.run_begin));
    if (h > narrow) {
        lane.step = 0.5 * h;
        return;
    }
    if (!lane.in_run) {
        lane.in_run = true;
        lane.run_begin = lane.a;
    }
    if (lasts) lane.step = std::max(h, 0.25 * (b - lane.run_begin));
    go_on();
}

// The sign is known again: a run between two signs is a crossing, of odd order or of several roots.
void RootFinder::end_run(Lane& lane, int sign) {
    lane.in_run = false;
    const bool crossed = lane.sign != 0 && sign == -lane.sign;
    if (!crossed) {
        lane.touch(lane.run_begin, lane.a);
        return;
    }
    lane.low = lane.run_begin;
    lane.high = lane.a;
    lane.end_crossing(breaks(lane.tube, lane.low, lane.high).is_continuous);
}

// Goes on to the end of a piece where F has no value or no zero: what was uncertain ends before it,
// and what sign F had before tells nothing of after.
void RootFinder::pass_gap(Lane& lane, const Interval& at_b) const {
    const double b = lane.b();
    if (lane.in_run && lane.run_begin < lane.a) lane.touch(lane.run_begin, lane.a);
    lane.in_run = false;
    lane.sign = sign_of(at_b);
    lane.step = 1.5 * (b - lane.a);
    lane.a = b;
    lane.at_a = at_b;
    if (b >= lane.tube.far) finish(lane);
}

// Whether F has all values between those at the ends of a piece, and whether it has none there, or
// none that is 0.
RootFinder::Breaks RootFinder::breaks(const Tube& tube, double low, double high) {
    Request piece;
    piece.add(tube, low, high, false);
    piece.evaluate(jumps_, bindings_, 3, 2);
    return {piece.outputs[0][0] != Interval::entire(), piece.outputs[1][0].lo > 0};
}

void RootFinder::finish(Lane& lane) const {
    if (lane.in_run) lane.touch(lane.run_begin, lane.tube.far);
    lane.end(false);
}

} // namespace isomotion::roots
