// Doubles rounded to floats, away from the value that they bound.
#pragma once

#include <cmath>

namespace isomotion::roots {

inline float below(double value) {
    const float rounded = float(value);
    return double(rounded) <= value ? rounded : std::nextafter(rounded, -HUGE_VALF);
}

inline float above(double value) {
    const float rounded = float(value);
    return double(rounded) >= value ? rounded : std::nextafter(rounded, HUGE_VALF);
}

} // namespace isomotion::roots
