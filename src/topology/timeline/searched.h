// Finds the part of some frames that was not searched, where nothing is known.
#pragma once

#include <string>

#include "animation/timeline.h"
#include "formula/interval/interval.h"

namespace isomotion::topology {

// "frames 10.5 to 11 were not searched; searched were frames 11 to 41", or empty if all of them
// were. An infinite end of `asked` stands for that of the range (seconds); if `asked` is then
// empty, none of it was searched. The only tolerance is the rounding of frames.
std::string unsearched(formula::Interval asked, formula::Interval range, animation::FrameRate fps);

} // namespace isomotion::topology
