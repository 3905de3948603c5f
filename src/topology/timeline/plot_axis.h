// The axis of frames that all parts of a plot share.
#pragma once

#include <algorithm>

namespace isomotion::topology {

struct PlotAxis {
    double first = 1, last = 2; // frames; first < last
    double left = 0, right = 1; // where these are in the picture

    double unit() const { return (right - left) / (last - first); } // of the picture, a frame
    double x(double frame) const { return left + (frame - first) * unit(); }
    // The same, with a frame outside moved to the nearer end.
    double clamped(double frame) const { return x(std::clamp(frame, first, last)); }
};

// 1, 2 or 5 times a power of ten, so that at most `most` of them are in the span.
double nice_step(double span, double most);

} // namespace isomotion::topology
