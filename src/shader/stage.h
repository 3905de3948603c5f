// The shader stage that marches rays. Fragment shaders draw everything else.
#pragma once

namespace isomotion::shader {

enum class Stage { fragment, compute };

// Side of the square work groups of compute shaders, in pixels: two warps of 32, or one wave of 64,
// whose rays are close together and so end after similar numbers of steps.
inline constexpr int workgroup_side = 8;

} // namespace isomotion::shader
