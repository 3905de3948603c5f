// Looks along random lines at the places where a formula may not be smooth: whether its slopes
// change there.
#pragma once

#include <array>
#include <random>

#include "formula/smoothness.h"

namespace isomotion::formula {

enum class Met {
    nothing,
    even_slopes, // slopes go on across what was met: as of cos(acos(min(abs(x), 1)))
    change       // of slopes
};

// What slopes do at the places of a decoration, which is 0 over boxes without such places
// (graph/roughness.h).
class LineProbe {
public:
    // `bends_are_even`: bends that begin where F is flat along an entire line are no changes.
    LineProbe(const Program& decoration, const Program& directional, bool bends_are_even);

    Met along_lines(const Region& region, int lines);

    // Does the same for one element of the one array, without the others. Few lines meet a small
    // element, so this one is drawn through a place where its decoration may be.
    Met at_element(const Region& region, int element);

    // The place that the last descent met.
    const std::array<double, 3>& place() const { return place_; }

private:
    using Box = std::array<Interval, 3>;

    void enter(const Bindings<Interval>& bindings);
    Met along_line(int descents, int places);
    Met descend();
    double in(const Interval& side);
    void draw_line(const Box& box);
    bool aim_line(const Box& box);
    void draw_direction(const Box& box);
    double slope(double t);
    bool may_be_in(double a, double b);
    bool may_be_in(const Box& box);

    // Parts of a line: how closely a place is found, and from how far its slopes are taken.
    static constexpr double width = 1e-10, beside = 1e-8;

    Evaluator<Interval> decoration_;
    Evaluator<double> directional_;
    bool bends_are_even_;
    Bindings<Interval> bindings_;
    Bindings<double> numbers_;
    std::array<double, 3> from_{}, along_{}, place_{};
    double usual_slope_ = 0;
    std::mt19937_64 random_;
};

} // namespace isomotion::formula
