// What of the frames that somebody speaks of was not searched: of that nothing is known.
#pragma once

#include <string>

#include "animation/timeline.h"
#include "formula/interval/interval.h"

namespace isomotion::topology {

// "frames 10.5 to 11 were not searched; searched were frames 11 to 41", or empty if all of them
// were. An infinite end of `asked` is the range's (seconds), and if nothing is left of `asked` by
// that, nothing of it was searched. Nothing is forgiven but how frames are rounded.
std::string unsearched(formula::Interval asked, formula::Interval range, animation::FrameRate fps);

} // namespace isomotion::topology
