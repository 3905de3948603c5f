// Advice to users on settling more of a timeline.
#pragma once

#include <string>
#include <vector>

#include "animation/timeline.h"
#include "topology/timeline/event.h"

namespace isomotion::topology {

// Reasons why a search leaves a place unresolved: Unresolved::why.
namespace unresolved {
inline constexpr const char degenerate[] =
    "a critical point may be degenerate, or there may be several";
// These are told from numbers, and not proved.
inline constexpr const char along_curve[] =
    "the surface is singular, or nearly so, along a curve at this moment";
inline constexpr const char along_surface[] =
    "a part of the surface is singular, or nearly so, at all of its points at this moment";
inline constexpr const char lasting_point[] =
    "the surface has a singular point, or nearly one, that stays, as a node does";
inline constexpr const char lasting_curve[] =
    "the surface is singular, or nearly so, along a curve that stays, as where it crosses itself";
inline constexpr const char kink[] =
    "the formula has a kink (min, max, abs, sqrt at 0 or the like) where the surface may change";
inline constexpr const char kinks_meet[] =
    "kinks of the formula (min, max, abs, sqrt at 0, division by 0) may not be in general position "
    "where the surface changes";
inline constexpr const char on_edge[] = "a critical point is on the edge of the bounds";
inline constexpr const char index[] = "the index of a critical point is not certain";
inline constexpr const char touches_edge[] =
    "the surface touches an edge of the bounds from both sides";
inline constexpr const char rule_changes[] =
    "the surface is singular where the motion changes its rule or ends";
inline constexpr const char rests[] = "the surface rests, or nearly, where it is singular";
inline constexpr const char turns[] =
    "the motion turns, rests or ends where the surface is singular";
inline constexpr const char jumps[] = "the surface jumps from one shape to another";
inline constexpr const char no_bounds[] = "the bounds may be empty or turned inside out";
} // namespace unresolved

// How a timeline's doubts begin that say why an end is not known.
inline constexpr const char start_not_known[] = "the topology at the start is not known",
                            end_not_known[] = "the topology at the end is not known";

// One sentence for each kind of reason that the timeline has, the most frequent causes first, and
// last the spans of --frames beside all moments that are not resolved. Empty for a complete
// timeline.
std::vector<std::string> advice(const Timeline& timeline, animation::FrameRate fps);

} // namespace isomotion::topology
