// The points at which the pictures of a frame are sampled: in the pixel, on the lens, in time.
#pragma once

#include <vector>

#include "scene/rays.h"

namespace isomotion::render {

struct Sample {
    scene::Aim aim;  // pixel in [-1/2, 1/2)^2, lens in the closed unit disc
    double part = 0; // of the time in which the shutter is open, in [0, 1)
};

// `count` points of low discrepancy, always the same: a Hammersley set of (part, pixel, lens).
// Times are stratified, k / count. Pixel and lens are the first points of Sobol's sequence (best
// balanced for powers of two; for these the mean over the pixel is -1/2 by count in each
// direction), with Shirley and Chiu's concentric map from the square to the disc for the lens. The
// first point is the pixel's centre, the lens' centre and the shutter's opening.
std::vector<Sample> sample_pattern(int count);

} // namespace isomotion::render
