// Events whose sides are joined elsewhere: paths sought along the critical points of the event's
// own time, and proved.
//
// The components of {H < 0} are the minima below 0, joined by the saddles of index 1 below 0, each
// of which joins those that its two descending paths end in (Morse). So the sides of an event are
// joined where its own two paths end in one minimum, or in two that other saddles join.
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

// Keeps what it found of the motion's saddles from call to call.
class EventPaths {
public:
    // Refers to the pieces. Events by time; of one that is not all in one piece nothing is known.
    EventPaths(std::span<const TimedFormula> pieces, std::vector<Event> events);

    // Answers for the events at these positions.
    std::vector<Sides> seek(std::span<const std::size_t> which, const PathOptions& how);

private:
    struct Fields;

    const TimedFormula& piece_of(double time) const;
    void follow_saddles(int index, const std::function<bool()>& stopped);
    Sides sides(Fields& fields, std::size_t event, int effort,
                const std::function<bool()>& stopped) const;

    std::span<const TimedFormula> pieces_;
    std::vector<Event> events_;
    std::array<std::vector<std::vector<SpacePoint>>, 2> saddles_; // by index, then by event
    std::array<bool, 2> is_followed_{};
};

} // namespace isomotion::topology
