// A moving surface and its bounds as expressions of x, y, z and one clock.
//
// The values of the animation become expressions in the formula, so that derivatives by the clock
// are derivatives of the formula. They are the real numbers that the scene's text states (constants
// folded in double), not the floats with which a frame is drawn.
//
// The clock is the time or, if everything moves by one track, that track. Then an animation that
// swings to and fro is searched only once, and a turn of the track, where everything rests, needs
// no special treatment. Where several tracks ease from keys to keys together, the clock is the part
// of the way that they have made.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "formula/evaluate/evaluate.h"
#include "formula/interval/interval.h"
#include "scene/scene.h"
#include "topology/field/easing.h"
#include "topology/field/solid.h"

namespace isomotion::topology {

inline constexpr int clock_input = 3; // of the graph; 0, 1, 2 are x, y, z
// Multipliers of kinks (kinks.h), if the field has any, are the inputs from here on.
inline constexpr int first_multiplier_input = 5;

struct Motion {
    formula::Graph graph;
    formula::NodeId field{}; // negative in the solid
    scene::Bounds::Shape shape = scene::Bounds::Shape::sphere;
    std::array<formula::NodeId, 3> low{}, high{}; // the box, or the box around the sphere
    std::array<formula::NodeId, 3> centre{};
    formula::NodeId radius{};
    formula::Bindings<double> bindings; // values for elements in the graph

    formula::Interval clock;
    std::optional<int> driver;    // the track that is the clock
    std::optional<Easing> easing; // where the clock is a part of the way between keys
    bool moves = true;
};

struct Motions {
    std::vector<Motion> pieces;   // one, or one between each two successive knots of the animation
    std::vector<double> jumps;    // times at which the surface is not continuous
    std::optional<Motion> at_end; // the surface after a jump at the end of the range
    // Spans of time in which the bounds may be empty. Ascending.
    std::vector<formula::Interval> collapses;
    std::vector<std::string> doubts; // properties that the expressions can't tell
};

enum class Clock { time, track_if_one };

// Adds a doubt for each operation of the motion that may step from one value to another: there is
// no derivative where it does.
void find_steps(const Motion& motion, std::vector<std::string>& doubts);
// Adds the spans of the clock in which one of these expressions, of the clock alone, may be 0 or
// less.
void find_not_positive(const formula::Graph& graph, std::span<const formula::NodeId> lengths,
                       formula::Interval clock, std::uint64_t seed,
                       std::vector<formula::Interval>& spans);
// Whether the solid or its bounds depend on the clock.
bool depends_on_clock(const Motion& motion);

// The clock of a piece, with what is in doubt of its ends: the time between two keys is rounded, so
// a rule comes to the value of its last key a little before or after that key. A root in between
// may be the next rule's, too.
formula::Interval with_ends_in_doubt(formula::Interval clock);

// The motions of the scene's surface while the time is in `range`.
Motions motions(const scene::OneSurface& one, Side side, formula::Interval range,
                Clock clock = Clock::track_if_one);

} // namespace isomotion::topology
