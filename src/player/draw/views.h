// Converts a picture's channels to colours for display.
//
// A raster is 8-bit RGBA, straight alpha, row by row, the top row first, as a texture or a PNG
// needs it. Views are pure functions of a frame's channels. Each documents the channels that it
// needs, and throws an image::ImageError without them. NaN has a colour of its own, so that no such
// pixel goes unnoticed.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "image/frame.h"
#include "player/model/view.h"
#include "render/renderer.h"
#include "shader/channel.h"

namespace isomotion::player {

// The channels that a view needs besides the colour.
std::vector<shader::Channel> channels_of(View view);

using Rgb = std::array<std::uint8_t, 3>;

struct Raster {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;

    bool operator==(const Raster&) const = default;
};

// The colours of a miss in the views of depth and normal, and of NaN.
inline constexpr Rgb nothing{20, 20, 28}, no_number{255, 0, 255};

// The picture: byte for byte what image::encode writes to an 8-bit PNG (opaque without A).
Raster shaded(const image::Frame& frame);

// Grey: white at the least finite depth, darker to far_grey at the largest. White if all depths are
// equal.
inline constexpr std::uint8_t far_grey = 56;
Raster depth(const image::Frame& frame);

// World x, y, z from -1 to 1 as red, green, blue from 0 to 255.
Raster normals(const image::Frame& frame);

// The least of 1, 2, 5, 10, 20, ... that at least 99 % of the pixels' evaluations do not exceed. As
// the end of a heat map it is affected neither by a few rays at the step limit nor by small changes
// from frame to frame.
double heat_end(const image::Frame& frame);
// The scenes' colour map "blue-yellow" from 0 to `end` (heat_end() if it is 0): the paper's Fig. 5.
// Larger numbers have its last colour.
Raster evaluations(const image::Frame& frame, double end = 0);
// The map itself, for a legend; u from 0 to 1.
Rgb heat(double u);

struct VerdictColour {
    render::Verdict verdict;
    Rgb colour;
};
// In the order of Verdict. Step limit and NaN have their colours of the picture.
const std::array<VerdictColour, 5>& verdict_colours();
Raster verdicts(const image::Frame& frame);
inline constexpr Rgb no_verdict{255, 0, 0}; // NaN

// Compares two pictures of one scene at one time, by two methods, ray by ray.
struct Difference {
    Raster raster;
    // Numbers of pixels: both hit, both miss, only one hits, other pairs of verdicts.
    std::int64_t both_hit = 0, both_miss = 0, only_first = 0, only_second = 0, other = 0;
    std::int64_t apart = 0;    // of those that both hit: further apart than depth_agrees
    double farthest_apart = 0; // of depths, relative to the extent of the depths
};
// Depths agree if they differ by less than this part of the extent of both pictures' depths.
inline constexpr double depth_agrees = 1e-6;
inline constexpr Rgb agree_hit{112, 112, 112}, agree_miss{40, 40, 40}, first_alone{226, 58, 46},
    second_alone{48, 110, 240}, other_pair{255, 0, 255}, far_apart{255, 214, 0};
// Agreement is grey. Pixels that only the first method hits are red, only the second blue.
// Differing depths go from grey to yellow with the logarithm of the difference, from depth_agrees
// to the whole extent. A zero gradient counts as a hit. Throws ImageError if the sizes differ.
Difference difference(const image::Frame& first, const image::Frame& second);

// The view of one frame with default settings. View::difference has none (ImageError).
Raster shown(View view, const image::Frame& frame);

} // namespace isomotion::player
