// The limits on scenes; formula/graph/limits.h has those on formulas. Real scenes stay far below
// them. A hostile scene or a typing mistake ends in a SceneError instead of exhausting memory or
// hanging the program.
//
// docs/scene-file.md lists the limits for users.
#pragma once

#include <cstddef>

#include "formula/graph/limits.h"

namespace isomotion::scene::limits {

using formula::limits::name_bytes;

inline constexpr std::size_t scene_bytes = 16 << 20;  // of a scene file or a surface's
inline constexpr std::size_t table_bytes = 256 << 20; // of all tables of elements together
// Files are read whole to count their particles if no count is given: so many bytes at most.
inline constexpr std::size_t counted_bytes = 512 << 20;
inline constexpr std::size_t title_bytes = 1000;
inline constexpr int frames = 10'000'000;
inline constexpr int parameters = 1000; // fields with one value for all elements included
inline constexpr int keys = 100'000;    // of one track
inline constexpr int elements = 1'000'000;
inline constexpr int fields = 1000; // of an array; columns of a table
// Numbers that arrays keep of all tables together, eight bytes each.
inline constexpr double table_values = 3e7;
// Work to evaluate the formula at one point with all elements of its sums. For all fields of all
// elements at one frame: their number, at some 50 bytes each, and the work to evaluate them.
inline constexpr double operations_at_a_point = 1e8;
inline constexpr double values_of_a_frame = 1e7;
inline constexpr double operations_of_a_frame = 2e8;
inline constexpr int lights = 8;
inline constexpr int sections = 8;
inline constexpr int glass_depth = 16; // rays of a pixel after the primary ray
inline constexpr int priority = 1000;  // of matter, above or below 0
// Limit of a colour's components and of an environment's intensity, so that products of them stay
// floats.
inline constexpr double brightness = 1e6;
inline constexpr double least_radius = 1e-18; // of bounds: the GPU squares it
inline constexpr int picture_side = 16384;    // pixels
inline constexpr int samples = 1024;
inline constexpr int bisections = 64;
inline constexpr int evaluations = 10'000'000; // evaluations of F per ray: isolation.limit

} // namespace isomotion::scene::limits
