// Halton's low-discrepancy sequence: points that fill a cube evenly, the same on every machine.
#pragma once

namespace isomotion::scene {

// The index-th number, counted from 1, of the sequence of a prime base; in [0, 1).
inline double halton(int index, int base) {
    double result = 0, weight = 1;
    for (; index > 0; index /= base) {
        weight /= base;
        result += weight * (index % base);
    }
    return result;
}

} // namespace isomotion::scene
