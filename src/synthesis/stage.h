// The shader stage that marches rays. Everything else is drawn by fragment shaders.
#pragma once

namespace isomotion::synthesis {

enum class Stage { fragment, compute };

// Work groups of compute shaders are squares of so many pixels a side: two warps of 32, or one wave
// of 64, whose rays lie close together and so end after similar numbers of turns.
inline constexpr int workgroup_side = 8;

} // namespace isomotion::synthesis
