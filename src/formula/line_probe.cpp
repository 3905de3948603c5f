#include "formula/line_probe.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace isomotion::formula {

LineProbe::LineProbe(const Program& decoration, const Program& directional, bool bends_are_even)
    : decoration_(decoration)
    , directional_(directional)
    , bends_are_even_(bends_are_even) {}

Met LineProbe::along_lines(const Region& region, int lines) {
    enter(region.bindings);
    Met all = Met::nothing;
    for (int k = 0; k < lines && all != Met::change; ++k) {
        draw_line(region.box);
        all = std::max(all, along_line(8, 8));
    }
    return all;
}

Met LineProbe::at_element(const Region& region, int element) {
    Bindings<Interval> alone = region.bindings;
    alone.arrays[0].count = 1;
    for (auto& field : alone.arrays[0].fields)
        if (std::size_t(element) < field.size()) field = {field[std::size_t(element)]};
    enter(alone);
    for (int tries = 0; tries < 8; ++tries)
        if (aim_line(region.box)) return along_line(32, 4);
    return Met::nothing;
}

// Parameters and elements are in the middle of what they may be.
void LineProbe::enter(const Bindings<Interval>& bindings) {
    bindings_ = bindings;
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
}

// Makes at most `descents` descents, and ends when `places` of them have met a place.
Met LineProbe::along_line(int descents, int places) {
    if (!may_be_in(0, 1)) return Met::nothing;
    usual_slope_ = 0;
    for (int part = 0; part < 16; ++part) usual_slope_ += std::abs(slope((part + 0.5) / 16)) / 16;
    Met all = Met::nothing;
    for (int met = 0; descents > 0 && met < places && all != Met::change; --descents) {
        const Met found = descend();
        met += found != Met::nothing;
        all = std::max(all, found);
    }
    return all;
}

double LineProbe::in(const Interval& side) {
    return side.lo + (side.hi - side.lo) * double(random_() >> 11) * 0x1p-53;
}

// Draws a line at random, from side to side of the box.
void LineProbe::draw_line(const Box& box) {
    for (std::size_t k = 0; k < 3; ++k) from_[k] = in(box[k]);
    draw_direction(box);
}

// The same through a place where the decoration may be; false if none was found.
bool LineProbe::aim_line(const Box& box) {
    Box part = box;
    for (std::size_t k = 0; k < 3 * 8; ++k) {
        Interval& side = part[k % 3];
        std::array halves{Interval(side.lo, mid(side)), Interval(mid(side), side.hi)};
        if (random_() >> 63) std::swap(halves[0], halves[1]);
        side = halves[0];
        if (may_be_in(part)) continue;
        side = halves[1];
        if (!may_be_in(part)) return false;
    }
    for (std::size_t k = 0; k < 3; ++k) from_[k] = mid(part[k]);
    draw_direction(box);
    return true;
}

void LineProbe::draw_direction(const Box& box) {
    double begin = -HUGE_VAL, end = HUGE_VAL;
    for (std::size_t k = 0; k < 3; ++k) {
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
double LineProbe::slope(double t) {
    std::array<double, 6> inputs{};
    for (std::size_t k = 0; k < 3; ++k) {
        inputs[k] = from_[k] + t * along_[k];
        inputs[3 + k] = along_[k];
    }
    std::array<double, 2> f{};
    directional_.point(numbers_, inputs, f);
    return f[1];
}

bool LineProbe::may_be_in(double a, double b) {
    Box box;
    for (std::size_t k = 0; k < 3; ++k)
        box[k] = Interval(from_[k]) + Interval(a, b) * Interval(along_[k]);
    return may_be_in(box);
}

bool LineProbe::may_be_in(const Box& box) {
    Interval decoration;
    decoration_.point(bindings_, box, {&decoration, 1});
    return decoration != Interval{0, 0};
}

// What the slopes do at one of the places that the line may meet, chosen at random.
Met LineProbe::descend() {
    double a = 0, b = 1;
    while (b - a > width) {
        const double middle = 0.5 * (a + b);
        const bool to_the_left = random_() >> 63;
        const bool is_there = may_be_in(to_the_left ? a : middle, to_the_left ? middle : b);
        if (!is_there && !may_be_in(to_the_left ? middle : a, to_the_left ? b : middle))
            return Met::nothing;
        (to_the_left == is_there ? b : a) = middle;
    }
    for (std::size_t k = 0; k < 3; ++k) place_[k] = from_[k] + a * along_[k];
    const double before = slope(a - beside), after = slope(b + beside);
    const double usual = std::max({usual_slope_, std::abs(before), std::abs(after)});
    const double change = std::abs(after - before);
    if (change <= 1e-3 * usual) return Met::even_slopes;
    // Slopes of a kink differ as much from farther away, those of a bend in proportion.
    if (!bends_are_even_) return Met::change;
    const double wider = std::abs(slope(b + 16 * beside) - slope(a - 16 * beside));
    return wider >= 8 * change ? Met::even_slopes : Met::change;
}

} // namespace isomotion::formula
