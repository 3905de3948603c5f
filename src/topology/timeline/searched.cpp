#include "topology/timeline/searched.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "topology/timeline/words.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

// A frame that follows from seconds is off by a few units in the last place.
double rounding(double frame) { return 1e-14 * std::max(1.0, std::abs(frame)); }

bool is_below(double a, double b) { return a < b - rounding(b); }

// All digits that tell it from the range's end.
std::string frames_text(double from, double to) {
    return from == to ? fmt::format("frame {:.12g} was", from)
                      : fmt::format("frames {:.12g} to {:.12g} were", from, to);
}

} // namespace

std::string unsearched(Interval asked, Interval range, animation::FrameRate fps) {
    const double first = frame_at(fps, range.lo), last = frame_at(fps, range.hi);
    std::string missing;
    if (!std::isfinite(asked.lo) && std::isfinite(asked.hi) && !is_below(first, asked.hi)) {
        missing = fmt::format("frames before {:.12g} were", asked.hi);
    } else if (!std::isfinite(asked.hi) && std::isfinite(asked.lo) && !is_below(asked.lo, last)) {
        missing = fmt::format("frames after {:.12g} were", asked.lo);
    } else if (std::isfinite(asked.lo) && is_below(asked.lo, first)) {
        missing = frames_text(asked.lo, std::min(asked.hi, first));
    } else if (std::isfinite(asked.hi) && is_below(last, asked.hi)) {
        missing = frames_text(std::max(asked.lo, last), asked.hi);
    } else {
        return "";
    }
    return fmt::format("{} not searched; searched were frames {:.12g} to {:.12g}", missing, first,
                       last);
}

} // namespace isomotion::topology
