// Finds paths that join the two sides of an event elsewhere. They are sought along critical points
// at the event's own time, and proved.
//
// The components of {H < 0} are the minima below 0, joined by the saddles of index 1 below 0; each
// saddle joins the minima in which its two descent paths end (Morse). So the sides of an event are
// joined if its own two paths end in one minimum, or in two minima that other saddles join.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "topology/classify/parting.h"
#include "topology/field/timed_formula.h"

namespace isomotion::topology {

struct PathOptions {
    int threads = 1;                             // the result doesn't depend on it
    int effort = 0;                              // 0 to 2
    std::function<void(double part)> progress{}; // called from one thread at a time
    std::function<bool()> stopped{};             // from any thread
};

// Keeps the saddles of the motion that it has found, from call to call.
class EventPaths {
public:
    // Keeps a reference to the pieces. Events are ordered by time; an event whose time is not all
    // in one piece stays unknown.
    EventPaths(std::span<const TimedFormula> pieces, std::vector<Event> events);

    // Answers for the events at these positions.
    std::vector<Sides> seek(std::span<const std::size_t> which, const PathOptions& how);

private:
    struct Fields;
    struct Surface;

    const TimedFormula& piece_of(double time) const;
    std::vector<Surface> surfaces(std::span<const std::size_t> which) const;
    void follow_saddles(int index, const std::function<bool()>& stopped);
    Sides sides(Fields& fields, const Surface& surface, int effort,
                const std::function<bool()>& stopped) const;

    std::span<const TimedFormula> pieces_;
    std::vector<Event> events_;
    std::array<std::vector<std::vector<SpacePoint>>, 2> saddles_; // by index, then by event
    std::array<bool, 2> is_followed_{};
};

} // namespace isomotion::topology
