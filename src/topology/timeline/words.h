// Topology in words, as used in summaries and differences.
#pragma once

#include <string>

#include "animation/timeline.h"
#include "topology/timeline/event.h"

namespace isomotion::topology {

// "74 merges", "1 tunnel forms", "68 tunnels form", "2 voids born"; Kind::unknown: "3 of unknown
// kind"; Kind::none: "2 on the bounds that change nothing".
std::string counted(std::int64_t number, Kind kind);
std::string plural(Kind kind); // "merges", "tunnels form"

// "3 components, 1 tunnel, 0 voids".
std::string in_words(const Betti& solid);

// "F > 0" for a solid where F is positive (1), "F < 0" for the other (-1).
std::string solid_text(int sign);

// Frames count from 1 and have fractions here: 1 + t * fps.
double frame_at(animation::FrameRate fps, double time);
formula::Interval frames_at(animation::FrameRate fps, formula::Interval time);
// "12.41", "12"; for an enclosure as many digits as are certain: "12.41", "12.3 to 12.6".
std::string frame_text(double frame);
std::string frame_text(formula::Interval frames);

// Reasons why a timeline is not complete, one each; empty if it is.
std::vector<std::string> gaps(const Timeline& timeline, animation::FrameRate fps);

} // namespace isomotion::topology
