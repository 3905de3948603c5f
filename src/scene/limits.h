// The largest scene that is read; formula/graph/limits.h has the limits of formulas. Scenes that
// people or programs write stay far below. A stranger's scene, or a slip of the pen, ends in a
// SceneError and not in a full memory or a program that hangs.
//
// docs/scene-file.md lists them for users.
#pragma once

#include <cstddef>

#include "formula/graph/limits.h"

namespace isomotion::scene::limits {

using formula::limits::name_bytes;

inline constexpr std::size_t scene_bytes = 16 << 20;  // of a scene file or a surface's
inline constexpr std::size_t table_bytes = 256 << 20; // of all tables of elements together
// Read whole to count the particles of an array's files, where no count is given.
inline constexpr std::size_t counted_bytes = 512 << 20;
inline constexpr std::size_t title_bytes = 1000;
inline constexpr int frames = 10'000'000;
inline constexpr int parameters = 1000; // fields with one value for all elements included
inline constexpr int keys = 100'000;    // of one track
inline constexpr int elements = 1'000'000;
inline constexpr int fields = 1000; // of an array; columns of a table
// Numbers that arrays keep of all tables together, eight bytes each.
inline constexpr double table_values = 3e7;
// The formula at one point, with all elements of its sums. All fields of all elements at one frame:
// how many they are, some 50 bytes each, and what they take.
inline constexpr double operations_at_a_point = 1e8;
inline constexpr double values_of_a_frame = 1e7;
inline constexpr double operations_of_a_frame = 2e8;
inline constexpr int lights = 8;
inline constexpr int sections = 8;
inline constexpr int glass_depth = 16; // rays of a pixel after the eye's
// A colour's parts and an environment's intensity: products of them stay floats.
inline constexpr double brightness = 1e6;
inline constexpr int picture_side = 16384; // pixels
inline constexpr int samples = 1024;
inline constexpr int bisections = 64;
inline constexpr int evaluations = 10'000'000; // of a ray: isolation.limit

} // namespace isomotion::scene::limits
