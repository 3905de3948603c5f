// Ways down from saddles, and what they join: the part of a field's Morse complex that says which
// of its minima are connected below a level (Edelsbrunner, Harer and Zomorodian 2003).
//
// In doubles, for the proof of a path to follow; the ways need not be the gradient's own.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "topology/point_field.h"

namespace isomotion::topology {

// Where ways may go. Of the region outside of the bounds a way has reached its end.
struct Ground {
    SpaceBox box;
    bool is_solid = true;                              // ways stay inside of the bounds
    std::function<bool(const SpacePoint&)> is_inside;  // the bounds
    std::function<bool(const SpacePoint&)> is_outside; // of the bounds, for certain
};

struct Way {
    std::vector<SpacePoint> points; // from the saddle, or from where it starts, down
    enum class End { lost, minimum, outside } end = End::lost;
};

struct Start {
    SpacePoint from;
    SpacePoint direction; // a unit vector; 0: down the slope
};

std::vector<Way> ways_down(PointField& field, const Ground& ground, std::span<const Start> starts);

// A saddle and its two ways.
struct Pass {
    double height = 0; // H there
    std::array<Way, 2> ways;
};
std::vector<Pass> passes(PointField& field, const Ground& ground,
                         std::span<const SpacePoint> saddles);

// A way over passes.
struct Route {
    static constexpr std::size_t none = std::size_t(-1);
    std::vector<SpacePoint> points;
    std::vector<std::size_t> over; // of each point, which pass it belongs to, or none
};

// Minima, joined by passes.
class PassGraph {
public:
    // Minima nearer to each other than `same` are one.
    PassGraph(std::span<const Pass> passes, double same);

    // Down one way, over passes as low as can be, but for those that are closed, and up the other
    // way; empty if there is none.
    std::optional<Route> route(const Way& from, const Way& to, const std::vector<bool>& is_closed);

private:
    int node(const Way& way);

    std::span<const Pass> passes_;
    double same_;
    std::vector<SpacePoint> minima_;
    std::vector<std::array<int, 2>> ends_;
    std::vector<std::size_t> by_height_;
};

} // namespace isomotion::topology
