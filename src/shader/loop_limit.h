// Limits on the loops of a shader.
#pragma once

namespace isomotion::shader {

// Total loop iterations that a shader may do. It is below the driver's 65535, at which loops end
// silently, by the iterations of the march itself.
inline constexpr double loop_iterations_per_pass = 60'000;

// Bounds of noise go through its cells, at most eight, and the eight corners of each
// (shaders/interval/noise.glsl). Each of these loops counts a turn more, its end.
inline constexpr int turns_of_noise_bounds = 8 * (1 + 9) + 1;

// The number of cells that a box may meet in a grid of elements; beyond it there are no bounds.
inline constexpr int most_cells_of_box = 12;

} // namespace isomotion::shader
