// Unresolved places that have one reason at one moment, together: a symmetric surface has dozens.
#pragma once

#include <string>
#include <vector>

#include "animation/timeline.h"
#include "topology/timeline/event.h"

namespace isomotion::topology {

struct UnresolvedGroup {
    formula::Interval time;                // the hull of theirs
    std::vector<const Unresolved*> places; // not empty; of one `why`
};

// The groups, ordered by time. Groups of one reason have times that don't touch.
std::vector<UnresolvedGroup> unresolved_groups(const Timeline& timeline);

// When, of a search from its first to its last frame.
enum class When { always, at_start, at_end, between };
When when(const UnresolvedGroup& group, const Timeline& timeline);

// "(0, 0.4, -1)"; what may be 0, or is nothing beside the others, is 0.
std::string place_text(const std::array<formula::Interval, 3>& where);
// "near (0, 0.4, -1)", "at 30 places, near (0, 0.4, -1), (0, 0.4, 1), ..."
std::string places_text(const UnresolvedGroup& group);

// What --frames takes to search without the moments of the groups: "2-120", "1-60 and 62-120".
// Empty if there is nothing unresolved but what lasts the whole time, or nothing is left.
std::string spans_beside(const std::vector<UnresolvedGroup>& groups, const Timeline& timeline,
                         animation::FrameRate fps);

} // namespace isomotion::topology
